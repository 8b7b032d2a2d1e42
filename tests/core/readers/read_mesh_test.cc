// What holds for the readers of all formats.

#include "geodesic/read_mesh.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/str_replace.h"
#include "tests/core/readers/byte_writer.h"
#include "tests/core/readers/soup_checks.h"
#include "tests/core/readers/vtp_writer.h"

namespace geodesic {
namespace {

using test::ByteWriter;
using test::ExpectRead;
using test::ExpectSound;
using test::IsInvalid;
using test::IsInvalidWith;
using test::VtpFormat;
using test::VtpOptions;
using test::VtpPiece;
using test::VtpWriter;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

struct Sample {
  std::string name;
  MeshFormat format;
  std::string bytes;
  // How many of the last bytes may be cut off without an error: line ends,
  // digits of the last number, names, what follows all numbers.
  size_t spare = 0;
  bool is_text = spare > 0;
};

std::string PlyHeader(std::string_view format) {
  return "ply\nformat " + std::string(format) +
         " 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
         "property float z\nproperty uchar red\nelement face 2\n"
         "property list uchar int vertex_indices\nend_header\n";
}

Sample BinaryPly(std::endian order) {
  const bool little = order == std::endian::little;
  ByteWriter file(order);
  file.Text(PlyHeader(little ? "binary_little_endian" : "binary_big_endian"));
  for (int i = 0; i < 4; ++i) {
    file.Put<float>(i == 1, i == 2, i == 3).Put<uint8_t>(200);
  }
  file.Put<uint8_t>(3).Put<int32_t>(0, 1, 2);
  file.Put<uint8_t>(4).Put<int32_t>(3, 2, 1, 0x00);
  return {little ? "PlyLittle" : "PlyBig", MeshFormat::kPly, file.bytes(), 0};
}

Sample BinaryStl() {
  ByteWriter file;
  file.Text(std::string(80, ' ')).Put<uint32_t>(3);
  for (int i = 0; i < 3; ++i) {
    file.Put<float>(0, 0, 1, 0, 0, 0, 1, 0, 0, i, 1, 1).Put<uint16_t>(0);
  }
  return {"StlBinary", MeshFormat::kStl, file.bytes(), 0};
}

Sample BinaryVtk() {
  ByteWriter file(std::endian::big);
  file.Text("# vtk DataFile Version 5.1\nt\nBINARY\nDATASET POLYDATA\n")
      .Text("POINTS 4 float\n");
  for (int i = 0; i < 4; ++i) file.Put<float>(i == 1, i == 2, i == 3);
  file.Text("\nPOLYGONS 3 7\nOFFSETS vtktypeint64\n")
      .Put<int64_t>(0, 3, 7)
      .Text("\nCONNECTIVITY vtktypeint64\n")
      .Put<int64_t>(0, 1, 2, 3, 2, 1, 0);
  return {"VtkBinary", MeshFormat::kVtk, file.bytes(), 0};
}

Sample BinaryGltf() {
  std::string scene = R"({"asset": {"version": "2.0"},
    "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0},
                                "indices": 1}]}],
    "accessors": [
      {"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
      {"bufferView": 1, "componentType": 5125, "count": 9, "type": "SCALAR"}],
    "bufferViews": [{"buffer": 0, "byteLength": 48},
                    {"buffer": 0, "byteOffset": 48, "byteLength": 36}],
    "buffers": [{"byteLength": 84}]})";
  scene.resize((scene.size() + 3) / 4 * 4, ' ');
  ByteWriter file;
  file.Text("glTF").Put<uint32_t>(2, 112 + scene.size(), scene.size());
  file.Text("JSON" + scene).Put<uint32_t>(84);
  file.Text(std::string("BIN\0", 4));
  for (int i = 0; i < 4; ++i) file.Put<float>(i == 1, i == 2, i == 3);
  file.Put<uint32_t>(0, 1, 2, 3, 2, 1, 3, 1, 0);
  return {"GltfBinary", MeshFormat::kGltf, file.bytes(), 0};
}

Sample Vtp(const VtpOptions& options) {
  std::string bytes = VtpWriter(options).Write(
      {{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}},
       {{{7, 7, 7}}, {}},
       {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{3, 2, 1, 0}}}});
  const bool is_text = options.format != VtpFormat::kAppendedRaw;
  if (!is_text) bytes.pop_back();  // a line end
  const size_t appended = bytes.rfind("\n</AppendedData>");
  const size_t spare =
      appended == bytes.npos ? size_t{is_text} : bytes.size() - appended;
  return {"Vtp" + test::NameOf(options), MeshFormat::kVtp, bytes, spare,
          is_text};
}

