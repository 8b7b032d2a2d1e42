// A first path is a path: no shorter than the distance, and hardly longer.

#include "questions/first_path/first_path.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include "absl/status/status.h"
#include "solver/goal.h"
#include "surface/anchors.h"
#include "tests/support/field_check.h"
#include "tests/support/meshes/curved_meshes.h"
#include "tests/support/meshes/mesh_edits.h"
#include "tests/support/meshes/planar_meshes.h"
#include "tests/support/queries.h"
#include "tests/support/random.h"
#include "tests/support/surface_points.h"
#include "tests/support/vec.h"

namespace geodesic::test {
namespace {

absl::Status GoOn() { return absl::OkStatus(); }

class FirstPathOn {
 public:
  explicit FirstPathOn(const NamedMesh& named)
      : mesh_(BuildOrFail(named)), goal_(*mesh_), path_(*mesh_) {}

  const Mesh& mesh() const { return *mesh_; }

  absl::Status Find(const Query& query,
                    absl::FunctionRef<absl::Status()> poll = GoOn) {
    goal_.Aim(query.targets[0], nullptr);
    return path_.Find(AnchorsOf(Valid(*mesh_, query)), query.targets[0], goal_,
                      poll);
  }

  // In the unit of the file.
  double Length(const Query& query) {
    EXPECT_TRUE(Find(query).ok());
    return std::ldexp(path_.length(), mesh_->scale_exponent());
  }

 private:
  const std::shared_ptr<const Mesh> mesh_;
  Goal goal_;
  FirstPath path_;
};

TEST(FirstPath, IsNoShorterThanTheDistance) {
  Random random(1);
  const std::vector<NamedMesh> surfaces = {
      {"icosphere", Icosphere(4)},
      {"noisy torus", Torus({.around = 40, .across = 24, .noise = 0.15})},
      {"terrain", Terrain(40, 36, 1.5, 7)},
      {"hyperbolic", HyperbolicGrid(20, 20, 1e-3)},
      {"U-shaped grid", MakeGrid(UShape({.columns = 24, .rows = 24}))}};
  for (const NamedMesh& named : surfaces) {
    SCOPED_TRACE(named.name);
    FirstPathOn path(named);
    int found = 0;
    for (int i = 0; i < 60; ++i) {
      Query query{.sources = {{RandomSurfacePoint(named.soup, random)}},
                  .targets = {RandomSurfacePoint(named.soup, random)}};
      if (i % 3 == 0) {
        query.sources = {{RandomVertexPoint(named.soup, random), 0.1},
                         {RandomVertexPoint(named.soup, random)}};
      }
      const double distance =
          SolveOrFail(path.mesh(), query).target_distances[0];
      const double length = path.Length(query);
      EXPECT_GE(length, distance * (1 - 1e-12))
          << Name(query.sources[0]) << " to " << Name(query.targets[0]);
      if (std::isinf(length)) continue;  // the route winds
      ++found;
      EXPECT_LE(length, 1.5 * distance)
          << Name(query.sources[0]) << " to " << Name(query.targets[0]);
    }
    EXPECT_GT(found, 55);
  }
}

// A locally shortest path in a convex part of the plane is the straight line.
TEST(FirstPath, IsStraightInThePlane) {
  Random random(2);
  const NamedMesh named{
      "grid", MakeGrid({.columns = 30, .rows = 25, .jitter = 0.2, .seed = 5})};
  FirstPathOn path(named);
  for (int i = 0; i < 200; ++i) {
    const uint32_t from = random.Below(path.mesh().vertex_count());
    const uint32_t to = random.Below(path.mesh().vertex_count());
    const std::vector<Point>& at = named.soup.positions;
    const double straight =
        std::hypot(at[from][0] - at[to][0], at[from][1] - at[to][1]);
    EXPECT_NEAR(path.Length({.sources = {{VertexPoint{from}}},
                             .targets = {VertexPoint{to}}}),
                straight, 1e-12)
        << from << " to " << to;
  }
}

TEST(FirstPath, EndsAtTheBoundaryOfAPart) {
  const TriangleSoup ball = Icosphere(2);
  const auto other = static_cast<uint32_t>(ball.positions.size());
  FirstPathOn path({"two balls", Join(ball, RotateAndShift(ball, 5))});
  EXPECT_EQ(path.Length({.sources = {{VertexPoint{0}}},
                         .targets = {VertexPoint{other}}}),
            std::numeric_limits<double>::infinity());
}

TEST(FirstPath, StopsWhenItIsTold) {
  FirstPathOn path(
      {"grid", MakeGrid({.columns = 60, .rows = 60, .jitter = 0.2})});
  EXPECT_EQ(path.Find({.sources = {{VertexPoint{0}}},
                       .targets = {VertexPoint{31 * 61 + 58}}},
                      [] { return absl::CancelledError("enough"); })
                .code(),
            absl::StatusCode::kCancelled);
}

// One for some ten thousand half-edges or vertices.
int CountPolls(FirstPathOn& path, const Query& query) {
  int polls = 0;
  EXPECT_TRUE(path.Find(query,
                        [&] {
                          ++polls;
                          return absl::OkStatus();
                        })
                  .ok());
  return polls;
}

// In a strip one long piece would take up thousands of short ones, one a round.
TEST(FirstPath, IsDoneWhereNothingIsGained) {
  constexpr uint32_t kColumns = 20000;
  FirstPathOn path(
      {"strip", MakeGrid({.columns = kColumns, .rows = 1, .cell_width = 0.3})});
  int polls = 0;
  for (const uint32_t to : {5001u, 9000u, 2 * kColumns + 1}) {
    polls += CountPolls(
        path, {.sources = {{VertexPoint{3}}}, .targets = {VertexPoint{to}}});
  }
  EXPECT_LT(polls, 30);
}

// Along the sides of a ladder routes are straight, but for where they change
// over: that bend would move on by a rung in a round.
TEST(FirstPath, IsSoonStraightInALadder) {
  constexpr uint32_t kRungs = 16000;
  FirstPathOn path({"ladder", MakeGrid({.columns = 1,
                                        .rows = kRungs,
                                        .cell_height = 1e-3,
                                        .diagonals = Diagonals::kRandom})});
  const Query query{.sources = {{VertexPoint{1}}},
                    .targets = {VertexPoint{2 * kRungs}}};
  EXPECT_LT(CountPolls(path, query), 15);
  const double straight = std::hypot(1, 1e-3 * kRungs);
  EXPECT_NEAR(path.Length(query), straight, 1e-12 * straight);
}

}  // namespace
}  // namespace geodesic::test
