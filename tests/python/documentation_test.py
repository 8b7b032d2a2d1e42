"""The code of docs/python.md runs as it stands."""

import pathlib
import re
import unittest

import meshes

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


if __name__ == "__main__":
    unittest.main()
