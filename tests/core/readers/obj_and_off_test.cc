// OBJ, OFF and the numbers in them.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "absl/status/statusor.h"
#include "geodesic/read_mesh.h"
#include "tests/core/readers/soup_checks.h"

namespace geodesic {
namespace {

using test::ExpectRead;
using test::ExpectRefused;
using test::IsInvalid;
using test::IsInvalidWith;
using ::testing::ElementsAre;
using ::testing::SizeIs;

absl::StatusOr<TriangleSoup> ReadObj(std::string_view text) {
  return ReadMesh(text, MeshFormat::kObj);
}

// Four vertices, on lines 1 to 4.
const std::string kVertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";

TEST(ObjReaderTest, TakesEveryFormOfCorner) {
  const TriangleSoup soup = ExpectRead(
      ReadObj(kVertices + "f 1 2 3\nf 1/7 2/8 3/9\nf 1//5 2//5 3//5\n"
                          "f 1/2/3 2/2/3 3/2/3\nf 1/ 2/ 3/\nf 1/-1/-2 2//-1 3\n"
                          "f +1 +2 +3\n"));
  EXPECT_THAT(soup.triangles, SizeIs(7));
  EXPECT_THAT(soup.triangles, testing::Each(Triangle{0, 1, 2}));
}

TEST(ObjReaderTest, NegativeReferencesCountBackFromTheLastVertex) {
  const TriangleSoup soup = ExpectRead(
      ReadObj(kVertices + "f -4 -3 -2\nv 5 5 5\nf -1 -2 -5\nf 1 -1/-1/-1 2\n"));
  EXPECT_THAT(soup.triangles, ElementsAre(Triangle{0, 1, 2}, Triangle{4, 3, 0},
                                          Triangle{0, 4, 1}));
}

TEST(ObjReaderTest, IgnoresEverythingElse) {
  const TriangleSoup soup = ExpectRead(
      ReadObj("# f 1 1 1\nmtllib C:\\temp\\\no f 1 2 3\ng An f Three Things\n"
              "usemtl f\nvt 0 0\nvn 0 0 1\nvp 1\ns off\nl 1 2\np 1\n\n  \n"
              "# a path ends here: C:\\mesh\\\n" +
              kVertices + "  \tf 1 2 3 # not 4\nfo 1 2 3\nfoo\n"));
  EXPECT_THAT(soup.positions, SizeIs(4));
  EXPECT_THAT(soup.triangles, ElementsAre(Triangle{0, 1, 2}));
}

TEST(ObjReaderTest, WeightsAndColoursAreIgnoredWhateverTheyAre) {
  const TriangleSoup soup = ExpectRead(
      ReadObj("v 1 2 3 nan nan nan\nv 4 5 6 1.0\nv 7 8 9 # origin\n"));
  EXPECT_THAT(soup.positions,
              ElementsAre(Point{1, 2, 3}, Point{4, 5, 6}, Point{7, 8, 9}));
}

TEST(ObjReaderTest, ABackslashContinuesAStatement) {
  const TriangleSoup soup = ExpectRead(
      ReadObj("v 1 2 \\\n3\nv\\\r\n 0 0\\\r\n 0\nv 1 1 1\nf 1 \\\n 2\\\n 3\n"));
  EXPECT_THAT(soup.positions,
              ElementsAre(Point{1, 2, 3}, Point{0, 0, 0}, Point{1, 1, 1}));
  EXPECT_THAT(soup.triangles, ElementsAre(Triangle{0, 1, 2}));
  // The line after the continuation keeps its number.
  EXPECT_THAT(ReadObj(kVertices + "f 1 \\\n2 \\\n3\nf 1 2\n"),
              IsInvalidWith("line 8: face 1 "));
  EXPECT_THAT(ReadObj(kVertices + "f 1 2\\"), IsInvalidWith("line 5: face 0 "));
}

TEST(ObjReaderTest, EveryLineEndCounts) {
  EXPECT_THAT(ReadObj("\xef\xbb\xbfv 0 0 0\r\n# b\r# c\n# d\n\rv x"),
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
    EXPECT_THAT(ReadObj(kVertices + "f 1 2 " + reference + "\n"),
                IsInvalidWith("line 5: face 0 names vertex"))
        << reference;
  }
}

TEST(ObjReaderTest, ALongPolygonOnOneLine) {
  std::string text = kVertices + "f";
  for (int i = 0; i < 100000; ++i) text += " 1";
  EXPECT_THAT(ExpectRead(ReadObj(text)).triangles, SizeIs(99998));
}

// A number as a coordinate of an OBJ; nothing where it is refused.
std::optional<double> ReadNumber(const std::string& token) {
  const auto soup = ReadObj("v 0 " + token + " 0\n");
  if (soup.ok()) return soup->positions.at(0)[1];
  EXPECT_THAT(soup, IsInvalid("line 1: vertex 0: '" + token +
                              "' is not a finite number"));
  return std::nullopt;
}

TEST(NumbersTest, AreCorrectlyRounded) {
  for (const auto& [token, value] :
       std::initializer_list<std::pair<std::string, double>>{
           {"0.1", 0.1},
           {"1e-300", 1e-300},
           {"9007199254740993", 9007199254740992.0},
           {"2.2250738585072011e-308", 2.2250738585072011e-308},
           {"1.7976931348623157e308", std::numeric_limits<double>::max()},
           // Just above the midpoint of 1 and the next double, by its 800th
           // digit.
           {"1.00000000000000011102230246251565404236316680908203125" +
                std::string(750, '0') + "1",
            std::nextafter(1.0, 2.0)},
           // Spellings of exporters.
           {"+1", 1},
           {".5", 0.5},
           {"-.5", -0.5},
           {"+5.", 5},
           {"2.e+1", 20},
           {"1E02", 100},
           // What is too small is 0 or subnormal.
           {"5e-324", 5e-324},
           {"1e-400", 0},
           {"-1e-99999", 0},
           {"0e99999", 0}}) {
    EXPECT_EQ(ReadNumber(token), value) << token;
  }
  EXPECT_TRUE(std::signbit(ReadNumber("-0").value()));
}

TEST(NumbersTest, EverythingElseIsRefused) {
  for (const char* token :
       {"+",        "-",     ".",      "+-1",    "++1",  "--1",
        "1e",       "1e+",   "3.1+e2", "1,5",    "1.0f", "1.0D5",
        "0x10",     "nan",   "NaN",    "-nan",   "inf",  "-inf",
        "infinity", "1e309", "-1e309", "1e99999"}) {
    EXPECT_EQ(ReadNumber(token), std::nullopt) << token;
  }
}

absl::StatusOr<TriangleSoup> ReadOff(std::string_view text) {
  return ReadMesh(text, MeshFormat::kOff);
}

const std::string kBody = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n";

TEST(OffReaderTest, TakesEveryHeader) {
  for (const char* header :
       {"OFF\n4 2 0\n", "OFF\n4 2\n", "OFF 4 2 0\n", "OFF4 2 0\n",
        "OFF 4 2 # counts\n", "# c\n\nOFF # c\n# c\n\n  4\t2 5\n\n",
        "COFF\n4 2 0\n", "NOFF\n4 2 0\n", "CNOFF\n4 2 0\n", "STOFF\n4 2 0\n",
        "STCNOFF\n4 2 0\n", "\xef\xbb\xbfOFF\n4 2 0\n"}) {
    const TriangleSoup soup = ExpectRead(ReadOff(header + kBody));
    EXPECT_THAT(soup.positions, SizeIs(4)) << header;
    EXPECT_THAT(soup.triangles,
                ElementsAre(Triangle{0, 1, 2}, Triangle{0, 2, 3}))
        << header;
  }
}

TEST(OffReaderTest, ColoursNormalsAndCommentsAreIgnored) {
  const TriangleSoup soup = ExpectRead(
      ReadOff("STCNOFF\n4 2 5\n0 0 0  0 0 1  255 0 0 255  nan 1\n"
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
