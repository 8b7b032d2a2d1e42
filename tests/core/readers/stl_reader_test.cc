#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "geodesic/read_mesh.h"
#include "tests/core/readers/byte_writer.h"
#include "tests/core/readers/soup_checks.h"

namespace geodesic {
namespace {

using test::ByteWriter;
using test::ExpectRead;
using test::ExpectRefused;
using test::IsInvalidWith;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

absl::StatusOr<TriangleSoup> Read(std::string_view bytes) {
  return ReadMesh(bytes, MeshFormat::kStl);
}

using Facet = std::array<std::array<float, 3>, 3>;

std::string Binary(std::string header, uint32_t count,
                   const std::vector<Facet>& facets) {
  header.resize(80, ' ');
  ByteWriter writer;
  writer.Text(header).Put<uint32_t>(count);
  for (const Facet& facet : facets) {
    writer.Put<float>(std::nanf(""), 0, 0);  // a normal nobody reads
    for (const auto& [x, y, z] : facet) writer.Put<float>(x, y, z);
    writer.Put<uint16_t>(0);
  }
  return writer.bytes();
}

// Two triangles that share an edge, one of them with -0 for 0.
const std::vector<Facet> kTwo = {{{{1, 0, 0}, {0, 1, 0}, {0, 0, 0}}},
                                 {{{0, 1, 0}, {1, -0.0f, 0}, {1, 1, 0.1f}}}};

std::string AsciiFacet(std::string_view corners) {
  return "facet normal 0 0 1\nouter loop\n" + std::string(corners) +
         "endloop\nendfacet\n";
}
const std::string kCorners = "vertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n";

TEST(StlReaderTest, WeldsEqualCoordinatesInOrderOfFirstAppearance) {
  const TriangleSoup soup = ExpectRead(Read(Binary("two", 2, kTwo)));
  EXPECT_THAT(soup.positions, ElementsAre(Point{1, 0, 0}, Point{0, 1, 0},
                                          Point{0, 0, 0}, Point{1, 1, 0.1f}));
  EXPECT_THAT(soup.triangles,
              ElementsAre(Triangle{0, 1, 2}, Triangle{1, 0, 3}));
}

TEST(StlReaderTest, NothingButEqualCoordinatesIsWelded) {
  const float next = std::nextafter(1.0f, 2.0f);
  const TriangleSoup soup = ExpectRead(
      Read(Binary("", 1, {{{{1, 0, 0}, {next, 0, 0}, {1, 0, 1e-45f}}}})));
  EXPECT_THAT(soup.positions, SizeIs(3));
}

TEST(StlReaderTest, SizeTellsABinaryFileThatBeginsWithSolid) {
  EXPECT_THAT(ExpectRead(Read(Binary("solid of sorts", 2, kTwo))).triangles,
              SizeIs(2));
  // Nor do magic numbers in the free header mislead.
  EXPECT_THAT(ExpectRead(Read(Binary("PK\x03\x04", 2, kTwo))).triangles,
              SizeIs(2));
}

TEST(StlReaderTest, ABinaryFileMayEndInPadding) {
  EXPECT_THAT(ExpectRead(Read(Binary("", 2, kTwo) + "\n")).triangles,
              SizeIs(2));
  EXPECT_THAT(ExpectRead(Read(Binary("", 0, {}))).triangles, IsEmpty());
}

TEST(StlReaderTest, ABinaryFileMustHoldWhatItPromises) {
  std::vector<Facet> infinite = kTwo;
  infinite[1][2][1] = std::numeric_limits<float>::infinity();
  ExpectRefused(
      MeshFormat::kStl,
      {{Binary("x", 3, kTwo),
        "byte 80: 3 faces take 234 bytes, but the file has 184"},
       {Binary("x", 1, kTwo),
        "byte 80: 1 faces take 134 bytes, but the file has 184"},
       {Binary("x", 4294967295, kTwo),
        "byte 80: 4294967295 faces take 214748364834 bytes, but the file has "
        "184"},
       {Binary("x", 2, infinite),
        "byte 174: face 1, corner 2: a coordinate is not a finite number"}});
  EXPECT_THAT(Read("neither"), IsInvalidWith("byte 7: "));
}

TEST(StlReaderTest, ReadsAsciiSolidsInAnyCase) {
  const TriangleSoup soup = ExpectRead(
      Read("solid facet vertex\n" + AsciiFacet(kCorners) +
           "endsolid facet vertex\n\nSOLID\nFacet Normal nan 0 1 Outer LOOP "
           "VERTEX 0.1 -0 1e-300\tVertex 1 0 0\rvertex 0 0 0 EndLoop "
           "ENDFACET\r\nendSolid\nsolid empty\nendsolid"));
  EXPECT_THAT(soup.positions,
              ElementsAre(Point{0, 0, 0}, Point{1, 0, 0}, Point{0, 1, 0},
                          Point{0.1, 0, 1e-300}));
  EXPECT_THAT(soup.triangles,
              ElementsAre(Triangle{0, 1, 2}, Triangle{3, 1, 0}));
}

TEST(StlReaderTest, AsciiMessagesNameLineAndFace) {
  const std::string one = "solid\n" + AsciiFacet(kCorners);
  ExpectRefused(
      MeshFormat::kStl,
      {{one + AsciiFacet("vertex 0 0 0\nvertex 1 0 0\n") + "endsolid\n",
        "line 13: face 1 has 2 corners; at least 3 are needed"},
       {one + AsciiFacet("vertex 0 0 nan\n"),
        "line 11: face 1, corner 0: 'nan' is not a finite number"},
       {one + "facet normal 0 0 1\nvertex 0 0 0\n",
        "line 10: face 1: 'outer' was expected, not 'vertex'"},
       {one, "line 8: the file ends at face 1, where 'endsolid' was expected"},
       {one + "endsolid\njunk\n",
        "line 10: face 1: 'solid' was expected, not 'junk'"}});
}

}  // namespace
}  // namespace geodesic
