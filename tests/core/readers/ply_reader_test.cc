#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
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
using test::IsInvalid;
using test::IsInvalidWith;
using test::Refusal;
using ::testing::ElementsAre;
using ::testing::SizeIs;

absl::StatusOr<TriangleSoup> Read(std::string_view bytes) {
  return ReadMesh(bytes, MeshFormat::kPly);
}

std::string Header(std::string_view format, std::string_view elements) {
  return "ply\nformat " + std::string(format) + " 1.0\n" +
         std::string(elements) + "end_header\n";
}

std::string_view FormatName(std::endian order) {
  return order == std::endian::little ? "binary_little_endian"
                                      : "binary_big_endian";
}

constexpr std::string_view kFourVertices =
    "element vertex 4\nproperty double x\nproperty double y\n"
    "property double z\n";
constexpr std::string_view kOneFace =
    "element face 1\nproperty list uchar int vertex_indices\n";

std::string FourAndOne() {
  return std::string(kFourVertices) + std::string(kOneFace);
}

class PlyBinaryTest : public testing::TestWithParam<std::endian> {
 protected:
  ByteWriter Begin(std::string_view elements) const {
    ByteWriter writer(GetParam());
    writer.Text(Header(FormatName(GetParam()), elements));
    return writer;
  }
};

INSTANTIATE_TEST_SUITE_P(ByteOrders, PlyBinaryTest,
                         testing::Values(std::endian::little, std::endian::big),
                         [](const auto& parameter) {
                           return std::string(
                               parameter.param == std::endian::little ? "Little"
                                                                      : "Big");
                         });

TEST_P(PlyBinaryTest, TakesPropertiesOfAnyTypeInAnyOrder) {
  ByteWriter file = Begin(
      "comment mixed\nobj_info x\nelement vertex 3\nproperty uchar red\n"
      "property short z\nproperty float32 nx\nproperty uint8 x\n"
      "property list uint16 double neighbours\nproperty float64 quality\n"
      "property float y\nelement face 2\nproperty ushort flags\n"
      "property list uint uint16 vertex_index\nproperty list char float uv\n");
  for (int i = 0; i < 3; ++i) {
    file.Put<uint8_t>(255).Put<int16_t>(-300 * i);
    file.Put<float>(std::nanf("")).Put<uint8_t>(200 + i);
    file.Put<uint16_t>(i);
    for (int k = 0; k < i; ++k) file.Put<double>(k);
    file.Put<double>(std::numeric_limits<double>::infinity());
    file.Put<float>(0.25f * i);
  }
  file.Put<uint16_t>(7).Put<uint32_t>(3).Put<uint16_t>(0, 1, 2);
  file.Put<int8_t>(2).Put<float>(0, 1);
  file.Put<uint16_t>(7).Put<uint32_t>(4).Put<uint16_t>(2, 1, 0, 1);
  file.Put<int8_t>(0);
  const TriangleSoup soup = ExpectRead(Read(file.bytes()));
  EXPECT_THAT(soup.positions,
              ElementsAre(Point{200, 0, 0}, Point{201, 0.25, -300},
                          Point{202, 0.5, -600}));
  EXPECT_THAT(soup.triangles, ElementsAre(Triangle{0, 1, 2}, Triangle{2, 1, 0},
                                          Triangle{2, 0, 1}));
}

TEST_P(PlyBinaryTest, SkipsOtherElementsWhereverTheyStand) {
  ByteWriter file = Begin(
      "element camera 2\nproperty float view\nproperty list uchar short path\n"
      "element nothing 99\n" +
      std::string(kOneFace) +
      "element edge 2\nproperty int a\nproperty int b\n" +
      std::string(kFourVertices) + "element extra 1\nproperty uchar a\n");
  file.Put<float>(1).Put<uint8_t>(2).Put<int16_t>(1, 2);
  file.Put<float>(1).Put<uint8_t>(0);
  file.Put<uint8_t>(3).Put<int32_t>(3, 2, 1);
  file.Put<int32_t>(0, 1, 1, 2);
  file.Put<double>(0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1);
  file.Put<uint8_t>(1);
  const TriangleSoup soup = ExpectRead(Read(file.bytes()));
  EXPECT_THAT(soup.positions, SizeIs(4));
  EXPECT_THAT(soup.triangles, ElementsAre(Triangle{3, 2, 1}));
}

