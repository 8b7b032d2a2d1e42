// Cancellation, progress and limits: everything that comes through Checkpoint,
// the settled vertices among it.

#include "geodesic/checkpoint.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "absl/status/status.h"
#include "geodesic/computation.h"
#include "geodesic/solve.h"
#include "tests/core/exactness/every_algorithm.h"
#include "tests/support/checkpoints.h"
#include "tests/support/meshes/curved_meshes.h"
#include "tests/support/meshes/mesh_edits.h"
#include "tests/support/random.h"

namespace geodesic::test {
namespace {

class CheckpointTest : public EveryAlgorithm {
 protected:
  Query query() const { return Ask({.sources = {{VertexPoint{5}}}}); }

  const std::shared_ptr<const Mesh> mesh_ =
      *Mesh::Build(Terrain(60, 60, 1.0, 7));
};

TEST_P(CheckpointTest, StopsAtWhicheverPollSaysSo) {
  for (size_t poll : {0, 1, 2, 5}) {
    RecordingCheckpoint checkpoint(poll);
    const auto field = Solve(*mesh_, query(), {}, checkpoint);
    EXPECT_EQ(field.status(), RecordingCheckpoint::Stopped());
    EXPECT_EQ(checkpoint.polls().size(), poll + 1);
  }
}

TEST_P(CheckpointTest, ProgressGrowsToTheEnd) {
  RecordingCheckpoint checkpoint;
  const auto field = Solve(*mesh_, query(), {}, checkpoint).value();
  const std::vector<Progress>& polls = checkpoint.polls();
  ASSERT_GT(polls.size(), 5u);
  for (size_t i = 1; i < polls.size(); ++i) {
    EXPECT_GE(polls[i].settled_radius, polls[i - 1].settled_radius);
    EXPECT_GE(polls[i].vertices_reached, polls[i - 1].vertices_reached);
    EXPECT_GE(polls[i].windows_propagated, polls[i - 1].windows_propagated);
    EXPECT_GT(polls[i].solver_bytes, 0u);
  }
  EXPECT_EQ(polls.front().vertices_reached, 0u);
  EXPECT_EQ(polls.back().vertices_reached, mesh_->vertex_count());
  EXPECT_EQ(polls.back().vertices, mesh_->vertex_count());
  EXPECT_EQ(polls.back().live_windows, 0u);
  EXPECT_EQ(polls.back().windows_propagated,
            field.statistics.windows_propagated);
}

// What a client is told while the wavefront moves must be true: no distance
// below the settled radius changes any more.
TEST_P(CheckpointTest, SettledRadiusNeverPassesAVertexStillToBeReached) {
  RecordingCheckpoint checkpoint;
  const auto field = Solve(*mesh_, query(), {}, checkpoint).value();
  for (const Progress& progress : checkpoint.polls()) {
    uint64_t within = 0;
    for (double distance : field.distances) {
      within += distance < progress.settled_radius * (1 - 1e-12);
    }
    EXPECT_LE(within, progress.vertices_reached);
  }
}

// Lists of windows are long where many pseudo-sources see the same edges.
TEST(Checkpoint, IsAskedOftenWhereListsAreLong) {
  const std::shared_ptr<const Mesh> row =
      *Mesh::Build(SaddleRow(900, 1e-3, 30));
  for (const Algorithm algorithm : {Algorithm::kFwpList, Algorithm::kMmp}) {
    WindowLimit checkpoint(100'000'000);
    ASSERT_TRUE(Solve(*row,
                      {.sources = {{VertexPoint{1}}}, .algorithm = algorithm},
                      {}, checkpoint)
                    .ok());
    EXPECT_LT(checkpoint.most_between_polls(), 10'000);
  }
}

// All triangles of ten points that lie all but in line: tens of thousands of
// windows wait at some half-edges.
TEST(Checkpoint, IsAskedOftenWhereWindowsFallToPieces) {
  constexpr uint32_t kPoints = 10;
  constexpr double kBeside = 1e-9;
  Random random(6);
  TriangleSoup soup;
  for (uint32_t i = 0; i < kPoints; ++i) {
    Point& p = soup.positions.emplace_back();
    p[0] = random.Uniform(0, 1);
    p[1] = random.Uniform(0, kBeside);
    p[2] = random.Uniform(0, kBeside);
    for (uint32_t j = 0; j < i; ++j) {
      for (uint32_t k = 0; k < j; ++k) soup.triangles.push_back({k, j, i});
    }
  }
  WindowLimit checkpoint(1'000'000);
  const auto field =
      Solve(**Mesh::Build(soup), {.sources = {{FacePoint{0, {0.3, 0.3, 0.4}}}}},
            {}, checkpoint);
  EXPECT_TRUE(absl::IsResourceExhausted(field.status()));
  EXPECT_LT(checkpoint.most_between_polls(), 600'000);
}

// Of very many sources in one face each passes the windows of those before.
TEST_P(CheckpointTest, IsAskedWhileSourcesAreEntered) {
  constexpr int kSources = 600;
  Random random(3);
  Query query = Ask({});
  for (int i = 0; i < kSources; ++i) {
    const double u = random.Uniform(0.1, 0.5), v = random.Uniform(0.1, 0.4);
    query.sources.push_back({FacePoint{7, {u, v, 1 - u - v}}});
  }
  const ValidQuery valid = *ValidQuery::Make(query, *mesh_);
  RecordingCheckpoint whole;
  const auto field = Solve(*mesh_, query, {}, whole).value();
  const auto entering = [](const Progress& progress) {
    return progress.windows_propagated == 0;
  };
  EXPECT_GE(std::ranges::count_if(whole.polls(), entering), kSources / 50);

  const auto computation = StartComputation(*mesh_, valid, {}).value();
  RecordingCheckpoint stopped(5);
  EXPECT_EQ(computation->Advance({}, stopped), RecordingCheckpoint::Stopped());
  EXPECT_EQ(stopped.polls().back().windows_propagated, 0);
  EXPECT_EQ(stopped.polls().back().settled_radius, 0);
  EXPECT_TRUE(std::ranges::all_of(computation->Field().distances,
                                  [](double d) { return std::isinf(d); }));
  ASSERT_TRUE(computation->Advance({}, stopped).ok());
  EXPECT_EQ(computation->Field().distances, field.distances);
}

TEST_P(CheckpointTest, RepeatsBitForBit) {
  NoCheckpoint checkpoint;
  const auto first = Solve(*mesh_, query(), {}, checkpoint);
  const auto second = Solve(*mesh_, query(), {}, checkpoint);
  ASSERT_TRUE(first.ok() && second.ok());
  EXPECT_EQ(first->distances, second->distances);
  EXPECT_EQ(first->statistics.windows_created,
            second->statistics.windows_created);
}

TEST_P(CheckpointTest, StatisticsAddUp) {
  NoCheckpoint checkpoint;
  const auto field = Solve(*mesh_, query(), {}, checkpoint).value();
  const SolveStatistics& statistics = field.statistics;
  EXPECT_GT(statistics.windows_created, mesh_->face_count());
  EXPECT_LE(statistics.windows_propagated, statistics.windows_created);
  EXPECT_GT(statistics.iterations, 0u);
  EXPECT_GE(statistics.peak_wavefront, statistics.mean_wavefront);
  EXPECT_GE(statistics.peak_solver_bytes, 8 * mesh_->vertex_count());
  EXPECT_GT(statistics.solve_seconds, 0);
}

TEST(SolverBytesTest, CountWhatAVertexOfManyFacesTakes) {
  constexpr uint32_t kSpokes = 50'000;
  TriangleSoup soup{.positions = {{0, 0, 0}}};
  for (uint32_t i = 0; i <= kSpokes; ++i) {
    const double angle = 6.0 * i / kSpokes;
    soup.positions.push_back({std::cos(angle), std::sin(angle), i % 2 * 0.001});
    if (i > 0) soup.triangles.push_back({0, i, i + 1});
  }
  const auto mesh = Mesh::Build(std::move(soup)).value();
  const auto field = Solve(*mesh, {.sources = {{VertexPoint{0}}}}).value();
  // Of each spoke a path to its end, and a list that goes on.
  EXPECT_GT(field.statistics.peak_solver_bytes, 64 * kSpokes);
}

// The certified frontier: every vertex once, in order, final when given out.
TEST_P(CheckpointTest, SettledVerticesComeOnceInOrder) {
  const auto mesh =
      *Mesh::Build(AddIsolatedVertices(Terrain(30, 30, 1.0, 5), 2));
  SettledCheckpoint checkpoint(*mesh);
  const DistanceField field =
      Solve(*mesh, Ask({.sources = {{VertexPoint{17}}}}), {}, checkpoint)
          .value();
  ASSERT_EQ(checkpoint.settled.size(), mesh->vertex_count() - 2);
  EXPECT_GT(checkpoint.early, 0u);
  EXPECT_EQ(checkpoint.settled[0].vertex, 17u);
  std::vector<bool> seen(mesh->vertex_count());
  for (size_t i = 0; i < checkpoint.settled.size(); ++i) {
    const auto& [vertex, distance] = checkpoint.settled[i];
    EXPECT_FALSE(seen[vertex]) << vertex;
    seen[vertex] = true;
    EXPECT_EQ(distance, field.distances[vertex]);
    if (i > 0) {
      EXPECT_GE(distance, checkpoint.settled[i - 1].distance);
    }
  }
}

GEODESIC_TEST_EVERY_ALGORITHM(CheckpointTest);

TEST(SolveOptionsTest, RefusesWhatMakesNoSense) {
  const auto mesh = *Mesh::Build(Terrain(3, 3, 1.0, 1));
  NoCheckpoint checkpoint;
  for (const SolveOptions& options :
       {SolveOptions{.bucket_width = 0}, SolveOptions{.bucket_width = -1},
        SolveOptions{.bucket_width = std::nan("")},
        SolveOptions{.max_batch = 0}}) {
    EXPECT_TRUE(absl::IsInvalidArgument(
        Solve(*mesh, {.sources = {{VertexPoint{0}}}}, options, checkpoint)
            .status()));
  }
}

}  // namespace
}  // namespace geodesic::test
