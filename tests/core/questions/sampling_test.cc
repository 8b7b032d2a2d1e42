// Farthest-point sampling against one solve of all sources a sample.

#include "geodesic/sampling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "tests/core/exactness/every_algorithm.h"
#include "tests/support/checkpoints.h"
#include "tests/support/meshes/curved_meshes.h"
#include "tests/support/meshes/mesh_edits.h"
#include "tests/support/meshes/planar_meshes.h"

namespace geodesic::test {
namespace {

class Sampling : public EveryAlgorithm {
 protected:
  std::vector<FarthestSample> Sample(const Mesh& mesh,
                                     const std::vector<Source>& sources,
                                     uint32_t count) const {
    NoCheckpoint checkpoint;
    return SampleFarthestPoints(mesh, Valid(mesh, Ask({.sources = sources})),
                                count, {}, checkpoint)
        .value();
  }

  // Every sample is the farthest vertex of the field of all sources before it.
  void ExpectFarthest(const NamedMesh& named, std::vector<Source> sources,
                      uint32_t count) const {
    const auto mesh = BuildOrFail(named);
    const auto samples = Sample(*mesh, sources, count);
    ASSERT_EQ(samples.size(), count) << named.name;
    for (size_t i = 0; i < samples.size(); ++i) {
      const std::vector<double> fresh = SolveOn(*mesh, sources);
      double farthest = 0;
      for (uint32_t v = 0; v < fresh.size(); ++v) {
        if (!mesh->Outgoing(v).empty()) farthest = std::max(farthest, fresh[v]);
      }
      const auto& [vertex, distance] = samples[i];
      if (std::isinf(farthest)) {
        EXPECT_EQ(distance, farthest) << named.name << ", sample " << i;
      } else {
        EXPECT_NEAR(distance, farthest, kRelativeTolerance * farthest)
            << named.name << ", sample " << i;
        EXPECT_NEAR(distance, fresh[vertex], kRelativeTolerance * farthest)
            << named.name << ", sample " << i;
      }
      for (uint32_t v = 0; v < vertex; ++v) {
        if (mesh->Outgoing(v).empty()) continue;
        EXPECT_LT(fresh[v], distance)
            << named.name << ", sample " << i << ": vertex " << v
            << " is as far as " << vertex << " and has a lower number";
      }
      sources.push_back({VertexPoint{vertex}});
    }
  }
};

TEST_P(Sampling, EachSampleIsTheFarthestVertex) {
  ExpectFarthest({"terrain", Terrain(12, 9, 0.8, 5)}, {{VertexPoint{7}}}, 12);
  ExpectFarthest({"torus", Torus({.noise = 0.05, .seed = 3})},
                 {{VertexPoint{1}}, {EdgePoint{0, 1, 0.3}, 0.4}}, 8);
  const TriangleSoup grid = MakeGrid(WithHole(
      {.columns = 9, .rows = 7, .diagonals = Diagonals::kAlternating}));
  ExpectFarthest({"grid with a hole", grid},
                 {{FacePoint{3, {0.2, 0.5, 0.3}}, 0.25}}, 10);
}

// Equal distances everywhere: the lowest number is taken.
TEST_P(Sampling, TiesGoToTheLowestNumber) {
  ExpectFarthest({"icosphere", Icosphere(2)}, {{VertexPoint{0}}}, 6);
  ExpectFarthest({"regular grid", MakeGrid({.columns = 8, .rows = 8})},
                 {{VertexPoint{40}}}, 9);
}

// Rounding puts some of the rim's vertices a little farther away than the
// first.
TEST_P(Sampling, TiesAreThoseWithinRounding) {
  constexpr uint32_t kRim = 100;
  TriangleSoup disc{.positions = {{0, 0, 0}}};
  for (uint32_t i = 0; i < kRim; ++i) {
    const double angle = 2 * std::numbers::pi * i / kRim;
    disc.positions.push_back({3 * std::cos(angle), 3 * std::sin(angle), 0});
    disc.triangles.push_back({0, 1 + i, 1 + (i + 1) % kRim});
  }
  const auto mesh = BuildOrFail({"disc", disc});
  const std::vector<double> distances = SolveOn(*mesh, {{VertexPoint{0}}});
  ASSERT_GT(std::ranges::max(distances), distances[1]);
  EXPECT_EQ(Sample(*mesh, {{VertexPoint{0}}}, 1)[0].vertex, 1);
}

TEST_P(Sampling, ComponentsWithoutASourceComeFirst) {
  TriangleSoup soup = Join(Join(Icosphere(1), Terrain(4, 4, 0.5, 2)),
                           MakeGrid({.columns = 2, .rows = 2}));
  soup = AddIsolatedVertices(std::move(soup), 3);
  const NamedMesh named{"three components", soup};
  ExpectFarthest(named, {{VertexPoint{3}}}, 7);
  const auto mesh = BuildOrFail(named);
  const auto samples = Sample(*mesh, {{VertexPoint{3}}}, 3);
  ASSERT_EQ(samples.size(), 3u);
  EXPECT_TRUE(std::isinf(samples[0].distance));
  EXPECT_TRUE(std::isinf(samples[1].distance));
  EXPECT_TRUE(std::isfinite(samples[2].distance));
}

TEST_P(Sampling, EndsWhenEveryVertexOfAFaceIsASample) {
  const TriangleSoup soup =
      AddIsolatedVertices(MakeGrid({.columns = 2, .rows = 2}), 2);
  const auto mesh = BuildOrFail({"grid", soup});
  EXPECT_EQ(Sample(*mesh, {{VertexPoint{4}}}, 100).size(), 8u);
  // One on an isolated vertex reaches nothing.
  EXPECT_EQ(Sample(*mesh, {{VertexPoint{9}}}, 100).size(), 9u);
  EXPECT_TRUE(Sample(*mesh, {{VertexPoint{4}}}, 0).empty());
}

GEODESIC_TEST_EVERY_ALGORITHM(Sampling);

TEST(SamplingErrors, AreThoseOfTheCheckpoint) {
  const auto mesh = BuildOrFail({"grid", MakeGrid({.columns = 2, .rows = 2})});
  RecordingCheckpoint cancel(0);
  EXPECT_EQ(
      SampleFarthestPoints(*mesh, Valid(*mesh, {.sources = {{VertexPoint{0}}}}),
                           3, {}, cancel)
          .status(),
      RecordingCheckpoint::Stopped());
}

}  // namespace
}  // namespace geodesic::test
