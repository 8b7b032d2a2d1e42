// Chen-Han by levels: the exact field, whatever the number of threads.

#include "geodesic/parallel_chen_han.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "geodesic/solve.h"
#include "tests/support/checkpoints.h"
#include "tests/support/field_check.h"
#include "tests/support/meshes/curved_meshes.h"
#include "tests/support/meshes/mesh_edits.h"
#include "tests/support/meshes/planar_meshes.h"

namespace geodesic {
namespace {

using test::BuildOrFail;
using test::NamedMesh;

std::vector<NamedMesh> Scenes() {
  return {
      {"icosphere", test::Icosphere(3)},
      {"noisy torus", test::Torus({.around = 40, .across = 20, .noise = 0.05})},
      {"terrain", test::Terrain(25, 25, 1, 3)},
      {"saddles", test::HyperbolicGrid(20, 20, 1)},
      {"open grid", test::MakeGrid({.columns = 30, .rows = 20})},
      {"flipped edges", test::FlipEdges(test::Terrain(20, 20, 1, 4), 40, 5)},
      {"two parts",
       test::Join(test::Icosphere(2), test::Torus({.around = 12}))}};
}

ValidQuery Ask(const Mesh& mesh, std::vector<Source> sources) {
  return *ValidQuery::Make({.sources = std::move(sources)}, mesh);
}

absl::StatusOr<DistanceField> ByLevels(const Mesh& mesh,
                                       const ValidQuery& query,
                                       const ParallelChenHanOptions& options) {
  NoCheckpoint checkpoint;
  return SolveByLevels(mesh, query, options, checkpoint);
}

TEST(ParallelChenHanTest, GivesWhatOthersGive) {
  for (const NamedMesh& scene : Scenes()) {
    const auto mesh = BuildOrFail(scene);
    for (const std::vector<Source>& sources :
         {std::vector<Source>{{VertexPoint{0}}},
          std::vector<Source>{{VertexPoint{3}}, {VertexPoint{40}, 0.1}}}) {
      const absl::StatusOr<DistanceField> field =
          ByLevels(*mesh, Ask(*mesh, sources), {});
      ASSERT_TRUE(field.ok()) << scene.name << ": " << field.status();
      EXPECT_TRUE(test::FieldsAgree(
          {scene.name, sources, "pch"},
          test::SolveOrFail(*mesh, Algorithm::kFwpMmp, sources),
          field->distances));
      EXPECT_EQ(field->settled_radius, std::numeric_limits<double>::infinity());
    }
  }
}

TEST(ParallelChenHanTest, IsStraightInThePlane) {
  const TriangleSoup soup = test::MakeGrid({.columns = 25, .rows = 25});
  const auto mesh = BuildOrFail({"grid", soup});
  const absl::StatusOr<DistanceField> field =
      ByLevels(*mesh, Ask(*mesh, {{VertexPoint{7}}}), {.threads = 2});
  ASSERT_TRUE(field.ok()) << field.status();
  for (uint32_t v = 0; v < mesh->vertex_count(); ++v) {
    const Point& p = soup.positions[v];
    const Point& q = soup.positions[7];
    const double expected = std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
    EXPECT_NEAR(field->distances[v], expected, 1e-12);
  }
}

TEST(ParallelChenHanTest, ThreadsChangeNoBit) {
  std::vector<NamedMesh> scenes = Scenes();
  scenes.push_back({"wide", test::Terrain(60, 60, 2, 3)});
  uint64_t widest = 0;
  for (const NamedMesh& scene : scenes) {
    const auto mesh = BuildOrFail(scene);
    const ValidQuery query = Ask(*mesh, {{VertexPoint{5}}});
    const absl::StatusOr<DistanceField> alone = ByLevels(*mesh, query, {});
    ASSERT_TRUE(alone.ok()) << scene.name;
    widest = std::max(widest, alone->statistics.peak_windows);
    for (const uint32_t threads : {2, 5}) {
      const absl::StatusOr<DistanceField> shared =
          ByLevels(*mesh, query, {.threads = threads});
      ASSERT_TRUE(shared.ok()) << scene.name;
      EXPECT_EQ(shared->distances, alone->distances) << scene.name;
      EXPECT_EQ(shared->statistics.windows_created,
                alone->statistics.windows_created);
    }
  }
  EXPECT_GT(widest, 1000) << "no level is shared among threads";
}

TEST(ParallelChenHanTest, MemoryAndCheckpointsEndIt) {
  const auto mesh = BuildOrFail({"terrain", test::Terrain(40, 40, 1, 3)});
  const ValidQuery query = Ask(*mesh, {{VertexPoint{0}}});
  const absl::Status refused =
      ByLevels(*mesh, query, {.most_bytes = 500'000}).status();
  EXPECT_TRUE(absl::IsResourceExhausted(refused)) << refused;
  EXPECT_NE(refused.message().find("pch"), std::string::npos) << refused;
  for (const uint64_t poll : {0, 2}) {
    test::RecordingCheckpoint checkpoint(poll);
    EXPECT_EQ(SolveByLevels(*mesh, query, {}, checkpoint).status(),
              test::RecordingCheckpoint::Stopped());
  }
}

TEST(ParallelChenHanTest, RefusesWhatTheRuleDoesNotTake) {
  const auto mesh = BuildOrFail({"sphere", test::Icosphere(1)});
  const auto expect_refusal = [](const absl::Status& status) {
    EXPECT_TRUE(absl::IsInvalidArgument(status)) << status;
    EXPECT_NE(status.message().find("pch"), std::string::npos) << status;
  };
  expect_refusal(
      ByLevels(*mesh, Ask(*mesh, {{FacePoint{0, {0.2, 0.3, 0.5}}}}), {})
          .status());
  const auto book = BuildOrFail(
      {"book", test::Book(test::MakeGrid({.columns = 3, .rows = 3}), 3)});
  expect_refusal(ByLevels(*book, Ask(*book, {{VertexPoint{0}}}), {}).status());
  EXPECT_TRUE(absl::IsInvalidArgument(
      ByLevels(*mesh, Ask(*mesh, {{VertexPoint{0}}}), {.threads = 0})
          .status()));
}

}  // namespace
}  // namespace geodesic