// Each has four vertices or more and three triangles.
std::vector<Sample> Samples() {
  const std::string rows = "0 0 0 9\n1 0 0 9\n0 1 0 9\n0 0 1 9\n";
  std::vector<Sample> samples = {
      {"Obj", MeshFormat::kObj,
       "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 4/1 3/1 2/1 -4//7\n",
       1000},
      {"Off", MeshFormat::kOff,
       "OFF\n4 2 0\n" + rows + "3 0 1 2\n4 3 2 1 0 255\n", 5},
      {"PlyAscii", MeshFormat::kPly,
       PlyHeader("ascii") + rows + "3 0 1 2\n4 3 2 1 0\n", 1},
      BinaryPly(std::endian::little),
      BinaryPly(std::endian::big),
      {"StlAscii", MeshFormat::kStl,
       "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
       "vertex 0 1 0\nendloop\nendfacet\nfacet\nouter loop\nvertex 0 0 1\n"
       "vertex 1 0 0\nvertex 0 1 0\nvertex 0 0.5 1\nendloop\nendfacet\n"
       "endsolid s\n",
       3},
      BinaryStl(),
      {"VtkAscii", MeshFormat::kVtk,
       "# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\n"
       "POINTS 4 float\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n"
       "CELLS 2 9\n3 0 1 2\n4 3 2 1 0\nCELL_TYPES 2\n5\n9\n",
       1},
      BinaryVtk(),
      BinaryGltf(),
  };
  for (const VtpOptions& options : test::AllVtpOptions()) {
    samples.push_back(Vtp(options));
  }
  return samples;
}

class EveryFormatTest : public testing::TestWithParam<Sample> {};

INSTANTIATE_TEST_SUITE_P(Formats, EveryFormatTest, testing::ValuesIn(Samples()),
                         [](const auto& parameter) {
                           return parameter.param.name;
                         });

TEST_P(EveryFormatTest, TheSampleIsRead) {
  const TriangleSoup soup =
      ExpectRead(ReadMesh(GetParam().bytes, GetParam().format));
  EXPECT_GE(soup.positions.size(), 4u);
  EXPECT_EQ(soup.triangles.size(), 3u);
}

TEST_P(EveryFormatTest, ATruncatedFileIsAnErrorOrSmaller) {
  const Sample& sample = GetParam();
  const TriangleSoup full = ExpectRead(ReadMesh(sample.bytes, sample.format));
  for (size_t size = 0; size < sample.bytes.size(); ++size) {
    // A copy of its own, so that AddressSanitizer sees reads past the end.
    const std::string start(sample.bytes, 0, size);
    const absl::StatusOr<TriangleSoup> soup = ReadMesh(start, sample.format);
    if (!soup.ok()) {
      EXPECT_EQ(soup.status().code(), absl::StatusCode::kInvalidArgument);
      EXPECT_FALSE(soup.status().message().empty());
      continue;
    }
    EXPECT_GE(size + sample.spare, sample.bytes.size()) << size;
    ExpectSound(*soup);
    EXPECT_LE(soup->positions.size(), full.positions.size());
    EXPECT_LE(soup->triangles.size(), full.triangles.size());
  }
}

TEST_P(EveryFormatTest, AChangedByteIsAnErrorOrASoundSoup) {
  const Sample& sample = GetParam();
  for (size_t at = 0; at < sample.bytes.size(); ++at) {
    for (const char byte : {'\0', '\xff', '\x7f', '\n', '\r', ' ', '-', '9',
                            '#', '\\', 'e', 'A', '<', '>', '"'}) {
      std::string bytes = sample.bytes;
      bytes[at] = byte;
      const absl::StatusOr<TriangleSoup> soup = ReadMesh(bytes, sample.format);
      if (soup.ok()) {
        ExpectSound(*soup);
      } else {
        EXPECT_TRUE(absl::IsInvalidArgument(soup.status())) << soup.status();
      }
    }
  }
}

