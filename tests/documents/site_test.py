"""The site's pages: what headers and protos declare, and links."""

import pathlib
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "docs" / "site"))
import build
import declarations

HEADER = """// About the file.

#ifndef A_H_
#define A_H_
#include <vector>
namespace a {

class Later;

// Adds.
inline int Add(int x, int y = {}) {
  return x + y;
}

struct Bare {
  int x = 0;
};

// Counts.
class Counter {
 public:
  Counter();
  // Both tell it.
  int count() const { return count_; }
  int total() const;

  void Reset();

 private:
  void Hide();
  int count_ = 0;
};

}  // namespace a
#endif
"""


class SiteTest(unittest.TestCase):

    def test_headers(self):
        intro, blocks, undocumented = declarations.read(HEADER)
        self.assertEqual(intro, ["About the file."])
        self.assertEqual([names for names, _, _ in blocks],
                         [["Add"], ["Bare"], ["Counter"]])
        self.assertEqual(blocks[0][1:], (["Adds."], ["inline int Add(int x, int y = {});"]))
        self.assertEqual(undocumented, ["Bare", "Reset"])
        counter = "\n".join(blocks[2][2])
        self.assertIn("int count() const;", counter)
        self.assertNotIn("Hide", counter)

    def test_protos(self):
        _, blocks, undocumented = declarations.read(
            'syntax = "proto3";\n\n// Asks.\nservice S {\n  // Gets.\n'
            "  rpc Get(GetRequest) returns (GetResponse);\n\n"
            "  rpc Put(PutRequest) returns (PutResponse);\n}\n\n"
            "message GetRequest {\n  int32 a = 1;\n}\n\nmessage Thing {\n}\n")
        self.assertEqual([names for names, _, _ in blocks],
                         [["S"], ["GetRequest"], ["Thing"]])
        self.assertEqual(undocumented, ["Put", "Thing"])

    def test_links(self):
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            pages = {pathlib.Path("core/include/geodesic/solve.h"): "reference/core/solve"}
            build.put_document(pathlib.Path("docs/guide.md"), folder, pages)
            text = (folder / "docs/guide.md").read_text(encoding="utf-8")
            self.assertIn("[solve.h](../reference/core/solve.md)", text)
            self.assertIn("[questions.md](questions.md)", text)
            self.assertNotIn("](../examples)", text)
            self.assertTrue((folder / "docs/images/page.png").exists())

    def test_all_links_lead_somewhere(self):
        with tempfile.TemporaryDirectory() as folder:
            for document in build.documents():
                build.put_document(document, pathlib.Path(folder), {})
        self.assertEqual(build.errors, [])


if __name__ == "__main__":
    unittest.main()
