// Bounds from merged windows are lower bounds, and near the truth where they
// have to be: beside exact fields by another rule.

#include "questions/backward_bounds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "absl/status/status.h"
#include "geodesic/landmarks.h"
#include "tests/support/field_check.h"
#include "tests/support/meshes/curved_meshes.h"
#include "tests/support/meshes/mesh_edits.h"
#include "tests/support/meshes/planar_meshes.h"
#include "tests/support/meshes/polyhedra.h"
#include "tests/support/random.h"
#include "tests/support/surface_points.h"

namespace geodesic::test {
namespace {

// What fields and bounds are rounded by.
constexpr double kRounding = 1e-11;

// The tolerance of the merges, and what they take more: their account is spread
// over all of the way, and answers would be a quarter of it higher.
constexpr double kNear = 2e-3;

std::vector<NamedMesh> Surfaces() {
  return {
      {"icosphere", Icosphere(4)},
      {"noisy torus", Torus({.around = 40, .across = 24, .noise = 0.15})},
      {"terrain", Terrain(40, 36, 1.5, 7)},
      {"box", BoxGrid(1, 2, 3, 6, 8, 10)},
      {"hyperbolic", HyperbolicGrid(20, 20, 1e-3)},
      {"U-shaped grid", MakeGrid(UShape({.columns = 24, .rows = 24}))},
      {"two parts and loose vertices",
       AddIsolatedVertices(
           Join(Icosphere(3), RotateAndShift(Terrain(12, 12, 1, 3), 5)), 3)}};
}

// Distances of all vertices in the scaled unit, by a rule that merges nothing.
std::vector<double> DistancesFrom(const Mesh& mesh, const SurfacePoint& point) {
  std::vector<double> distances =
      SolveOrFail(mesh, {.sources = {{point}}, .algorithm = Algorithm::kMmp})
          .distances;
  for (double& distance : distances) {
    distance = std::ldexp(distance, -mesh.scale_exponent());
  }
  return distances;
}

double DistanceBetween(const Mesh& mesh, const SurfacePoint& source,
                       const SurfacePoint& target) {
  return std::ldexp(SolveOrFail(mesh, {.sources = {{source}},
                                       .targets = {target},
                                       .algorithm = Algorithm::kMmp})
                        .target_distances[0],
                    -mesh.scale_exponent());
}

TEST(BackwardBounds, BoundAllWaysAndAreNearTheTruthWithinTheLimit) {
  Random random(11);
  NoCheckpoint checkpoint;
  for (const NamedMesh& named : Surfaces()) {
    SCOPED_TRACE(named.name);
    const std::shared_ptr<const Mesh> mesh = BuildOrFail(named);
    ASSERT_TRUE(BackwardBounds::Serve(*mesh));
    const absl::StatusOr<Landmarks> landmarks =
        MakeLandmarks(*mesh, 4, {}, checkpoint);
    ASSERT_TRUE(landmarks.ok());
    BackwardBounds bounds(*mesh);
    for (int i = 0; i < 12; ++i) {
      SCOPED_TRACE(i);
      const SurfacePoint source = RandomSurfacePoint(named.soup, random);
      const SurfacePoint target = RandomSurfacePoint(named.soup, random);
      const double distance = DistanceBetween(*mesh, source, target);
      if (std::isinf(distance)) continue;
      const double longest = distance * (1 + i % 4 * random.Uniform(0, 0.1));
      ASSERT_TRUE(bounds
                      .Find({source, target, longest},
                            i % 2 == 0 ? nullptr : &*landmarks,
                            [] { return absl::OkStatus(); })
                      .ok());
      ASSERT_TRUE(bounds.has_bounds());
      EXPECT_LE(bounds.longest(), distance * (1 + kNear));
      EXPECT_GE(bounds.longest(), distance * (1 - kRounding));
      EXPECT_LE(bounds.shortest(), distance * (1 + kRounding));
      EXPECT_GE(bounds.shortest(), distance * (1 - kNear));
      const std::vector<double> from_target = DistancesFrom(*mesh, target);
      const std::vector<double> from_source = DistancesFrom(*mesh, source);
      for (uint32_t v = 0; v < mesh->vertex_count(); ++v) {
        const double truth = from_target[v];
        if (std::isinf(truth)) continue;
        ASSERT_LE(bounds.Bound(v), truth * (1 + kRounding)) << "vertex " << v;
        if (truth + from_source[v] > longest) continue;
        ASSERT_GE(bounds.Bound(v), truth * (1 - kNear)) << "vertex " << v;
      }
    }
  }
}

TEST(BackwardBounds, TellThatNoPathIsSoShort) {
  Random random(12);
  for (const NamedMesh& named : Surfaces()) {
    SCOPED_TRACE(named.name);
    const std::shared_ptr<const Mesh> mesh = BuildOrFail(named);
    BackwardBounds bounds(*mesh);
    for (int i = 0; i < 8; ++i) {
      const SurfacePoint source = RandomSurfacePoint(named.soup, random);
      const SurfacePoint target = RandomSurfacePoint(named.soup, random);
      const double distance = DistanceBetween(*mesh, source, target);
      if (std::isinf(distance)) continue;
      const double longest = distance * random.Uniform(0.8, 0.99);
      ASSERT_TRUE(bounds
                      .Find({source, target, longest}, nullptr,
                            [] { return absl::OkStatus(); })
                      .ok());
      EXPECT_GE(bounds.shortest(), longest * (1 - kRounding));
      EXPECT_LE(bounds.shortest(), distance * (1 + kRounding));
      EXPECT_GE(bounds.longest(), distance * (1 - kRounding));
    }
  }
}

TEST(BackwardBounds, GiveTheSameAfterOtherWaysAndAfterAStop) {
  const NamedMesh named{"terrain", Terrain(60, 60, 1.5, 7)};
  const std::shared_ptr<const Mesh> mesh = BuildOrFail(named);
  const BoundedWay way{VertexPoint{3}, VertexPoint{3000}, 2};
  const auto always = [] { return absl::OkStatus(); };
  BackwardBounds fresh(*mesh), used(*mesh);
  ASSERT_TRUE(fresh.Find(way, nullptr, always).ok());
  ASSERT_TRUE(
      used.Find({VertexPoint{100}, VertexPoint{700}, 1}, nullptr, always).ok());
  const absl::Status stopped = used.Find(
      way, nullptr, [] { return absl::CancelledError("no more of this"); });
  EXPECT_EQ(stopped, absl::CancelledError("no more of this"));
  EXPECT_FALSE(used.has_bounds());
  ASSERT_TRUE(used.Find(way, nullptr, always).ok());
  EXPECT_EQ(used.longest(), fresh.longest());
  EXPECT_EQ(used.windows(), fresh.windows());
  for (uint32_t v = 0; v < mesh->vertex_count(); ++v) {
    ASSERT_EQ(used.Bound(v), fresh.Bound(v)) << "vertex " << v;
  }
}

TEST(BackwardBounds, ServeNoMeshThatMayMissAVertexOrCannotMerge) {
  EXPECT_FALSE(BackwardBounds::Serve(
      *BuildOrFail({"a book", Book(MakeGrid({.columns = 8, .rows = 8}), 4)})));
  TriangleSoup squeezed = MakeGrid({.columns = 30, .rows = 6, .jitter = 0.3});
  for (Point& position : squeezed.positions) position[1] *= 1e-9;
  EXPECT_FALSE(BackwardBounds::Serve(*BuildOrFail({"needles", squeezed})));
}

}  // namespace
}  // namespace geodesic::test
