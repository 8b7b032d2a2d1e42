"""The code of the notebook runs as it stands; tests/documents has documents."""

import json
import pathlib
import unittest

import matplotlib
import numpy as np

matplotlib.use("Agg")

ROOT = pathlib.Path(__file__).resolve().parents[2]


class NotebookTest(unittest.TestCase):

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
