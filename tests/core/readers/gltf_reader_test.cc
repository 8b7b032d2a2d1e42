#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <string>
#include <utility>

#include "absl/strings/escaping.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/str_replace.h"
#include "geodesic/read_mesh.h"
#include "tests/core/readers/byte_writer.h"
#include "tests/core/readers/soup_checks.h"

namespace geodesic {
namespace {

using test::ByteWriter;
using test::ExpectRead;
using test::IsInvalidWith;
using ::testing::ElementsAre;
using ::testing::SizeIs;

absl::StatusOr<TriangleSoup> Read(const std::string& bytes) {
  return ReadMesh(bytes, MeshFormat::kGltf);
}

// A .glb of a scene and the bytes of its buffer.
std::string Glb(std::string scene, const std::string& binary) {
  scene.resize((scene.size() + 3) / 4 * 4, ' ');
  ByteWriter file;
  file.Text("glTF")
      .Put<uint32_t>(2, 28 + scene.size() + binary.size())
      .Put<uint32_t>(scene.size())
      .Text("JSON" + scene)
      .Put<uint32_t>(binary.size())
      .Text(std::string("BIN\0", 4) + binary);
  return file.bytes();
}

// Two triangles over a unit square, in one primitive with a seam along their
// diagonal: vertices 0 and 3 lie at one place, 2 and 5 at another.
std::string SquareBytes() {
  ByteWriter buffer;
  buffer.Put<float>(0, 0, 0, 1, 0, 0, 1, 1, 0);
  buffer.Put<float>(0, 0, 0, 0, 1, 0, 1, 1, 0);
  buffer.Put<uint16_t>(0, 1, 2, 3, 5, 4);
  return buffer.bytes();
}

constexpr char kSquare[] = R"({
  "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
  "nodes": [{"mesh": 0}],
  "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
  "accessors": [
    {"bufferView": 0, "componentType": 5126, "count": 6, "type": "VEC3"},
    {"bufferView": 1, "componentType": 5123, "count": 6, "type": "SCALAR"}],
  "bufferViews": [{"buffer": 0, "byteLength": 72},
                  {"buffer": 0, "byteOffset": 72, "byteLength": 12}],
  "buffers": [{"byteLength": 84}]})";

// The square with a part of its scene replaced.
std::string Square(const std::string& old_part = "",
                   const std::string& new_part = "") {
  std::string scene = kSquare;
  if (!old_part.empty()) {
    EXPECT_EQ(absl::StrReplaceAll({{old_part, new_part}}, &scene), 1);
  }
  return Glb(std::move(scene), SquareBytes());
}

TEST(GltfReaderTest, SeamsAreJoinedAndVerticesKeepTheirNumbers) {
  const TriangleSoup soup = ExpectRead(Read(Square()));
  EXPECT_THAT(soup.positions,
              ElementsAre(Point{0, 0, 0}, Point{1, 0, 0}, Point{1, 1, 0},
                          Point{0, 0, 0}, Point{0, 1, 0}, Point{1, 1, 0}));
  EXPECT_THAT(soup.triangles,
              ElementsAre(Triangle{0, 1, 2}, Triangle{3, 5, 4}));
  EXPECT_THAT(soup.reading.joined,
              ElementsAre(JoinedVertex{3, 0}, JoinedVertex{5, 2}));
}

TEST(GltfReaderTest, BuffersMayStandInTheText) {
  std::string scene = kSquare;
  absl::StrReplaceAll(
      {{R"({"byteLength": 84})",
        absl::StrCat(R"({"byteLength": 84, "uri":)",
                     R"("data:application/octet-stream;base64,)",
                     absl::Base64Escape(SquareBytes()), "\"}")}},
      &scene);
  EXPECT_THAT(ExpectRead(Read(scene)).triangles, SizeIs(2));
}

TEST(GltfReaderTest, NodesPlaceWhatIsInThem) {
  // Half a turn about z, twice as wide along x, moved; in a parent that moves
  // it again.
  const TriangleSoup soup = ExpectRead(Read(Square(
      R"("nodes": [{"mesh": 0}])",
      R"("nodes": [{"children": [1], "matrix": [1,0,0,0, 0,1,0,0, 0,0,1,0,
                                                100,0,0,1]},
                   {"mesh": 0, "rotation": [0, 0, 1, 0], "scale": [2, 1, 1],
                    "translation": [10, 20, 30]}])")));
  EXPECT_THAT(
      soup.positions,
      ElementsAre(Point{110, 20, 30}, Point{108, 20, 30}, Point{108, 19, 30},
                  Point{110, 20, 30}, Point{110, 19, 30}, Point{108, 19, 30}));
}

