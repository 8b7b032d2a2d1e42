#include "client/output/line_writers.h"

#include <gtest/gtest.h>

#include <cstring>
#include <nlohmann/json.hpp>

#include "tests/client/written.h"

namespace geodesic::client {
namespace {

using nlohmann::json;

// A path of three points, one that was not found, and a triangle that closes.
Lines Sample() {
  Lines lines = {.attributes = {{"source", true}, {"length"}}};
  lines.lines.push_back(
      {.polyline = {.points = {VertexPoint{4}, EdgePoint{1, 2, 0.5},
                               FacePoint{3, {0.25, 0.25, 0.5}}},
                    .positions = {{0, 0, 0}, {1, 0, 0}, {1, 2, 0}}},
       .values = {7, 3}});
  lines.lines.push_back({.values = {-1, kInfinity}});
  lines.lines.push_back(
      {.polyline = {.points = {VertexPoint{0}, VertexPoint{1}, VertexPoint{2}},
                    .positions = {{0, 0, 1}, {1, 0, 1}, {0, 1, 1}}},
       .is_closed = true,
       .values = {2, 0.5}});
  return lines;
}

std::string Written(OutputFormat format, const Lines& lines = Sample()) {
  return client::Written(
      [&](AtomicFile* file) { WriteLines(lines, format, file); });
}

TEST(LineWritersTest, Obj) {
  EXPECT_EQ(Written(OutputFormat::kObj),
            "# source 7 length 3\n"
            "g line_0\n"
            "v 0 0 0\nv 1 0 0\nv 1 2 0\n"
            "l 1 2 3\n"
            "# source 2 length 0.5\n"
            "g line_2\n"
            "v 0 0 1\nv 1 0 1\nv 0 1 1\n"
            "l 4 5 6 4\n");
}

TEST(LineWritersTest, Csv) {
  EXPECT_EQ(Written(OutputFormat::kCsv),
            "line,point,x,y,z,place,source,length\n"
            "0,0,0,0,0,4,7,3\n"
            "0,1,1,0,0,edge:1-2@0.5,7,3\n"
            "0,2,1,2,0,\"face:3@0.25,0.25,0.5\",7,3\n"
            "2,0,0,0,1,0,2,0.5\n"
            "2,1,1,0,1,1,2,0.5\n"
            "2,2,0,1,1,2,2,0.5\n"
            "2,3,0,0,1,0,2,0.5\n");
}

TEST(LineWritersTest, Json) {
  const json collection = json::parse(Written(OutputFormat::kJson));
  EXPECT_EQ(collection["type"], "FeatureCollection");
  const json& features = collection["features"];
  ASSERT_EQ(features.size(), 3);
  EXPECT_EQ(features[0]["geometry"],
            json::parse(R"({"type": "LineString", "coordinates":
                            [[0.0,0.0,0.0],[1.0,0.0,0.0],[1.0,2.0,0.0]]})"));
  EXPECT_EQ(features[0]["properties"]["source"], 7);
  EXPECT_EQ(features[0]["properties"]["points"][1]["edge"], json({1, 2}));
  EXPECT_TRUE(features[1]["geometry"].is_null());
  EXPECT_TRUE(features[1]["properties"]["source"].is_null());
  EXPECT_TRUE(features[1]["properties"]["length"].is_null());
  // A ring repeats its first position.
  EXPECT_EQ(features[2]["geometry"]["coordinates"].size(), 4);
  EXPECT_EQ(features[2]["properties"]["closed"], true);
  EXPECT_EQ(features[2]["properties"]["points"].size(), 3);
}

TEST(LineWritersTest, PlyHasEdges) {
  const std::string bytes = Written(OutputFormat::kPly);
  const std::string header =
      "ply\nformat binary_little_endian 1.0\n"
      "element vertex 6\n"
      "property double x\nproperty double y\nproperty double z\n"
      "element edge 5\n"
      "property int vertex1\nproperty int vertex2\nproperty int line\n"
      "property int source\nproperty double length\n"
      "end_header\n";
  ASSERT_EQ(bytes.substr(0, header.size()), header);
  const size_t edges = header.size() + 6 * 24;
  constexpr size_t kRow = 4 * 4 + 8;
  ASSERT_EQ(bytes.size(), edges + 5 * kRow);
  const auto edge = [&](size_t number) {
    std::array<int32_t, 4> row;
    std::memcpy(row.data(), bytes.data() + edges + number * kRow, sizeof(row));
    return row;
  };
  EXPECT_EQ(edge(0), (std::array<int32_t, 4>{0, 1, 0, 7}));
  EXPECT_EQ(edge(1), (std::array<int32_t, 4>{1, 2, 0, 7}));
  EXPECT_EQ(edge(2), (std::array<int32_t, 4>{3, 4, 2, 2}));
  EXPECT_EQ(edge(4), (std::array<int32_t, 4>{5, 3, 2, 2}));
}

TEST(LineWritersTest, VtkHasLinesAndCellData) {
  const std::string bytes = Written(OutputFormat::kVtk);
  const std::string lines = "\nLINES 2 9\n";
  const size_t at = bytes.find(lines);
  ASSERT_NE(at, std::string::npos);
  // 3 points, then 4 with the first again; big endian.
  const std::string body = bytes.substr(at + lines.size(), 36);
  const char expected[] = {3, 0, 1, 2, 4, 3, 4, 5, 3};
  for (size_t i = 0; i < 9; ++i) {
    EXPECT_EQ(body.substr(4 * i, 4), std::string(3, '\0') + expected[i]) << i;
  }
  EXPECT_NE(bytes.find("\nCELL_DATA 2\nSCALARS source double 1\n"),
            std::string::npos);
  EXPECT_NE(bytes.find("\nSCALARS length double 1\n"), std::string::npos);
}

TEST(LineWritersTest, NoLinesAreFine) {
  EXPECT_EQ(Written(OutputFormat::kObj, {}), "");
  EXPECT_EQ(json::parse(Written(OutputFormat::kJson, {}))["features"],
            json::array());
}

}  // namespace
}  // namespace geodesic::client
