"""The code of docs/python.md and of the notebook runs as it stands."""

import json
import pathlib
import re
import unittest

import matplotlib
import meshes
import numpy as np

matplotlib.use("Agg")

ROOT = pathlib.Path(__file__).resolve().parents[2]


class DocumentationTest(unittest.TestCase):

    def run_blocks(self, path, names):
        text = (ROOT / path).read_text(encoding="utf-8")
        blocks = re.findall(r"^```python\n(.*?)^```$", text, re.M | re.S)
        self.assertTrue(blocks)
        for block in blocks:
            exec(compile(block, path, "exec"), names)
        return names

    def test_reference(self):
        vertices, faces = meshes.terrain(20)
        names = self.run_blocks("docs/python.md", {"V": vertices, "F": faces})
        self.assertEqual(names["d"].shape, (len(vertices),))
        self.assertEqual(names["D"].shape, (2, 3))

    def test_notebook(self):
        # Without Jupyter: pictures are drawn, but not shown.
        path = "python/examples/geodesic.ipynb"
        notebook = json.loads((ROOT / path).read_text(encoding="utf-8"))
        names = {}
        for cell in notebook["cells"]:
            if cell["cell_type"] == "code":
                exec(compile("".join(cell["source"]), path, "exec"), names)
        self.assertTrue(np.all(np.isinf(names["e"][names["wall"]])))
        self.assertEqual(names["near"].shape, (len(names["V"]),) * 2)


if __name__ == "__main__":
    unittest.main()