TEST_P(PlyBinaryTest, MessagesNameByteAndElement) {
  const size_t start = Begin(FourAndOne()).bytes().size();
  const size_t faces_at = start + 12 * sizeof(double);
  const auto with_face = [&](int corners, int a, int b, int c, double y = 0) {
    return Begin(FourAndOne())
        .Put<double>(0, 0, 0, 1, y, 0, 0, 1, 0, 0, 0, 1)
        .Put<uint8_t>(corners)
        .Put<int32_t>(a, b, c)
        .bytes();
  };
  const auto at_byte = [](size_t byte, const std::string& what) {
    return "byte " + std::to_string(byte) + ": " + what;
  };
  ExpectRefused(
      MeshFormat::kPly,
      {{with_face(3, 0, 1, 2, std::nan("")),
        at_byte(start + 32, "vertex 1: coordinate y is not a finite number")},
       {with_face(3, 0, 99, 1),
        at_byte(faces_at + 5,
                "face 0 names vertex 99, but there are 4 vertices, counted "
                "from 0")},
       {with_face(3, 0, -1, 1),
        at_byte(faces_at + 5,
                "face 0 names vertex -1, but there are 4 vertices, counted "
                "from 0")},
       {with_face(2, 0, 1, 2),
        at_byte(faces_at, "face 0 has 2 corners; at least 3 are needed")},
       {with_face(255, 0, 1, 2),
        at_byte(faces_at,
                "face 0 has a list of 255 items of 4 bytes, but only 12 bytes "
                "are left")},
       {with_face(3, 0, 1, 2) + "more",
        at_byte(faces_at + 13, "4 bytes more than the header declares")}});
  EXPECT_THAT(ExpectRead(Read(with_face(3, 0, 1, 2) + "\r\n")).triangles,
              SizeIs(1));
}

// Times 4 or 12 the last one wraps around to 0.
const char* const kHugeCounts[] = {"1000", "2000000000", "9223372036854775807",
                                   "4611686018427387904"};

TEST_P(PlyBinaryTest, CountsThatCannotBeThereAreRefusedAtOnce) {
  for (const std::string count : kHugeCounts) {
    ByteWriter file = Begin("element vertex " + count +
                            "\nproperty float x\nproperty float y\n"
                            "property float z\n");
    const size_t at = file.bytes().size();
    file.Put<float>(0, 0, 0);
    EXPECT_THAT(Read(file.bytes()),
                IsInvalid("byte " + std::to_string(at) + ": " + count +
                          " rows of element vertex take at least 12 bytes "
                          "each, but only 12 bytes are left"));
    EXPECT_THAT(
        Read(Begin("element x " + count + "\nproperty list int int a\n" +
                   std::string(kFourVertices))
                 .bytes()),
        IsInvalidWith(count + " rows of element x"));
  }
  ExpectRefused(
      MeshFormat::kPly,
      {{Begin("element vertex 18446744073709551616\n").bytes(),
        "line 3: '18446744073709551616' is not a count of elements"}});
  // Lists whose bytes would overflow, or that run backwards.
  ByteWriter file =
      Begin("element x 1\nproperty list uint double a\n" + FourAndOne());
  file.Put<uint32_t>(4294967295u).Put<double>(0);
  EXPECT_THAT(Read(file.bytes()), IsInvalidWith("a list of 4294967295 items"));
  file = Begin("element x 1\nproperty list int double a\n" + FourAndOne());
  file.Put<int32_t>(-1).Put<double>(0);
  EXPECT_THAT(Read(file.bytes()), IsInvalidWith("x 0 has a list of length -1"));
}

