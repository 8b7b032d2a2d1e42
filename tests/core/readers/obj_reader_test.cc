#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "absl/status/statusor.h"
#include "geodesic/read_mesh.h"
#include "tests/core/readers/soup_checks.h"

namespace geodesic {
namespace {

using test::ExpectRead;
using test::ExpectRefused;
using test::IsInvalidWith;
using ::testing::ElementsAre;
using ::testing::SizeIs;

absl::StatusOr<TriangleSoup> Read(std::string_view text) {
  return ReadMesh(text, MeshFormat::kObj);
}

// Four vertices, on lines 1 to 4.
const std::string kVertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";

TEST(ObjReaderTest, TakesEveryFormOfCorner) {
  const TriangleSoup soup = ExpectRead(
      Read(kVertices + "f 1 2 3\nf 1/7 2/8 3/9\nf 1//5 2//5 3//5\n"
                       "f 1/2/3 2/2/3 3/2/3\nf 1/ 2/ 3/\nf 1/-1/-2 2//-1 3\n"
                       "f +1 +2 +3\n"));
  EXPECT_THAT(soup.triangles, SizeIs(7));
  EXPECT_THAT(soup.triangles, testing::Each(Triangle{0, 1, 2}));
}

TEST(ObjReaderTest, NegativeReferencesCountBackFromTheLastVertex) {
  const TriangleSoup soup = ExpectRead(
      Read(kVertices + "f -4 -3 -2\nv 5 5 5\nf -1 -2 -5\nf 1 -1/-1/-1 2\n"));
  EXPECT_THAT(soup.triangles, ElementsAre(Triangle{0, 1, 2}, Triangle{4, 3, 0},
                                          Triangle{0, 4, 1}));
}

TEST(ObjReaderTest, FacesMayPrecedeTheirVertices) {
  const TriangleSoup soup = ExpectRead(Read("f 1 2 4\n" + kVertices));
  EXPECT_THAT(soup.triangles, ElementsAre(Triangle{0, 1, 3}));
}

TEST(ObjReaderTest, IgnoresEverythingElse) {
  const TriangleSoup soup = ExpectRead(
      Read("# f 1 1 1\nmtllib C:\\temp\\\no f 1 2 3\ng An f Three Things\n"
           "usemtl f\nvt 0 0\nvn 0 0 1\nvp 1\ns off\nl 1 2\np 1\n\n  \n"
           "# a path ends here: C:\\mesh\\\n" +
           kVertices + "  \tf 1 2 3 # not 4\nfo 1 2 3\nfoo\n"));
  EXPECT_THAT(soup.positions, SizeIs(4));
  EXPECT_THAT(soup.triangles, ElementsAre(Triangle{0, 1, 2}));
}

TEST(ObjReaderTest, WeightsAndColoursAreIgnoredWhateverTheyAre) {
  const TriangleSoup soup =
      ExpectRead(Read("v 1 2 3 nan nan nan\nv 4 5 6 1.0\nv 7 8 9 # origin\n"));
  EXPECT_THAT(soup.positions,
              ElementsAre(Point{1, 2, 3}, Point{4, 5, 6}, Point{7, 8, 9}));
}

TEST(ObjReaderTest, ABackslashContinuesAStatement) {
  const TriangleSoup soup = ExpectRead(
      Read("v 1 2 \\\n3\nv\\\r\n 0 0\\\r\n 0\nv 1 1 1\nf 1 \\\n 2\\\n 3\n"));
  EXPECT_THAT(soup.positions,
              ElementsAre(Point{1, 2, 3}, Point{0, 0, 0}, Point{1, 1, 1}));
  EXPECT_THAT(soup.triangles, ElementsAre(Triangle{0, 1, 2}));
  // The line after the continuation keeps its number.
  EXPECT_THAT(Read(kVertices + "f 1 \\\n2 \\\n3\nf 1 2\n"),
              IsInvalidWith("line 8: face 1 "));
  EXPECT_THAT(Read(kVertices + "f 1 2\\"), IsInvalidWith("line 5: face 0 "));
}

TEST(ObjReaderTest, EveryLineEndCounts) {
  EXPECT_THAT(Read("\xef\xbb\xbfv 0 0 0\r\n# b\r# c\n# d\n\rv x"),
              IsInvalidWith("line 6: vertex 1: 'x' "));
}

TEST(ObjReaderTest, MessagesNameLineAndElement) {
  ExpectRefused(
      MeshFormat::kObj,
      {{"v 0 0 0\n\nv 1 x 0\n", "line 3: vertex 1: 'x' is not a finite number"},
       {"v 0 0\n", "line 1: vertex 0 has 2 coordinates; 3 are needed"},
       {kVertices + "f 1 2 3\nf 1 2\n",
        "line 6: face 1 has 2 corners; at least 3 are needed"},
       {kVertices + "f\n",
        "line 5: face 0 has 0 corners; at least 3 are needed"},
       {kVertices + "f 1 2 -5\n",
        "line 5: face 0 names vertex -5, but only 4 vertices precede it"},
       {kVertices + "f 1 2 0\n",
        "line 5: face 0 names vertex 0, but OBJ counts from 1"},
       {kVertices + "f 1 2 3\nf 1 2 99\nf 1 2 7\n",
        "line 6: face 1 names vertex 99, but the file has only 4 vertices"},
       // Hostile bytes are escaped, long ones cut.
       {"v 0 \x1b[31m\xff 0\n",
        "line 1: vertex 0: '\\x1b[31m\\xff' is not a finite number"},
       {"v 0 " + std::string(100000, '9') + "x 0\n",
        "line 1: vertex 0: '" + std::string(40, '9') +
            "...' is not a finite number"}});
  for (const std::string corner :
       {"2.5", "1/a", "/2", "+", "-", "+-1", "1e3", "0x1",
        "9223372036854775808", "18446744073709551617"}) {
    ExpectRefused(MeshFormat::kObj,
                  {{kVertices + "f 1 " + corner + " 3\n",
                    "line 5: face 0: '" + corner +
                        "' is not a corner (v, v/vt, v//vn or v/vt/vn)"}});
  }
}

TEST(ObjReaderTest, ReferencesBeyond32BitsDoNotWrapAround) {
  for (const char* reference :
       {"4294967297", "-4294967297", "9223372036854775807",
        "-9223372036854775808"}) {
    EXPECT_THAT(Read(kVertices + "f 1 2 " + reference + "\n"),
                IsInvalidWith("line 5: face 0 names vertex"))
        << reference;
  }
}

TEST(ObjReaderTest, ALongPolygonOnOneLine) {
  std::string text = kVertices + "f";
  for (int i = 0; i < 100000; ++i) text += " 1";
  EXPECT_THAT(ExpectRead(Read(text)).triangles, SizeIs(99998));
}

}  // namespace
}  // namespace geodesic