TEST_P(EveryFormatTest, LimitsAreKeptAndNamed) {
  const Sample& sample = GetParam();
  const TriangleSoup full = ExpectRead(ReadMesh(sample.bytes, sample.format));
  const uint64_t vertices = full.positions.size();
  EXPECT_TRUE(ReadMesh(sample.bytes, sample.format,
                       {.max_vertices = vertices, .max_triangles = 3})
                  .ok());
  const absl::Status too_many_vertices =
      ReadMesh(sample.bytes, sample.format, {.max_vertices = vertices - 1})
          .status();
  EXPECT_TRUE(absl::IsResourceExhausted(too_many_vertices));
  EXPECT_THAT(std::string(too_many_vertices.message()),
              HasSubstr("limit of " + std::to_string(vertices - 1) +
                        " (max_vertices)"));
  for (const uint64_t limit : {0, 1, 2}) {
    const absl::Status too_many_triangles =
        ReadMesh(sample.bytes, sample.format, {.max_triangles = limit})
            .status();
    EXPECT_TRUE(absl::IsResourceExhausted(too_many_triangles));
    EXPECT_THAT(
        std::string(too_many_triangles.message()),
        HasSubstr("limit of " + std::to_string(limit) + " (max_triangles)"));
  }
}

TEST_P(EveryFormatTest, ForeignBytesAreCalledByTheirName) {
  for (const auto& [bytes, part] :
       std::initializer_list<std::pair<const char*, const char*>>{
           {"", "the file is empty"},
           {"\x1f\x8b\x08 and so on", "the bytes look like gzip, not "},
           {"\x1f\x8b\x08 and so on", ": decompress first"},
           {"PK\x03\x04 and so on", "the bytes look like zip, not "},
           {"\xfe\xff and so on", "the bytes look like UTF-16 text, not "},
           {"<!DOCTYPE html>\n<title>404", "the bytes look like HTML, not "}}) {
    EXPECT_THAT(ReadMesh(bytes, GetParam().format), IsInvalidWith(part));
  }
}

TEST_P(EveryFormatTest, AMeshOfAnotherFormatIsCalledByItsName) {
  for (const Sample& other : Samples()) {
    const absl::StatusOr<TriangleSoup> soup =
        ReadMesh(other.bytes, GetParam().format);
    EXPECT_EQ(soup.ok(), other.format == GetParam().format) << other.name;
    // The header of a binary STL says nothing.
    if (soup.ok() || other.name == "StlBinary") continue;
    std::string name;
    for (const char c : MeshFormatName(other.format)) name += c - 'a' + 'A';
    EXPECT_THAT(soup, IsInvalidWith("the bytes look like " + name + ", not "));
  }
}

TEST_P(EveryFormatTest, TakesEveryLineEnd) {
  const Sample& sample = GetParam();
  if (!sample.is_text) return;
  const TriangleSoup soup = ExpectRead(ReadMesh(sample.bytes, sample.format));
  for (const char* end : {"\r\n", "\r"}) {
    const std::string bytes = absl::StrReplaceAll(sample.bytes, {{"\n", end}});
    for (const size_t cut : {size_t{0}, std::string_view(end).size()}) {
      const TriangleSoup same = ExpectRead(
          ReadMesh(bytes.substr(0, bytes.size() - cut), sample.format));
      EXPECT_EQ(same.positions, soup.positions);
      EXPECT_EQ(same.triangles, soup.triangles);
    }
  }
}

// The same mesh in the formats that keep doubles and number their vertices.
std::vector<Sample> SameMesh() {
  const std::string vertices = "0.1 1e-300 -1e300\n9 9 9\n.5 5. +1\n1 2 3\n";
  const std::string header =
      " 1.0\nelement vertex 4\nproperty double x\nproperty double y\n"
      "property double z\nelement face 2\n"
      "property list uchar int vertex_indices\nend_header\n";
  std::vector<Sample> samples = {
      {"Obj", MeshFormat::kObj,
       "v " +
           absl::StrReplaceAll(
               vertices,
               {{"\n9", "\nv 9"}, {"\n.", "\nv ."}, {"\n1", "\nv 1"}}) +
           "f 2 1 3 4\nf 1 3 4\n"},
      {"Off", MeshFormat::kOff,
       "OFF\n4 2 0\n" + vertices + "4 1 0 2 3 1 0 0\n3 0 2 3\n"},
      {"PlyAscii", MeshFormat::kPly,
       "ply\nformat ascii" + header + vertices + "\n 4 1 0 2 3  \n3 0 2 3\n\n"},
  };
  for (const std::endian order : {std::endian::little, std::endian::big}) {
    const bool little = order == std::endian::little;
    ByteWriter file(order);
    file.Text(little ? "ply\nformat binary_little_endian"
                     : "ply\nformat binary_big_endian")
        .Text(header)
        .Put<double>(0.1, 1e-300, -1e300, 9, 9, 9, 0.5, 5, 1, 1, 2, 3)
        .Put<uint8_t>(4)
        .Put<int32_t>(1, 0, 2, 3)
        .Put<uint8_t>(3)
        .Put<int32_t>(0, 2, 3);
    samples.push_back(
        {little ? "PlyLittle" : "PlyBig", MeshFormat::kPly, file.bytes()});
  }
  return samples;
}

