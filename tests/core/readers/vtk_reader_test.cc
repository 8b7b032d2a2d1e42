#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <string>

#include "geodesic/read_mesh.h"
#include "tests/core/readers/byte_writer.h"
#include "tests/core/readers/soup_checks.h"

namespace geodesic {
namespace {

using test::ByteWriter;
using test::ExpectRead;
using test::IsInvalidWith;
using ::testing::ElementsAre;

std::string Head(const std::string& encoding, const std::string& dataset,
                 const std::string& version = "3.0") {
  return "# vtk DataFile Version " + version + "\nanything\n" + encoding +
         "\nDATASET " + dataset + "\n";
}

absl::StatusOr<TriangleSoup> Read(const std::string& bytes) {
  return ReadMesh(bytes, MeshFormat::kVtk);
}

TEST(VtkReaderTest, DoublesAndOrderAreKept) {
  const TriangleSoup soup = ExpectRead(
      Read(Head("ASCII", "POLYDATA") +
           "POINTS 4 double\n0.1 0 0  1 0 0\n1 1 0\n9 9 9\n"
           "VERTICES 1 2\n1 3\nLINES 1 3\n2 0 1\n"
           "POLYGONS 1 4\n3 2 1 0\nPOINT_DATA 4\nSCALARS d double\n"));
  EXPECT_THAT(soup.positions, ElementsAre(Point{0.1, 0, 0}, Point{1, 0, 0},
                                          Point{1, 1, 0}, Point{9, 9, 9}));
  EXPECT_THAT(soup.triangles, ElementsAre(Triangle{2, 1, 0}));
}

TEST(VtkReaderTest, PolygonsAreFannedAndOtherCellsLeftOut) {
  const TriangleSoup soup =
      ExpectRead(Read(Head("ASCII", "UNSTRUCTURED_GRID") +
                      "POINTS 5 float\n0 0 0 1 0 0 1 1 0 0 1 0 2 2 2\n"
                      "CELLS 4 14\n2 0 1\n3 0 1 2\n4 0 1 2 3\n1 4\n"
                      "CELL_TYPES 4\n3\n5\n9\n1\n"));
  EXPECT_THAT(soup.triangles, ElementsAre(Triangle{0, 1, 2}, Triangle{0, 1, 2},
                                          Triangle{0, 2, 3}));
}

TEST(VtkReaderTest, VersionFiveHasOffsetsAndConnectivity) {
  ByteWriter file(std::endian::big);
  file.Text(Head("BINARY", "POLYDATA", "5.1"))
      .Text("FIELD FieldData 1\nwhen 2 1 int\n")
      .Put<int32_t>(7, 8)
      .Text("\nPOINTS 4 double\n");
  for (int i = 0; i < 4; ++i) file.Put<double>(i == 1, i == 2, 0.1 * i);
  file.Text("\nMETADATA\nINFORMATION 0\n\nPOLYGONS 3 7\n")
      .Text("OFFSETS vtktypeint64\n")
      .Put<int64_t>(0, 3, 7)
      .Text("\nCONNECTIVITY vtktypeint64\n")
      .Put<int64_t>(0, 1, 2, 0, 1, 2, 3)
      .Text("\n");
  const TriangleSoup soup = ExpectRead(Read(file.bytes()));
  EXPECT_EQ(soup.positions[3], (Point{0, 0, 0.1 * 3}));
  EXPECT_THAT(soup.triangles, ElementsAre(Triangle{0, 1, 2}, Triangle{0, 1, 2},
                                          Triangle{0, 2, 3}));
}

// Where the counts of a header are lies, nothing is allocated for them.
TEST(VtkReaderTest, MalformedFilesAreNamed) {
  const std::string poly = Head("ASCII", "POLYDATA");
  const std::string points = poly + "POINTS 3 float\n0 0 0 1 0 0 0 1 0\n";
  for (const auto& [bytes, part] :
       std::vector<std::pair<std::string, std::string>>{
           {Head("HEX", "POLYDATA"), "'HEX' is neither ASCII nor BINARY"},
           {Head("ASCII", "STRUCTURED_GRID"), "STRUCTURED_GRID, which is no"},
           {poly, "no POLYGONS and no CELLS"},
           {poly + "POINTS 4000000000000000000 float\n0 0 0\n",
            "points do not fit"},
           {poly + "POINTS 1 complex\n0 0 0\n", "'complex' is no known type"},
           {poly + "POINTS 1 float\n0 nan 0\nPOLYGONS 0 0\n",
            "point 0: a coordinate"},
           {points + "POLYGONS 1 99\n3 0 1 2\n", "99 numbers do not fit"},
           {points + "POLYGONS 1 4\n3 0 1 3\n",
            "cell 0 names vertex 3, but there are 3"},
           {points + "POLYGONS 1 4\n3 0 1 -1\n", "names vertex -1"},
           {points + "POLYGONS 1 3\n2 0 1\n", "cell 0 has 2 corners"},
           {points + "POLYGONS 1 4\n7 0 1 2\n", "beyond the section"},
           {points + "TRIANGLE_STRIPS 1 4\n3 0 1 2\n", "strips"},
           {points + "FIELD f 1\na 4000000000 4000000000 int\n",
            "does not fit"},
           {points + "NONSENSE\n", "'NONSENSE' begins no known section"}}) {
    EXPECT_THAT(Read(bytes), IsInvalidWith(part)) << bytes;
  }
  const std::string grid = Head("ASCII", "UNSTRUCTURED_GRID") +
                           "POINTS 4 float\n0 0 0 1 0 0 0 1 0 0 0 1\n";
  EXPECT_THAT(Read(grid + "CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\n"),
              IsInvalidWith("cell 0 has type 10"));
  EXPECT_THAT(Read(grid + "CELLS 1 5\n4 0 1 2 3\n"),
              IsInvalidWith("'CELL_TYPES' was expected"));
  const std::string five =
      Head("ASCII", "POLYDATA", "5.1") + "POINTS 3 float\n0 0 0 1 0 0 0 1 0\n";
  EXPECT_THAT(Read(five + "POLYGONS 2 3\nOFFSETS int\n0 4\nCONNECTIVITY int\n"
                          "0 1 2\n"),
              IsInvalidWith("its end in OFFSETS is out of range"));
  EXPECT_THAT(Read(five + "POLYGONS 2 3\nOFFSETS int\n1 3\nCONNECTIVITY int\n"
                          "0 1 2\n"),
              IsInvalidWith("the first of the OFFSETS is not 0"));
}

}  // namespace
}  // namespace geodesic
