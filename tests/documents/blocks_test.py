"""What a document's blocks are, and that left_out.py names nothing that is gone."""

import pathlib
import unittest

import blocks
import left_out

ROOT = pathlib.Path(__file__).resolve().parents[2]


class BlocksTest(unittest.TestCase):

    def test_kinds(self):
        document = """Text with `a.cc`

    cd there
    ls \\
      -l

```
$ geodesic info
12
```
```cpp
int main() {}
```
| what | `geodesic info a`; `geodesic info b` | `other` |

    >>> 1 + 1
    2

- a list,
    which goes on
"""
        self.assertEqual(
            [(b.kind, b.line, b.text, b.file) for b in blocks.extract(document)],
            [("shell", 3, "cd there\nls \\\n  -l", ""),
             ("console", 8, "$ geodesic info\n12", ""),
             ("cpp", 12, "int main() {}", "a.cc"),
             ("shell", 14, "geodesic info a", ""),
             ("shell", 14, "geodesic info b", ""),
             ("pycon", 16, ">>> 1 + 1\n2", "")])

    def test_commands(self):
        self.assertEqual(list(blocks.commands("cd there\nls \\\n  -l\npwd")),
                         [(0, "cd there"), (1, "ls \\\n  -l"), (3, "pwd")])

    def test_a_fence_ends(self):
        with self.assertRaisesRegex(ValueError, "line 2: the fence"):
            blocks.extract("a\n```\nb")

    def test_all_that_is_left_out_is_there(self):
        found = [command for name in ("README.md", "docs/guide.md", "docs/python.md")
                 for block in blocks.extract((ROOT / name).read_text())
                 if block.kind == "shell"
                 for _, command in blocks.commands(block.text)]
        for start in {**left_out.ALWAYS, **left_out.ON_THIS_MACHINE}:
            self.assertTrue(any(c.startswith(start) for c in found), start)


if __name__ == "__main__":
    unittest.main()
