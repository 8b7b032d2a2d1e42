// Geodesic triangle unfolding where it is exact, and against the exact solver.

#include "geodesic/approximate/triangle_unfolding.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/strings/match.h"
#include "tests/core/approximate/method_check.h"
#include "tests/support/checkpoints.h"
#include "tests/support/meshes/curved_meshes.h"
#include "tests/support/meshes/mesh_edits.h"
#include "tests/support/meshes/planar_meshes.h"
#include "tests/support/vec.h"

namespace geodesic::test {
namespace {

std::shared_ptr<const TriangleUnfolding> UnfoldingOrFail(
    const Mesh& mesh, const TriangleUnfoldingOptions& options) {
  NoCheckpoint checkpoint;
  return TriangleUnfolding::Prepare(mesh, options, checkpoint).value();
}

absl::Status StatusOf(const Mesh& mesh,
                      const TriangleUnfoldingOptions& options) {
  NoCheckpoint checkpoint;
  return TriangleUnfolding::Prepare(mesh, options, checkpoint).status();
}

// Single precision is off by the square root of its rounding where a place lies
// on an edge of its triangle.
TEST(TriangleUnfolding, IsExactInThePlane) {
  const TriangleSoup soup = MakeGrid({.columns = 24,
                                      .rows = 16,
                                      .diagonals = Diagonals::kRandom,
                                      .jitter = 0.2});
  const auto mesh = BuildOrFail({"plane", soup});
  const auto unfolding = UnfoldingOrFail(*mesh, {.samples = 40});
  constexpr double kPlace = 0.02;  // of the plane's 24 by 16
  for (uint32_t v = 0; v < mesh->vertex_count(); v += 3) {
    for (uint32_t w = 0; w < mesh->vertex_count(); w += 2) {
      const double expected =
          static_cast<double>(Distance(soup.positions[v], soup.positions[w]));
      ASSERT_NEAR(unfolding->Distance(v, w), expected, kPlace)
          << v << " to " << w;
    }
  }
}

TEST(TriangleUnfolding, IsExactBetweenSamples) {
  for (const TriangleSoup& soup :
       {Terrain(9, 8, 1.5, 3), Torus({.noise = 0.2, .seed = 6})}) {
    const auto mesh = BuildOrFail({"surface", soup});
    const auto unfolding =
        UnfoldingOrFail(*mesh, {.samples = mesh->vertex_count()});
    EXPECT_EQ(unfolding->sample_count(), mesh->vertex_count());
    const std::vector<Source> sources = {{VertexPoint{4}}};
    EXPECT_LE(
        CompareWithExact(*mesh, sources, AskOrFail(*unfolding, *mesh, sources))
            .largest,
        1e-6);
  }
}

TEST(TriangleUnfolding, ErrorsShrinkWithMoreSamples) {
  const auto mesh = BuildOrFail({"icosphere", Icosphere(3)});
  const std::vector<Source> sources = {{VertexPoint{100}}};
  double before = 1;
  for (const uint32_t samples : {20u, 80u, 320u}) {
    const double error =
        CompareWithExact(
            *mesh, sources,
            AskOrFail(*UnfoldingOrFail(*mesh, {.samples = samples}), *mesh,
                      sources))
            .mean;
    EXPECT_LE(error, before / 2) << samples;
    before = error;
  }
  EXPECT_LE(before, 0.01);
}

TEST(TriangleUnfolding, FieldsAreThoseOfPairsForAnyNumberOfThreads) {
  const auto mesh = BuildOrFail({"torus", Torus({.around = 30, .across = 20})});
  const auto one = UnfoldingOrFail(*mesh, {.samples = 40});
  const auto three = UnfoldingOrFail(*mesh, {.samples = 40, .threads = 3});
  const std::vector<double> field = AskOrFail(*one, *mesh, {{VertexPoint{9}}});
  EXPECT_EQ(AskOrFail(*three, *mesh, {{VertexPoint{9}}}), field);
  for (uint32_t v = 0; v < field.size(); ++v) {
    EXPECT_EQ(one->Distance(9, v), field[v]);
  }
}

TEST(TriangleUnfolding, RefusesByName) {
  const auto mesh = BuildOrFail(
      {"three spheres", Join(Join(Icosphere(1), Icosphere(1)), Icosphere(1))});
  for (const TriangleUnfoldingOptions& options :
       {TriangleUnfoldingOptions{.samples = 0},
        {.samples = 20001},
        {.threads = 0},
        {.threads = 257}}) {
    EXPECT_TRUE(absl::IsInvalidArgument(StatusOf(*mesh, options)));
  }
  const absl::Status status = StatusOf(*mesh, {.samples = 2});
  EXPECT_TRUE(absl::IsInvalidArgument(status));
  EXPECT_TRUE(absl::StrContains(std::string(status.message()),
                                "more components than the 2 samples"));
  EXPECT_TRUE(StatusOf(*mesh, {.samples = 3}).ok());
}

TEST(TriangleUnfolding, StopsInAnyThread) {
  const auto mesh = BuildOrFail({"sphere", Icosphere(3)});
  RecordingCheckpoint cancel(30);
  EXPECT_EQ(
      TriangleUnfolding::Prepare(*mesh, {.samples = 50, .threads = 3}, cancel)
          .status(),
      RecordingCheckpoint::Stopped());
}

}  // namespace
}  // namespace geodesic::test