TEST_P(PlyBinaryTest, AnyLineEndMayPrecedeTheBody) {
  // The first coordinate begins with the byte of a line feed in both orders.
  const double feed = std::bit_cast<double>(uint64_t{0x0a0000000000000a});
  for (const char* end : {"\n", "\r\n", "\r"}) {
    const ByteWriter with_line_feeds = Begin(FourAndOne());
    std::string header;
    for (const char c : with_line_feeds.bytes()) {
      header += c == '\n' ? std::string(end) : std::string(1, c);
    }
    ByteWriter file(GetParam());
    file.Text(header)
        .Put<double>(feed, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1)
        .Put<uint8_t>(3)
        .Put<int32_t>(0, 1, 2);
    const TriangleSoup soup = ExpectRead(Read(file.bytes()));
    ASSERT_THAT(soup.positions, SizeIs(4));
    EXPECT_EQ(soup.positions[0][0], feed);
    EXPECT_THAT(soup.triangles, ElementsAre(Triangle{0, 1, 2}));
  }
}

TEST(PlyAsciiTest, TakesPropertiesOfAnyTypeInAnyOrder) {
  const TriangleSoup soup = ExpectRead(Read(
      Header("ascii",
             "comment mixed\nelement camera 1\nproperty float view\n"
             "element vertex 4\nproperty uchar red\nproperty float z\n"
             "property list uchar int n\nproperty double x\nproperty int y\n"
             "element face 2\nproperty list uchar float uv\n"
             "property list uint uint vertex_index\nproperty uchar flag\n"
             "element nothing 7\n") +
      "nan\n255 0.1 0 1 2\nnan 0.2 2 7 8 3 4\n0 0 0 0 0\n0 0 1 7 1 1\n"
      "0 3 0 1 2 0\n2 0.5 nan 5 3 2 1 0 1 255\n"));
  EXPECT_THAT(soup.positions, ElementsAre(Point{1, 2, 0.1}, Point{3, 4, 0.2},
                                          Point{0, 0, 0}, Point{1, 1, 0}));
  // From corner 1 the second polygon goes to corner 0 and back.
  EXPECT_THAT(soup.triangles,
              ElementsAre(Triangle{0, 1, 2}, Triangle{1, 3, 1},
                          Triangle{3, 2, 1}, Triangle{1, 0, 1}));
}

TEST(PlyAsciiTest, MessagesNameLineAndElement) {
  const std::string header = Header("ascii", FourAndOne());  // 9 lines
  const std::string vertices = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
  ExpectRefused(
      MeshFormat::kPly,
      {{header + "0 0 0\n1 x 0\n0 1 0\n0 0 1\n3 0 1 2\n",
        "line 11: vertex 1: 'x' is not a finite number"},
       {header + "0 0 0\n1 0\n0 1 0\n0 0 1\n3 0 1 2\n",
        "line 11: vertex 1 ends within or before property z"},
       {header + "0 0 0\n1 0 0 5\n0 1 0\n0 0 1\n3 0 1 2\n",
        "line 11: vertex 1: '5' is more than the header declares"},
       {header + vertices + "3 0 1 4\n",
        "line 14: face 0 names vertex 4, but there are 4 vertices, "
        "counted from 0"},
       {header + vertices + "3 0 1 -1\n",
        "line 14: face 0 names vertex -1, but there are 4 vertices, "
        "counted from 0"},
       {header + vertices + "3 0 1    \n",
        "line 14: face 0 ends within or before property vertex_indices"},
       {header + vertices + "2 0 1    \n",
        "line 14: face 0 has 2 corners; at least 3 are needed"},
       {header + vertices + "3 0 1 1.5\n",
        "line 14: face 0: '1.5' is not a vertex number"},
       {header + vertices + "-3 0 1 1\n",
        "line 14: face 0: '-3' is not the length of a list"},
       {header + vertices + "          \n",
        "line 14: the file ends before face 0 of 1"},
       {header + vertices + "3 0 1 2\n3 1 2 3\n",
        "line 15: more rows than the header declares"}});
}