// Vertices that no face uses among them; polygons on a line, as all but one
// place are here, are fanned from their first corner.
TEST(ReadMeshTest, KeepsDoublesAndTheOrderOfTheFile) {
  for (const Sample& sample : SameMesh()) {
    SCOPED_TRACE(sample.name);
    const TriangleSoup soup = ExpectRead(ReadMesh(sample.bytes, sample.format));
    EXPECT_THAT(soup.positions,
                ElementsAre(Point{0.1, 1e-300, -1e300}, Point{9, 9, 9},
                            Point{0.5, 5, 1}, Point{1, 2, 3}));
    EXPECT_THAT(
        soup.triangles,
        ElementsAre(Triangle{1, 0, 2}, Triangle{1, 2, 3}, Triangle{0, 2, 3}));
  }
}

// An L of area 3 as one polygon, which begins at `first`. A fan from most
// corners would have an area of 4 or lie outside.
std::vector<Sample> Ells(int first) {
  const std::vector<Point> points = {{2, 0, 0}, {2, 1, 0}, {1, 1, 0},
                                     {1, 2, 0}, {0, 2, 0}, {0, 0, 0}};
  std::string places, obj, stl, corners;
  VtpPiece piece{.points = points, .polygons = {{}}};
  for (int i = 0; i < 6; ++i) {
    const auto text = [](const Point& p) {
      return absl::StrCat(p[0], " ", p[1], " ", p[2], "\n");
    };
    const int corner = (first + i) % 6;
    absl::StrAppend(&places, text(points[i]));
    absl::StrAppend(&obj, "v ", text(points[i]));
    absl::StrAppend(&stl, "vertex ", text(points[corner]));
    absl::StrAppend(&corners, " ", corner);
    piece.polygons[0].push_back(corner);
  }
  std::string obj_face = "f";
  for (const int64_t corner : piece.polygons[0]) {
    absl::StrAppend(&obj_face, " ", corner + 1);
  }
  return {
      // A face may come before its vertices.
      {"Obj", MeshFormat::kObj, obj_face + "\n" + obj},
      {"Off", MeshFormat::kOff, "OFF\n6 1 0\n" + places + "6" + corners},
      {"Ply", MeshFormat::kPly,
       "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\n"
       "property float y\nproperty float z\nelement face 1\n"
       "property list uchar int vertex_indices\nend_header\n" +
           places + "6" + corners},
      {"Stl", MeshFormat::kStl,
       "solid\nfacet\nouter loop\n" + stl + "endloop\nendfacet\nendsolid\n"},
      {"Vtk", MeshFormat::kVtk,
       "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\n"
       "POINTS 6 float\n" +
           places + "POLYGONS 1 7\n6" + corners + "\n"},
      {"Vtp", MeshFormat::kVtp, VtpWriter({}).Write({piece})},
  };
}

