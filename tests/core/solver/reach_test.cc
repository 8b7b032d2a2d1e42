// Computations that stop at a radius or at targets.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "geodesic/computation.h"
#include "tests/core/solver/computation_fixture.h"
#include "tests/core/solver/computation_scenes.h"
#include "tests/support/curved_meshes.h"
#include "tests/support/planar_meshes.h"
#include "tests/support/vec.h"

namespace geodesic::test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

class ReachTest : public ComputationFixture {};

// On a plane, where the answer is Euclid's.
TEST_P(ReachTest, IsExactUpToTheRadiusAndAbsentBeyond) {
  const TriangleSoup grid = MakeGrid({.columns = 14, .rows = 12});
  const std::shared_ptr<const Mesh> mesh = BuildOrFail({"grid", grid});
  ASSERT_NE(mesh, nullptr);
  // At 5 lie the vertices (5, 0), (4, 3), (3, 4) and (0, 5).
  const Query query = WithAlgorithm(
      {.sources = {{VertexPoint{0}}},
       .targets = {VertexPoint{5}, VertexPoint{4 * 15 + 3}, VertexPoint{6}}});
  for (const double radius : {0.0, 0.5, 1.0, 5.0, 7.3, 100.0}) {
    const auto computation = StartOrFail(*mesh, query);
    ASSERT_NE(computation, nullptr);
    ASSERT_TRUE(computation->Advance({.radius = radius}, checkpoint_).ok());
    const DistanceField field = computation->Field();
    EXPECT_GE(field.settled_radius, radius);
    if (radius < 7) {
      EXPECT_EQ(field.settled_radius, radius);
    }
    const auto expect = [&](double got, double distance) {
      if (std::abs(distance - radius) < 1e-12) return;  // a tie
      if (distance > radius) {
        EXPECT_EQ(got, kInfinity) << distance << " within " << radius;
      } else {
        EXPECT_NEAR(got, distance, 1e-12) << "within " << radius;
      }
    };
    for (uint32_t v = 0; v < mesh->vertex_count(); ++v) {
      expect(field.distances[v], static_cast<double>(Distance(
                                     grid.positions[0], grid.positions[v])));
    }
    expect(field.target_distances[0], 5);
    expect(field.target_distances[1], 5);
    expect(field.target_distances[2], 6);
  }
}

TEST_P(ReachTest, IsExactUpToAnyRadiusOnAnySurface) {
  for (const ComputationScene& scene : ComputationScenes()) {
    const Query query = WithAlgorithm(scene.query);
    const DistanceField whole = WholeField(*scene.mesh, query);
    const double far = Farthest(whole);
    // The last is a distance that occurs: a tie with the radius.
    for (const double radius : {0.1 * far, 0.55 * far, whole.distances[40]}) {
      const auto computation = StartOrFail(*scene.mesh, query);
      ASSERT_NE(computation, nullptr);
      ASSERT_TRUE(computation->Advance({.radius = radius}, checkpoint_).ok());
      const DistanceField field = computation->Field();
      EXPECT_GE(field.settled_radius, radius) << scene.name;
      ExpectCertified(scene.name, field, whole);
    }
  }
}

TEST_P(ReachTest, StopsWhenSoManyTargetsAreCertified) {
  for (const ComputationScene& scene : ComputationScenes()) {
    const Query query = WithAlgorithm(scene.query);
    const DistanceField whole = WholeField(*scene.mesh, query);
    for (const uint64_t wanted : {0, 1, 4, 9}) {
      const auto computation = StartOrFail(*scene.mesh, query);
      ASSERT_NE(computation, nullptr);
      ASSERT_TRUE(computation->Advance({.targets = wanted}, checkpoint_).ok());
      const DistanceField field = computation->Field();
      uint64_t certified = 0;
      for (const double d : field.target_distances) {
        certified += std::isfinite(d) ? 1 : 0;
      }
      // All that can be reached may be fewer.
      EXPECT_TRUE(certified >= wanted || field.settled_radius == kInfinity)
          << scene.name << ": " << certified << " of " << wanted;
      ExpectCertified(scene.name, field, whole);
    }
  }
}

// Windows propagated stand for time: they are counted, not measured.
TEST_P(ReachTest, CostsWhatItCovers) {
  const TriangleSoup terrain = Terrain(36, 36, 1, 7);
  const std::shared_ptr<const Mesh> mesh = BuildOrFail({"terrain", terrain});
  ASSERT_NE(mesh, nullptr);
  // In the middle; so is the target.
  const Query query = WithAlgorithm({.sources = {{VertexPoint{18 * 37 + 18}}},
                                     .targets = {VertexPoint{18 * 37 + 20}}});
  const uint64_t whole = WholeField(*mesh, query).statistics.windows_propagated;
  // An eighth of the area; a queue that knows no order may do more, but not
  // everything.
  for (const Reach reach : {Reach{.radius = 7}, Reach{.targets = 1}}) {
    const auto computation = StartOrFail(*mesh, query);
    ASSERT_NE(computation, nullptr);
    ASSERT_TRUE(computation->Advance(reach, checkpoint_).ok());
    EXPECT_LT(computation->Field().statistics.windows_propagated, whole * 4 / 5)
        << "of " << whole;
  }
}

TEST_P(ReachTest, NegativeAndUndefinedRadiiAreRefused) {
  const std::shared_ptr<const Mesh> mesh =
      BuildOrFail({"icosphere", Icosphere(1)});
  ASSERT_NE(mesh, nullptr);
  const Query query = WithAlgorithm({.sources = {{VertexPoint{3}}}});
  const auto computation = StartOrFail(*mesh, query);
  ASSERT_NE(computation, nullptr);
  for (const double radius : {-1.0, -kInfinity, std::nan("")}) {
    const absl::Status status =
        computation->Advance({.radius = radius}, checkpoint_);
    EXPECT_TRUE(absl::IsInvalidArgument(status)) << status;
    EXPECT_THAT(std::string(status.message()),
                testing::HasSubstr("reach.radius"));
  }
  // No harm done.
  ASSERT_TRUE(computation->Advance({}, checkpoint_).ok());
  EXPECT_EQ(computation->Field().distances, WholeField(*mesh, query).distances);
}

GEODESIC_TEST_EVERY_ALGORITHM(ReachTest);

}  // namespace
}  // namespace geodesic::test