TEST(PlyAsciiTest, CountsThatCannotBeThereAreRefusedAtOnce) {
  for (const std::string count : kHugeCounts) {
    EXPECT_THAT(Read(Header("ascii", "element vertex " + count +
                                         "\nproperty float x\n"
                                         "property float y\n"
                                         "property float z\n") +
                     "0 0 0\n"),
                IsInvalid("line 3: " + count +
                          " rows of element vertex cannot fit the 6 bytes that "
                          "are left for them"));
  }
  // It says what was counted on.
  EXPECT_THAT(Read(Header("ascii", FourAndOne()) +
                   "0 0 0\n1 0 0\n0 1 0\n0 0 1\n2 0 1\n"),
              IsInvalidWith("1 rows of element face, of three corners or more, "
                            "cannot fit the 6 bytes"));
  EXPECT_THAT(Read(Header("ascii", FourAndOne()) +
                   "0 0 0\n1 0 0\n0 1 0\n0 0 1\n9223372036854775807 0 1 2\n"),
              IsInvalidWith("line 14: face 0 ends within"));
}

TEST(PlyHeaderTest, MessagesNameTheLine) {
  ExpectRefused(
      MeshFormat::kPly,
      {{"plyx\nformat ascii 1.0\nend_header\n",
        "line 1: the file does not begin with 'ply'"},
       {"ply\nformat ascii 1.0\nelement vertex 4\n",
        "line 3: the file ends before end_header"},
       {"ply\nformat binary 1.0\n", "line 2: unknown format 'binary'"},
       {"ply\nformat ascii 1.0\nformat ascii 1.0\n", "line 3: a second format"},
       {"ply\nelement vertex 0\nend_header\n",
        "line 3: the header names no format"},
       {"ply\nproperty float x\n", "line 2: a property before any element"},
       {"ply\nelement vertex\n", "line 2: '' is not a count of elements"},
       {"ply\nelement vertex -1\n", "line 2: '-1' is not a count of elements"},
       {"ply\nelement vertex 1\nproperty quad x\n",
        "line 3: unknown type 'quad'"},
       {"ply\nelement vertex 1\nproperty float\n",
        "line 3: a property without a name"},
       {"ply\nelement face 1\nproperty list float int a\n",
        "line 3: 'float' is not a type that can count a list"},
       {"ply\nelemnt vertex 1\n",
        "line 2: 'elemnt' is not a word of a PLY header"},
       {"ply\nformat ascii 1.0\nCreated by Blender3D 247\n"
        "element vertex 0\nend_header\n",
        "line 4: element vertex has no property x"}});
}

TEST(PlyHeaderTest, VerticesAndFacesMustBeWhatTheyClaim) {
  const std::string vertices(kFourVertices), face(kOneFace);
  const std::string x = "property float x\n", y = "property float y\n";
  const std::string no_list = " is not one list of whole numbers";
  for (const auto& [elements, message] : std::vector<Refusal>{
           {"element vertex 1\n" + x + y,
            "line 3: element vertex has no property z"},
           {"element vertex 1\n" + x + y + x,
            "line 3: vertex property x is not one single number"},
           {"element vertex 1\nproperty list uchar float x\n",
            "line 3: vertex property x is not one single number"},
           {"element face 0\n",
            "line 4: the header declares no element vertex"},
           {vertices + vertices, "line 7: a second element vertex"},
           {vertices + face + face, "line 9: a second element face"},
           {vertices + "element face 1\nproperty int a\n",
            "line 7: element face has no list vertex_indices or vertex_index"},
           {vertices + "element face 1\nproperty int vertex_indices\n",
            "line 7: face property vertex_indices" + no_list},
           {vertices +
                "element face 1\nproperty list uchar float vertex_index\n",
            "line 7: face property vertex_index" + no_list},
           {vertices + face + "property list uchar int vertex_index\n",
            "line 7: face property vertex_index" + no_list},
           {vertices +
                "element tristrips 1\nproperty list int int vertex_indices\n",
            "line 7: triangle strips are not supported: save the mesh with an "
            "element face"}}) {
    EXPECT_THAT(Read(Header("ascii", elements)), IsInvalid(message));
  }
}

}  // namespace
}  // namespace geodesic
