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
using ::testing::ElementsAre;
using ::testing::SizeIs;

absl::StatusOr<TriangleSoup> Read(std::string_view text) {
  return ReadMesh(text, MeshFormat::kOff);
}

const std::string kBody = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n";

TEST(OffReaderTest, TakesEveryHeader) {
  for (const char* header :
       {"OFF\n4 2 0\n", "OFF\n4 2\n", "OFF 4 2 0\n", "OFF4 2 0\n",
        "OFF 4 2 # counts\n", "# c\n\nOFF # c\n# c\n\n  4\t2 5\n\n",
        "COFF\n4 2 0\n", "NOFF\n4 2 0\n", "CNOFF\n4 2 0\n", "STOFF\n4 2 0\n",
        "STCNOFF\n4 2 0\n", "\xef\xbb\xbfOFF\n4 2 0\n"}) {
    const TriangleSoup soup = ExpectRead(Read(header + kBody));
    EXPECT_THAT(soup.positions, SizeIs(4)) << header;
    EXPECT_THAT(soup.triangles,
                ElementsAre(Triangle{0, 1, 2}, Triangle{0, 2, 3}))
        << header;
  }
}

TEST(OffReaderTest, ColoursNormalsAndCommentsAreIgnored) {
  const TriangleSoup soup =
      ExpectRead(Read("STCNOFF\n4 2 5\n0 0 0  0 0 1  255 0 0 255  nan 1\n"
                      "# between\n1 0 0 0 0 1\n\n1 1 0 # corner\n0 1 0\n"
                      "3 0 1 2  1.0 0.5 0.25\n3 0 2 3 7 # seven\n# end\n\n"));
  EXPECT_THAT(soup.positions, SizeIs(4));
  EXPECT_THAT(soup.triangles,
              ElementsAre(Triangle{0, 1, 2}, Triangle{0, 2, 3}));
}

TEST(OffReaderTest, MessagesNameLineAndElement) {
  const std::string vertices = "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
  ExpectRefused(
      MeshFormat::kOff,
      {{"4OFF\n4 2 0\n" + kBody,
        "line 1: '4OFF' holds points that are not in 3-space"},
       {"nOFF\n3\n4 2 0\n" + kBody,
        "line 1: 'nOFF' holds points that are not in 3-space"},
       {"OFF BINARY\n\1\1\1",
        "line 1: binary OFF is not supported: save the mesh as ASCII OFF or as "
        "PLY"},
       {"4 2 0\n" + kBody, "line 1: '4' is no OFF header"},
       {"OFF\n4 x 0\n" + kBody,
        "line 2: '4 x' is not a count of vertices and of faces"},
       {"OFF\n4 -1 0\n" + kBody,
        "line 2: '4 -1' is not a count of vertices and of faces"},
       {"OFF\n4\n" + kBody,
        "line 2: '4 ' is not a count of vertices and of faces"},
       {"OFF\n4 2 0\n0 0 0\n1 inf 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n",
        "line 4: vertex 1: 'inf' is not a finite number"},
       {"OFF\n4 2 0\n0 0 0\n1 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n##",
        "line 4: vertex 1 has 2 coordinates; 3 are needed"},
       {vertices + "3 0 1 2\n2 0 1    \n",
        "line 8: face 1 has 2 corners; at least 3 are needed"},
       {vertices + "3 0 1 2\n3 0 1    \n",
        "line 8: face 1 names 2 of its 3 corners"},
       {vertices + "3 0 1 4\n3 0 2 3\n",
        "line 7: face 0 names vertex 4, but there are 4 vertices, counted from "
        "0"},
       {vertices + "3 0 1 -1\n3 0 2 3\n",
        "line 7: face 0 names vertex -1, but there are 4 vertices, counted "
        "from 0"},
       {vertices + "3 0 1 2.5\n3 0 2 3\n",
        "line 7: face 0: '2.5' is not a vertex number"},
       {vertices + "x 0 1 2\n3 0 2 3\n",
        "line 7: face 0: 'x' is not a count of corners"},
       {vertices + "3 0 1 2       \n",
        "line 7: the file ends before face 1 of 2"},
       {vertices + "3 0 1 2\n3 0 2 3\n3 1 2 3\n",
        "line 9: more than the 4 vertices and 2 faces that the header "
        "counts"}});
}

TEST(OffReaderTest, CountsThatCannotBeThereAreRefusedAtOnce) {
  ExpectRefused(
      MeshFormat::kOff,
      {{"OFF\n9223372036854775807 1 0\n0 0 0\n",
        "line 2: 9223372036854775807 vertices cannot fit the 6 bytes that "
        "follow"},
       {"OFF\n99999999999999999999 1 0\n0 0 0\n",
        "line 2: '99999999999999999999 1' is not a count of vertices and of "
        "faces"},
       // Times 6 it wraps around to 2.
       {"OFF\n3074457345618258603 0 0\n0 0 0\n",
        "line 2: 3074457345618258603 vertices cannot fit the 6 bytes that "
        "follow"},
       {"OFF\n1 9223372036854775807 0\n0 0 0\n",
        "line 2: 1 vertices and 9223372036854775807 faces cannot fit the 6 "
        "bytes that follow"},
       {"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n9223372036854775807 0 1 2",
        "line 6: face 0 names 3 of its 9223372036854775807 corners"}});
}

}  // namespace
}  // namespace geodesic