TEST(GltfReaderTest, AMeshMayStandInSeveralPlaces) {
  const TriangleSoup soup = ExpectRead(Read(
      Glb(absl::StrReplaceAll(
              kSquare, {{R"("nodes": [{"mesh": 0}])",
                         R"("nodes": [{"mesh": 0},
                             {"mesh": 0, "translation": [1, 0, 0]}])"},
                        {R"([{"nodes": [0]}])", R"([{"nodes": [0, 1]}])"}}),
          SquareBytes())));
  EXPECT_THAT(soup.positions, SizeIs(12));
  EXPECT_THAT(soup.triangles, SizeIs(4));
  // They share a side, and each has a diagonal.
  EXPECT_EQ(soup.reading.seam_edges, 3u);
}

// A triangle with its right angle at 0, and these instances of it.
std::string Instanced(const std::string& attributes) {
  ByteWriter buffer;
  buffer.Put<float>(0, 0, 0, 1, 0, 0, 0, 1, 0);
  buffer.Put<float>(0, 0, 0, 10, 0, 0);                 // translations
  buffer.Put<int16_t>(0, 0, 0, 32767, 0, 0, 32767, 0);  // half a turn about z
  buffer.Put<float>(1, 1, 1, 2, 3, 1);                  // scales
  return Glb(absl::StrCat(R"({"asset": {"version": "2.0"},
    "extensionsRequired": ["EXT_mesh_gpu_instancing"],
    "scenes": [{"nodes": [0]}],
    "nodes": [{"mesh": 0, "translation": [0, 0, 5],
      "extensions": {"EXT_mesh_gpu_instancing": {"attributes": {)",
                          attributes, R"(}}}}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
    "accessors": [
      {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
      {"bufferView": 1, "componentType": 5126, "count": 2, "type": "VEC3"},
      {"bufferView": 2, "componentType": 5122, "count": 2, "type": "VEC4",
       "normalized": true},
      {"bufferView": 3, "componentType": 5126, "count": 2, "type": "VEC3"}],
    "bufferViews": [{"buffer": 0, "byteLength": 36},
      {"buffer": 0, "byteOffset": 36, "byteLength": 24},
      {"buffer": 0, "byteOffset": 60, "byteLength": 16},
      {"buffer": 0, "byteOffset": 76, "byteLength": 24}],
    "buffers": [{"byteLength": 100}]})"),
             buffer.bytes());
}

TEST(GltfReaderTest, InstancesStandWhereTheirNodePutsThem) {
  const Point at0 = {0, 0, 5}, x1 = {1, 0, 5}, y1 = {0, 1, 5};
  // The second is scaled to 2 by 3, turned by half, shifted by 10, and then
  // raised by the node as both are.
  EXPECT_THAT(ExpectRead(Read(Instanced(
                             R"("TRANSLATION": 1, "ROTATION": 2, "SCALE": 3)")))
                  .positions,
              ElementsAre(at0, x1, y1, Point{10, 0, 5}, Point{8, 0, 5},
                          Point{10, -3, 5}));
  const TriangleSoup soup =
      ExpectRead(Read(Instanced(R"("TRANSLATION": 1, "_ID": 9)")));
  EXPECT_THAT(soup.positions, ElementsAre(at0, x1, y1, Point{10, 0, 5},
                                          Point{11, 0, 5}, Point{10, 1, 5}));
  EXPECT_THAT(soup.triangles,
              ElementsAre(Triangle{0, 1, 2}, Triangle{3, 4, 5}));
}

TEST(GltfReaderTest, BadInstancesAreNamed) {
  EXPECT_THAT(Read(Instanced(R"("_ID": 1)")),
              IsInvalidWith("node 0: its instances have no TRANSLATION"));
  EXPECT_THAT(Read(Instanced(R"("TRANSLATION": 0, "SCALE": 3)")),
              IsInvalidWith("node 0: its instances have 3 and 2 places"));
  EXPECT_THAT(Read(Instanced(R"("ROTATION": 1)")),
              IsInvalidWith("node 0: instances: accessor 1 is not of type "
                            "VEC4"));
  EXPECT_THAT(Read(Instanced(R"("TRANSLATION": 7)")),
              IsInvalidWith("node 0: instances: there is no accessor 7"));
}

TEST(GltfReaderTest, SkinsAndMorphsAreNotLeftOutSilently) {
  EXPECT_THAT(Read(Square("{\"mesh\": 0}", "{\"mesh\": 0, \"skin\": 0}")),
              IsInvalidWith("node 0 has a skin, which is not read"));
  EXPECT_THAT(
      Read(Square("{\"mesh\": 0}", "{\"mesh\": 0, \"weights\": [0, 0.5]}")),
      IsInvalidWith("node 0 has a mesh whose morph targets have weights"));
  EXPECT_THAT(
      Read(Square("[{\"primitives\"", "[{\"weights\": [1], \"primitives\"")),
      IsInvalidWith("node 0 has a mesh whose morph targets have weights"));
  // The node's count, if there are any.
  std::string scene = kSquare;
  absl::StrReplaceAll(
      {{"[{\"primitives\"", "[{\"weights\": [1], \"primitives\""},
       {"{\"mesh\": 0}", "{\"mesh\": 0, \"weights\": [0]}"}},
      &scene);
  EXPECT_THAT(ExpectRead(Read(Glb(scene, SquareBytes()))).triangles, SizeIs(2));
}

TEST(GltfReaderTest, StripsAndFansBecomeTriangles) {
  const auto read_apart = [](const std::string& bytes) {
    return ExpectRead(ReadMesh(bytes, MeshFormat::kGltf,
                               {.welding = {.kind = Welding::Kind::kNone}}));
  };
  const std::string mode = R"("indices": 1})";
  EXPECT_THAT(read_apart(Square(mode, R"("indices": 1, "mode": 5})")).triangles,
              ElementsAre(Triangle{0, 1, 2}, Triangle{1, 3, 2},
                          Triangle{2, 3, 5}, Triangle{3, 4, 5}));
  EXPECT_THAT(read_apart(Square(mode, R"("indices": 1, "mode": 6})")).triangles,
              ElementsAre(Triangle{0, 1, 2}, Triangle{0, 2, 3},
                          Triangle{0, 3, 5}, Triangle{0, 5, 4}));
  EXPECT_THAT(read_apart(Square(mode, R"("indices": 1, "mode": 1})")).triangles,
              SizeIs(0));
}

TEST(GltfReaderTest, QuantizedCoordinatesAreRead) {
  ByteWriter buffer;
  buffer.Put<int16_t>(0, 0, 0, 0, 32767, 0, 0, 0, 0, -32767, 16384, 0);
  const std::string scene = R"({"asset": {"version": "2.0"},
    "extensionsRequired": ["KHR_mesh_quantization"],
    "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
    "accessors": [{"bufferView": 0, "componentType": 5122, "count": 3,
                   "normalized": true, "type": "VEC3"}],
    "bufferViews": [{"buffer": 0, "byteLength": 24, "byteStride": 8}],
    "buffers": [{"byteLength": 24}]})";
  EXPECT_THAT(ExpectRead(Read(Glb(scene, buffer.bytes()))).positions,
              ElementsAre(Point{0, 0, 0}, Point{1, 0, 0},
                          Point{0, -1, 16384 / 32767.0}));
}

TEST(GltfReaderTest, BadScenesAreNamed) {
  EXPECT_THAT(Read(Square("5126", "5130")), IsInvalidWith("accessor 0"));
  EXPECT_THAT(Read(Square("5123", "5126")), IsInvalidWith("accessor 1"));
  EXPECT_THAT(Read(Square("\"count\": 6, \"type\": \"VEC3\"",
                          "\"count\": 7, \"type\": \"VEC3\"")),
              IsInvalidWith("accessor 0 lies outside its bufferView"));
  EXPECT_THAT(Read(Square("\"count\": 6, \"type\": \"VEC3\"",
                          "\"count\": 5, \"type\": \"VEC3\"")),
              IsInvalidWith("corner 4 names vertex 5, but there are 5"));
  EXPECT_THAT(Read(Square("\"count\": 6, \"type\": \"SCALAR\"",
                          "\"count\": 5, \"type\": \"SCALAR\"")),
              IsInvalidWith("5 corners are no whole number of triangles"));
  EXPECT_THAT(Read(Square("\"byteLength\": 72}", "\"byteLength\": 85}")),
              IsInvalidWith("bufferView 0 lies outside its buffer"));
  EXPECT_THAT(Read(Square("\"byteLength\": 84}", "\"byteLength\": 85}")),
              IsInvalidWith("buffer 0 has fewer bytes"));
  EXPECT_THAT(
      Read(Square("\"byteLength\": 84}",
                  "\"byteLength\": 84, \"uri\": \"square.bin\"}")),
      IsInvalidWith("buffer 0 is in another file (square.bin): save the scene "
                    "as .glb"));
  EXPECT_THAT(Read(Square("{\"mesh\": 0}", "{\"mesh\": 1}")),
              IsInvalidWith("node 0 has a mesh that is not there"));
  EXPECT_THAT(Read(Square("{\"mesh\": 0}", "{\"mesh\": 0, \"scale\": [1]}")),
              IsInvalidWith("node 0 is placed by something else"));
  EXPECT_THAT(Read(Square("\"scene\": 0", "\"scene\": 1")),
              IsInvalidWith("there is no scene 1"));
  EXPECT_THAT(Read(Square("\"2.0\"", "\"1.0\"")), IsInvalidWith("glTF 2"));
  EXPECT_THAT(Read(Square("\"scene\": 0,",
                          "\"extensionsRequired\": "
                          "[\"KHR_draco_mesh_compression\"],")),
              IsInvalidWith("KHR_draco_mesh_compression"));
  EXPECT_THAT(Read(Square("\"scene\": 0", "\"scene\" 0")),
              IsInvalidWith("not valid JSON"));
}

TEST(GltfReaderTest, RefusalsNameWhatIsMissing) {
  EXPECT_THAT(
      Read(Square("\"scene\": 0", "\"scene\": \"first\"")),
      IsInvalidWith("the scene that is shown is not named by a number"));
  EXPECT_THAT(Read(Square("\"POSITION\"", "\"NORMAL\"")),
              IsInvalidWith("mesh 0: a primitive has no POSITION"));
  EXPECT_THAT(Read(Square("\"componentType\": 5126, ", "")),
              IsInvalidWith("accessor 0 has no number as componentType"));
  EXPECT_THAT(
      Read(Square("\"buffers\": [{\"byteLength\": 84}]", "\"buffers\": [{}]")),
      IsInvalidWith("buffer 0 has no number as byteLength"));
  EXPECT_THAT(
      Read(Square("{\"attributes\"", "{\"mode\": \"fan\", \"attributes\"")),
      IsInvalidWith("the mode of a primitive is not one of 0 to 6"));
  EXPECT_THAT(Read(Square("[{\"nodes\": [0]}]", "[{\"nodes\": [0, 7]}]")),
              IsInvalidWith("scene 0: entry 1 of 'nodes' names no node"));
  EXPECT_THAT(
      Read(Square("{\"mesh\": 0}", "{\"mesh\": 0, \"children\": [\"x\"]}")),
      IsInvalidWith("node 0: entry 0 of 'children' names no node"));
}

TEST(GltfReaderTest, ScenesAreTrees) {
  EXPECT_THAT(Read(Square("{\"mesh\": 0}", "{\"mesh\": 0, \"children\": [0]}")),
              IsInvalidWith("node 0 has two parents"));
  EXPECT_THAT(Read(Square("[{\"nodes\": [0]}]", "[{\"nodes\": [0, 0]}]")),
              IsInvalidWith("node 0 has two parents"));
}

TEST(GltfReaderTest, CoordinatesAreFiniteWhereTheyArePlaced) {
  EXPECT_THAT(Read(Square("{\"mesh\": 0}",
                          "{\"mesh\": 0, \"scale\": [1e308, 1, 1],"
                          " \"translation\": [1.7e308, 0, 0]}")),
              IsInvalidWith("vertex 1 of accessor 0 is not finite"));
}

// JSON costs memory for every bracket, so it is counted before it is kept.
TEST(GltfReaderTest, ScenesAreBounded) {
  EXPECT_THAT(Read(std::string(1 << 20, '[')), IsInvalidWith("nested deeper"));
  std::string wide = "[0";
  for (int i = 0; i < 300'000; ++i) wide += ",0";
  EXPECT_THAT(Read(wide + "]"), IsInvalidWith("more than 262144 values"));
}

// Each primitive with an accessor of its own, all of the same vertices.
std::string ManyPrimitives(int count, uint32_t vertices) {
  std::string accessors, primitives;
  for (int i = 0; i < count; ++i) {
    absl::StrAppend(&accessors, i == 0 ? "" : ",",
                    R"({"bufferView": 0, "componentType": 5126, "count": )",
                    vertices, R"(, "type": "VEC3"})");
    absl::StrAppend(&primitives, i == 0 ? "" : ",",
                    R"({"attributes": {"POSITION": )", i, "}}");
  }
  ByteWriter buffer;
  for (uint32_t v = 0; v < vertices; ++v) {
    buffer.Put<float>(static_cast<float>(v), static_cast<float>(v % 3), 0);
  }
  return Glb(
      absl::StrCat(
          R"({"asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}],
                     "nodes": [{"mesh": 0}], "meshes": [{"primitives": [)",
          primitives, R"(]}], "accessors": [)", accessors,
          R"(], "bufferViews": [{"buffer": 0, "byteLength": )", 12 * vertices,
          R"(}], "buffers": [{"byteLength": )", 12 * vertices, "}]}"),
      buffer.bytes());
}

TEST(GltfReaderTest, RepeatedVerticesAreBounded) {
  EXPECT_THAT(ExpectRead(Read(ManyPrimitives(100, 6))).triangles, SizeIs(200));
  // 100 times what the file has.
  EXPECT_THAT(Read(ManyPrimitives(100, 60'000)),
              IsInvalidWith("mesh 0 repeats its vertices more than 64 times"));
}

}  // namespace
}  // namespace geodesic
