// Cancellation, progress and limits: everything that comes through Checkpoint.

#include "geodesic/checkpoint.h"

#include <cmath>
#include <memory>
#include <vector>

#include "absl/status/status.h"
#include "geodesic/solve.h"
#include "gtest/gtest.h"
#include "tests/support/curved_meshes.h"

namespace geodesic {
namespace {

class RecordingCheckpoint final : public Checkpoint {
 public:
  explicit RecordingCheckpoint(size_t stop_at = SIZE_MAX) : stop_at_(stop_at) {}

  absl::Status Poll(const Progress& progress) override {
    polls_.push_back(progress);
    if (polls_.size() > stop_at_) return absl::CancelledError("stopped here");
    return absl::OkStatus();
  }

  const std::vector<Progress>& polls() const { return polls_; }

 private:
  const size_t stop_at_;
  std::vector<Progress> polls_;
};

class CheckpointTest : public ::testing::TestWithParam<AlgorithmInfo> {
 protected:
  CheckpointTest() : mesh_(*Mesh::Build(test::Terrain(60, 60, 1.0, 7))) {}

  Query query() const {
    return {.sources = {{VertexPoint{5}}}, .algorithm = GetParam().algorithm};
  }

  std::shared_ptr<const Mesh> mesh_;
};

TEST_P(CheckpointTest, StopsAtWhicheverPollSaysSo) {
  for (size_t poll : {0, 1, 2, 5}) {
    RecordingCheckpoint checkpoint(poll);
    const auto field = Solve(*mesh_, query(), {}, checkpoint);
    EXPECT_EQ(field.status(), absl::CancelledError("stopped here"));
    EXPECT_EQ(checkpoint.polls().size(), poll + 1);
  }
}

TEST_P(CheckpointTest, ProgressGrowsToTheEnd) {
  RecordingCheckpoint checkpoint;
  const auto field = Solve(*mesh_, query(), {}, checkpoint);
  ASSERT_TRUE(field.ok());
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
            field->statistics.windows_propagated);
}

// What a client is told while the wavefront moves must be true: no distance
// below the settled radius changes any more.
TEST_P(CheckpointTest, SettledRadiusNeverPassesAVertexStillToBeReached) {
  RecordingCheckpoint checkpoint;
  const auto field = Solve(*mesh_, query(), {}, checkpoint);
  ASSERT_TRUE(field.ok());
  for (const Progress& progress : checkpoint.polls()) {
    uint64_t within = 0;
    for (double distance : field->distances) {
      within += distance < progress.settled_radius * (1 - 1e-12);
    }
    EXPECT_LE(within, progress.vertices_reached);
  }
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
  const auto field = Solve(*mesh_, query(), {}, checkpoint);
  ASSERT_TRUE(field.ok());
  const SolveStatistics& statistics = field->statistics;
  EXPECT_GT(statistics.windows_created, mesh_->face_count());
  EXPECT_LE(statistics.windows_propagated, statistics.windows_created);
  EXPECT_GT(statistics.iterations, 0u);
  EXPECT_GE(statistics.peak_wavefront, statistics.mean_wavefront);
  EXPECT_GE(statistics.peak_solver_bytes, 8 * mesh_->vertex_count());
  EXPECT_GT(statistics.solve_seconds, 0);
}

INSTANTIATE_TEST_SUITE_P(
    Algorithms, CheckpointTest, ::testing::ValuesIn(kAlgorithms),
    [](const ::testing::TestParamInfo<AlgorithmInfo>& tested) {
      std::string name(tested.param.name);
      std::erase(name, '-');
      return name;
    });

TEST(SolveOptionsTest, RefusesWhatMakesNoSense) {
  const auto mesh = *Mesh::Build(test::Terrain(3, 3, 1.0, 1));
  NoCheckpoint checkpoint;
  for (double width : {0.0, -1.0, std::nan("")}) {
    EXPECT_EQ(Solve(*mesh, {.sources = {{VertexPoint{0}}}},
                    {.bucket_width = width}, checkpoint)
                  .status()
                  .code(),
              absl::StatusCode::kInvalidArgument);
  }
  EXPECT_EQ(Solve(*mesh, {.sources = {{VertexPoint{0}}}}, {.max_batch = 0},
                  checkpoint)
                .status()
                .code(),
            absl::StatusCode::kInvalidArgument);
}

}  // namespace
}  // namespace geodesic
