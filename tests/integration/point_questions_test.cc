// Farthest-point samples and log maps, by library and by command.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/integration/planar_grid_test.h"

namespace geodesic::client {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

class PointQuestionsTest : public PlanarGridTest {};

TEST_F(PointQuestionsTest, LogMapOfThePlaneKeepsAllDistances) {
  const std::vector<SurfacePoint> places = {
      VertexPoint{kMiddle}, EdgePoint{kMiddle, kMiddle + 1, 0.4},
      FacePoint{101, {0.3, 0.3, 0.4}}};
  for (const SurfacePoint& place : places) {
    absl::StatusOr<LogMap> map =
        client_.ComputeLogMap({.mesh_digest = digest_, .source = place});
    ASSERT_TRUE(map.ok()) << map.status();
    ASSERT_EQ(map->coordinates.size(), vertex_count_);
    const Point from = Where(place);
    const Point& x = map->zero_direction;
    EXPECT_NEAR(Euclid(x, {0, 0, 0}), 1, kTolerance);
    for (uint64_t v = 0; v < vertex_count_; ++v) {
      // Along and to the left of the direction of angle 0.
      const double dx = At(v)[0] - from[0];
      const double dy = At(v)[1] - from[1];
      EXPECT_NEAR(map->coordinates[v][0], dx * x[0] + dy * x[1], 1e-9);
      EXPECT_NEAR(map->coordinates[v][1], dy * x[0] - dx * x[1], 1e-9);
    }
  }
  absl::StatusOr<LogMap> near = client_.ComputeLogMap(
      {.mesh_digest = digest_, .source = VertexPoint{kMiddle}, .radius = 0.2});
  ASSERT_TRUE(near.ok()) << near.status();
  EXPECT_TRUE(std::isnan(near->coordinates[0][0]));
  EXPECT_FALSE(std::isnan(near->coordinates[kMiddle + 1][0]));
}

TEST_F(PointQuestionsTest, SamplesAreFarApart) {
  const json answer =
      GeodesicJson({"sample", grid_, "-n", "3", "-o", folder_ / "s.csv", "-o",
                    folder_ / "s.ply", "-o", folder_ / "s.json"});
  // From one corner: the opposite one, then the two others.
  ASSERT_EQ(answer["samples"].size(), 3);
  EXPECT_EQ(answer["samples"][0]["vertex"], 80);
  EXPECT_NEAR(answer["samples"][0]["distance"], std::sqrt(2), kTolerance);
  EXPECT_NEAR(answer["samples"][1]["distance"], 1, kTolerance);
  EXPECT_NEAR(answer["samples"][2]["distance"], 1, kTolerance);
  EXPECT_EQ(Rows(FileBytes(folder_ / "s.csv")).size(), 3);
  EXPECT_THAT(FileBytes(folder_ / "s.ply"), HasSubstr("element vertex 3\n"));
  EXPECT_EQ(json::parse(FileBytes(folder_ / "s.json")), answer["samples"]);
}

TEST_F(PointQuestionsTest, LogMapKeepsDistances) {
  const json answer =
      GeodesicJson({"logmap", grid_, "-s", "40", "-o", folder_ / "u.csv", "-o",
                    folder_ / "u.npy", "-o", folder_ / "u.ply"});
  EXPECT_EQ(answer["mapped_vertices"], vertex_count_);
  const std::vector<std::vector<double>> rows =
      Rows(FileBytes(folder_ / "u.csv"));
  ASSERT_EQ(rows.size(), vertex_count_);
  for (const std::vector<double>& a : rows) {
    for (const std::vector<double>& b : rows) {
      EXPECT_NEAR(
          std::hypot(a[1] - b[1], a[2] - b[2]),
          Euclid(At(static_cast<size_t>(a[0])), At(static_cast<size_t>(b[0]))),
          1e-9);
    }
  }
  EXPECT_THAT(FileBytes(folder_ / "u.npy"), HasSubstr("'shape': (81, 2), }"));
}

}  // namespace
}  // namespace geodesic::client
