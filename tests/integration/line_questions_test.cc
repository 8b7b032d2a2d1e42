// Shortest paths and isolines, by library and by command.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "tests/integration/planar_grid_test.h"

namespace geodesic::client {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::StartsWith;

class LineQuestionsTest : public PlanarGridTest {};

TEST_F(LineQuestionsTest, PathsAreStraightInThePlane) {
  std::vector<SurfacePoint> targets = places_;
  for (uint64_t v = 0; v < vertex_count_; v += 7) {
    targets.push_back(VertexPoint{v});
  }
  const std::vector<Source> sources = {{VertexPoint{0}, 0.25},
                                       {FacePoint{100, {0.5, 0.25, 0.25}}}};
  absl::StatusOr<PathAnswer> answer = client_.ComputePaths(
      {.mesh_digest = digest_, .sources = sources, .targets = targets});
  ASSERT_TRUE(answer.ok()) << answer.status();
  ASSERT_EQ(answer->paths.size(), targets.size());
  const std::vector<Point> from = {At(0),
                                   Where(FacePoint{100, {0.5, 0.25, 0.25}})};
  for (size_t i = 0; i < targets.size(); ++i) {
    const GeodesicPath& path = answer->paths[i];
    const Point to = Where(targets[i]);
    ASSERT_TRUE(path.source.has_value());
    const Point& start = from.at(*path.source);
    EXPECT_NEAR(path.length, Euclid(start, to), kTolerance);
    EXPECT_NEAR(path.distance, sources[*path.source].offset + path.length,
                kTolerance);
    EXPECT_LE(
        path.distance,
        std::min(0.25 + Euclid(from[0], to), Euclid(from[1], to)) + kTolerance);
    ASSERT_EQ(path.line.points.size(), path.line.positions.size());
    EXPECT_LT(Euclid(path.line.positions.front(), start), kTolerance);
    EXPECT_LT(Euclid(path.line.positions.back(), to), kTolerance);
    double length = 0;
    for (size_t k = 0; k < path.line.points.size(); ++k) {
      EXPECT_LT(Euclid(path.line.positions[k], Where(path.line.points[k])),
                kTolerance);
      if (k > 0) {
        length += Euclid(path.line.positions[k - 1], path.line.positions[k]);
      }
    }
    // As long as the straight line between its ends: it is that line.
    EXPECT_NEAR(length, path.length, kTolerance);
  }
}

TEST_F(LineQuestionsTest, PathsThatDoNotExistAreEmpty) {
  absl::StatusOr<PathAnswer> answer =
      client_.ComputePaths({.mesh_digest = digest_,
                            .sources = {{VertexPoint{0}}},
                            .targets = {VertexPoint{vertex_count_ - 1},
                                        VertexPoint{0}, VertexPoint{1}},
                            .radius = 0.5});
  ASSERT_TRUE(answer.ok()) << answer.status();
  EXPECT_FALSE(answer->paths[0].source.has_value());
  EXPECT_EQ(answer->paths[0].distance, kInfinity);
  EXPECT_TRUE(answer->paths[0].line.points.empty());
  EXPECT_EQ(answer->paths[1].length, 0);
  EXPECT_EQ(answer->paths[1].line.points.size(), 1);
  EXPECT_NEAR(answer->paths[2].length, 1.0 / kGrid, kTolerance);
}

TEST_F(LineQuestionsTest, IsolinesAreCircles) {
  // Around the middle: closed below 0.5, cut by the sides above. The answer is
  // in order of level, each once.
  const std::vector<double> levels = {0.6, 0.2, 0.45, 0.2};
  absl::StatusOr<IsolineAnswer> answer =
      client_.ComputeIsolines({.mesh_digest = digest_,
                               .sources = {{VertexPoint{kMiddle}}},
                               .levels = levels});
  ASSERT_TRUE(answer.ok()) << answer.status();
  EXPECT_TRUE(std::ranges::is_sorted(answer->isolines, {}, &Isoline::level));
  std::map<double, int> closed;
  std::map<double, int> open;
  for (const Isoline& isoline : answer->isolines) {
    ++(isoline.is_closed ? closed : open)[isoline.level];
    EXPECT_GT(isoline.line.points.size(), 2);
    for (size_t i = 0; i < isoline.line.points.size(); ++i) {
      EXPECT_NEAR(Euclid(isoline.line.positions[i], At(kMiddle)), isoline.level,
                  kTolerance);
      EXPECT_LT(
          Euclid(isoline.line.positions[i], Where(isoline.line.points[i])),
          kTolerance);
    }
  }
  EXPECT_EQ(closed, (std::map<double, int>{{0.2, 1}, {0.45, 1}}));
  EXPECT_EQ(open, (std::map<double, int>{{0.6, 4}}));
}

TEST_F(LineQuestionsTest, PathIsStraight) {
  const json answer = GeodesicJson({"path",   grid_,
                                    "-s",     "0",
                                    "-t",     "79",
                                    "-t",     "0",
                                    "-o",     folder_ / "p.obj",
                                    "-o",     folder_ / "p.ply",
                                    "-o",     folder_ / "p.vtk",
                                    "-o",     folder_ / "p.csv",
                                    "-o",     folder_ / "p.json",
                                    "-o",     folder_ / "p.png",
                                    "--size", "320x240"});
  const json& path = answer["paths"][0];
  EXPECT_EQ(path["source"], 0);
  EXPECT_NEAR(path["length"], Euclid(At(0), At(79)), kTolerance);
  for (const json& p : path["positions"]) {
    // On the line from (0, 0) to (7/8, 1).
    EXPECT_NEAR(p[0].get<double>(), 7.0 / 8 * p[1].get<double>(), kTolerance);
  }
  EXPECT_EQ(answer["paths"][1]["length"], 0);
  EXPECT_EQ(answer["outputs"].size(), 6);
  for (const json& output : answer["outputs"]) {
    EXPECT_EQ(output["bytes"],
              FileBytes(output["path"].get<std::string>()).size());
  }
  const json features = json::parse(FileBytes(folder_ / "p.json"))["features"];
  EXPECT_EQ(features[0]["geometry"]["coordinates"], path["positions"]);
  EXPECT_EQ(features[0]["properties"]["points"], path["points"]);
  EXPECT_THAT(FileBytes(folder_ / "p.obj"), HasSubstr("\nl 1 2 "));
  EXPECT_THAT(Geodesic({"path", grid_, "-s", "0", "-t", "79"}).out,
              StartsWith("target  source"));
}

TEST_F(LineQuestionsTest, IsolinesLieAtTheirLevels) {
  const json answer = GeodesicJson({"isolines", grid_, "-s", "40", "-l", "0.3",
                                    "-l", "0.4", "-o", folder_ / "l.csv", "-o",
                                    folder_ / "l.png", "--size", "320x240"});
  ASSERT_EQ(answer["levels"].size(), 2);
  EXPECT_EQ(answer["levels"][0]["lines"], 1);
  EXPECT_EQ(answer["levels"][0]["closed"], 1);
  // The polyline cuts the circle short.
  EXPECT_LT(answer["levels"][0]["length"], 2 * M_PI * 0.3);
  EXPECT_GT(answer["levels"][0]["length"], 0.95 * 2 * M_PI * 0.3);
  for (const std::vector<double>& row : Rows(FileBytes(folder_ / "l.csv"))) {
    EXPECT_NEAR(Euclid({row[2], row[3], row[4]}, At(40)), row.back(),
                kTolerance);
  }
  // Three levels cut the largest distance, that of a corner, into four.
  const json spread =
      GeodesicJson({"isolines", grid_, "-s", "40", "--count", "3"});
  ASSERT_EQ(spread["levels"].size(), 3);
  EXPECT_NEAR(spread["levels"][1]["level"], std::sqrt(0.5) / 2, kTolerance);
}

}  // namespace
}  // namespace geodesic::client