TEST(ReadMeshTest, PolygonsAreCutInsideThemselves) {
  for (int first = 0; first < 6; ++first) {
    for (const Sample& sample : Ells(first)) {
      SCOPED_TRACE(absl::StrCat(sample.name, " from ", first));
      const TriangleSoup soup =
          ExpectRead(ReadMesh(sample.bytes, sample.format));
      ASSERT_EQ(soup.triangles.size(), 4);
      double area = 0;
      for (const auto& [a, b, c] : soup.triangles) {
        const auto& [p, q, r] =
            std::tie(soup.positions[a], soup.positions[b], soup.positions[c]);
        const double twice =
            (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
        EXPECT_GT(twice, 0);
        area += twice / 2;
      }
      EXPECT_EQ(area, 3);
      EXPECT_EQ(soup.reading.crossing_polygons, 0);
    }
  }
}

TEST(ReadMeshTest, CrossingPolygonsAreCounted) {
  const TriangleSoup soup = ExpectRead(
      ReadMesh("v 0 0 0\nv 1 1 0\nv 1 0 0\nv 0 1 0\nf 1 3 4\nf 1 2 3 4\n",
               MeshFormat::kObj));
  EXPECT_EQ(soup.reading.crossing_polygons, 1);
  EXPECT_EQ(soup.reading.first_crossing_polygon, 1);
}

TEST(ReadMeshTest, AFileWithoutFacesIsNoError) {
  const std::string vertices =
      "ply\nformat ascii 1.0\nelement vertex 1\nproperty double x\n"
      "property double y\nproperty double z\n";
  for (const auto& [format, bytes, count] :
       {std::tuple{MeshFormat::kObj, std::string("v 0 0 0\n"), 1u},
        {MeshFormat::kObj, "# nothing\n", 0u},
        {MeshFormat::kOff, "OFF\n1 0 0\n0 0 0\n", 1u},
        {MeshFormat::kOff, "OFF\n0 0 0\n", 0u},
        {MeshFormat::kPly, vertices + "end_header\n0 0 0\n", 1u},
        {MeshFormat::kPly, vertices + "element face 0\nend_header\n0 0 0\n",
         1u},
        {MeshFormat::kStl, "solid\nendsolid\n", 0u},
        {MeshFormat::kVtk,
         "# vtk DataFile Version 5.1\nt\nASCII\nDATASET POLYDATA\n"
         "POINTS 1 float\n0 0 0\nPOLYGONS 0 0\nOFFSETS vtktypeint64\n"
         "CONNECTIVITY vtktypeint64\n",
         1u},
        {MeshFormat::kVtp,
         VtpWriter({.format = VtpFormat::kBinary, .is_compressed = true})
             .Write({{{{1, 2, 3}}, {}}, {{}, {}}}),
         1u}}) {
    const TriangleSoup soup = ExpectRead(ReadMesh(bytes, format));
    EXPECT_EQ(soup.positions.size(), count) << bytes;
    EXPECT_TRUE(soup.triangles.empty()) << bytes;
  }
}

TEST(ReadMeshTest, BinaryBytesAreNoObj) {
  EXPECT_THAT(ReadMesh(std::string("v 0 0 0\n\0\1\2", 11), MeshFormat::kObj),
              IsInvalid("byte 8 is zero: the bytes look like binary data, not "
                        "OBJ"));
}

TEST(ReadMeshTest, MemoryStaysWithinASmallFactorOfTheInput) {
  for (const Sample& sample : Samples()) {
    const TriangleSoup soup = ExpectRead(ReadMesh(sample.bytes, sample.format));
    EXPECT_LE(soup.positions.capacity() * sizeof(Point) +
                  soup.triangles.capacity() * sizeof(Triangle),
              8 * sample.bytes.size())
        << sample.name;
  }
}

TEST(MeshFormatTest, TheEndingOfAPathNamesTheFormat) {
  for (const auto& [path, format] :
       std::initializer_list<std::pair<const char*, MeshFormat>>{
           {"horse.ply", MeshFormat::kPly},
           {"a/b.PLY", MeshFormat::kPly},
           {"a.b/c.d.obj", MeshFormat::kObj},
           {"x.Off", MeshFormat::kOff},
           {"x.STL", MeshFormat::kStl},
           {"x.Glb", MeshFormat::kGltf},
           {"x.vtp.gz", MeshFormat::kVtp}}) {
    EXPECT_EQ(MeshFormatFromPath(path).value(), format);
    const std::string name(MeshFormatName(format));
    EXPECT_EQ(MeshFormatFromPath("x." + name).value(), format);
  }
}

TEST(MeshFormatTest, OtherPathsAreRefusedByName) {
  EXPECT_THAT(MeshFormatFromPath("mesh.fbx"), IsInvalidWith("mesh.fbx"));
  EXPECT_THAT(MeshFormatFromPath("mesh.fbx"), IsInvalidWith(".obj, .ply"));
  for (const char* path :
       {"", "ply", "a.ply/mesh", "mesh.", "mesh.gz", "a.ply.xz"}) {
    EXPECT_THAT(MeshFormatFromPath(path), IsInvalidWith("names no mesh format"))
        << path;
  }
}

}  // namespace
}  // namespace geodesic
