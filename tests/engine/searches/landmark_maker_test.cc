// Landmarks are made in time that nobody needs, and go before anything else.

#include "server/engine/searches/landmark_maker.h"

#include <gtest/gtest.h>

#include <bit>
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "server/engine/base/status_details.h"
#include "tests/engine/engine_fixture.h"
#include "tests/support/meshes/curved_meshes.h"
#include "tests/support/meshes/planar_meshes.h"

namespace geodesic::server {
namespace {

using test::EngineTest;
using test::RecordingObserver;

class LandmarkMakerTest : public EngineTest {
 protected:
  explicit LandmarkMakerTest(Limits limits = SmallLimits())
      : EngineTest(limits) {}

  void SetUp() override { mesh_ = Make(geodesic::test::Icosphere(3)); }

  MeshHandle Make(const TriangleSoup& soup) {
    const auto uploaded = Upload(soup);
    EXPECT_TRUE(uploaded.ok()) << uploaded.status();
    return *engine_.meshes().Get(uploaded->mesh.digest);
  }

  LandmarksHandle Wanted() {
    LandmarkMaker& maker = engine_.searches().landmarks();
    maker.Want(mesh_);
    return maker.Present(*mesh_);
  }
  uint32_t Count() const {
    return engine_.meshes().landmarks().CountOf(mesh_->digest);
  }
  uint64_t Used() const { return engine_.meshes().landmarks().used_bytes(); }

  absl::StatusOr<FieldCall> AskForField(uint32_t vertex) {
    return engine_.fields().Compute(
        {.mesh_digest = mesh_->digest,
         .query = {.sources = {{VertexPoint{vertex}}}}},
        observer_);
  }

  // Calls `then` at the first poll of each computation.
  void AtEachStart(std::function<void(const ValidQuery&)> then) {
    start_ = [then = std::move(then)](const Mesh& mesh, const ValidQuery& query,
                                      const SolveOptions& options) {
      then(query);
      return StartComputation(mesh, query, options);
    };
  }

  MeshHandle mesh_;
  std::shared_ptr<RecordingObserver> observer_ =
      std::make_shared<RecordingObserver>();
};

TEST_F(LandmarkMakerTest, TheFirstQuestionGetsNoneAndLaterOnesAll) {
  EXPECT_EQ(Count(), 0);
  executor_.RunAll();
  EXPECT_EQ(Count(), 0) << "nobody wanted any";
  EXPECT_EQ(Wanted(), nullptr);
  executor_.RunAll();
  const LandmarksHandle made = Wanted();
  ASSERT_NE(made, nullptr);
  EXPECT_EQ(made->count(), Landmarks::kMost);
  EXPECT_EQ(executor_.size(), 0) << "there are enough";
  EXPECT_EQ(engine_.searches().landmarks().made(), Landmarks::kMost);
  EXPECT_EQ(engine_.solver_memory().used(), 0);

  // They are those of the library.
  NoCheckpoint checkpoint;
  const auto expected =
      MakeLandmarks(*mesh_->mesh, Landmarks::kMost, {}, checkpoint);
  for (uint32_t v = 0; v < mesh_->mesh->vertex_count(); ++v) {
    ASSERT_EQ(made->rows()[v].steps, expected->rows()[v].steps);
  }
}

TEST_F(LandmarkMakerTest, SomeAreOfUseBeforeAllAreMade) {
  Wanted();
  std::vector<uint32_t> counts;
  while (executor_.RunOne()) counts.push_back(Count());
  ASSERT_EQ(counts.size(), Landmarks::kMost);
  for (uint32_t made = 1; made <= counts.size(); ++made) {
    EXPECT_EQ(counts[made - 1], std::bit_floor(made)) << made;
  }
}

TEST_F(LandmarkMakerTest, AMeshOfFewVerticesHasFewLandmarks) {
  mesh_ = Make(test::Tetrahedron());
  Wanted();
  executor_.RunAll();
  EXPECT_EQ(Count(), 4);
  EXPECT_EQ(Wanted()->count(), 4);
  EXPECT_EQ(executor_.size(), 0);
}

TEST_F(LandmarkMakerTest, AQuestionThatComesInAStepGoesBeforeTheNext) {
  int started = 0;
  AtEachStart([&](const ValidQuery&) {
    if (++started == 1) {
      EXPECT_TRUE(AskForField(5).ok());
    }
  });
  Wanted();
  executor_.RunOne();
  EXPECT_EQ(Count(), 1);
  executor_.RunOne();
  EXPECT_EQ(observer_->calls, 1);
  EXPECT_EQ(Count(), 1);
  executor_.RunAll();
  EXPECT_EQ(Count(), Landmarks::kMost);
}

TEST_F(LandmarkMakerTest, AStepRestsWhileJobsRun) {
  // Every look at the time takes a while, so these tell how long a step takes.
  int looks = 0;
  clock_.at_look = [&] {
    ++looks;
    clock_.Advance(std::chrono::milliseconds(1));
  };
  const auto looks_of_a_step = [&] {
    const int before = looks;
    EXPECT_TRUE(executor_.RunOne());
    return looks - before;
  };
  Wanted();
  const int alone = looks_of_a_step();
  EXPECT_EQ(Count(), 1);
  int beside = 0;
  Job job{.run = [&](std::stop_token) { beside = looks_of_a_step(); }};
  EXPECT_TRUE(engine_.scheduler().Submit(std::move(job)).ok());
  EXPECT_TRUE(executor_.RunOne());
  EXPECT_EQ(Count(), 2);
  EXPECT_GT(beside, 3 * alone);
  // It works for a tenth of the time.
  EXPECT_LT(beside, 20 * alone);
  clock_.at_look = nullptr;
}

TEST_F(LandmarkMakerTest, AJobGetsTheMemoryOfAStep) {
  int started = 0;
  bool has_run = false;
  AtEachStart([&](const ValidQuery&) {
    if (++started != 1) return;
    Job job{.abandon = [](const absl::Status& why) { FAIL() << why; }};
    job.reserve = [this] {
      return engine_.solver_memory().used() == 0
                 ? absl::OkStatus()
                 : WithRetryAfter(absl::ResourceExhaustedError("all of it"),
                                  std::chrono::milliseconds(1));
    };
    job.run = [&](const std::stop_token&) { has_run = true; };
    EXPECT_TRUE(engine_.scheduler().Submit(std::move(job)).ok());
    executor_.RunOne();
    EXPECT_FALSE(has_run);
    EXPECT_TRUE(engine_.scheduler().lacks_memory());
  });
  Wanted();
  executor_.RunAll();
  EXPECT_TRUE(has_run);
  EXPECT_FALSE(engine_.scheduler().lacks_memory());
  EXPECT_EQ(started, 1);
  EXPECT_EQ(Count(), 0) << "the turn has ended";
  Wanted();
  executor_.RunAll();
  EXPECT_EQ(Count(), Landmarks::kMost);
}

TEST_F(LandmarkMakerTest, NoMoreAreMadeOfAMeshThatIsGone) {
  int started = 0;
  AtEachStart([&](const ValidQuery&) {
    if (++started == 2) {
      EXPECT_TRUE(Delete(mesh_->digest).ok());
    }
  });
  Wanted();
  executor_.RunAll();
  EXPECT_EQ(started, 2);
  EXPECT_EQ(engine_.searches().landmarks().made(), 1);
  EXPECT_EQ(Used(), 0);
  EXPECT_EQ(engine_.solver_memory().used(), 0);
}

TEST_F(LandmarkMakerTest, ThoseOfAMeshThatWentMeanwhileAreNotKept) {
  int started = 0;
  AtEachStart([&](const ValidQuery&) {
    if (++started == 3) {
      EXPECT_TRUE(Delete(mesh_->digest).ok());
    }
  });
  NoCheckpoint checkpoint;
  EXPECT_TRUE(
      *engine_.searches().landmarks().MakeNow(mesh_, /*count=*/4, checkpoint));
  EXPECT_EQ(started, 4);
  EXPECT_EQ(Used(), 0);
}

TEST_F(LandmarkMakerTest, AMeshThatWaitsIsNotPinned) {
  Wanted();
  const std::weak_ptr<const ResidentMesh> mesh = mesh_;
  EXPECT_TRUE(engine_.meshes().Delete(mesh_->digest, [](const auto&) {}).ok());
  mesh_ = nullptr;
  EXPECT_TRUE(mesh.expired());
  executor_.RunAll();
  EXPECT_EQ(engine_.searches().landmarks().made(), 0);
}

TEST_F(LandmarkMakerTest, ADrainWaitsForNone) {
  AtEachStart([&](const ValidQuery&) { engine_.scheduler().BeginDrain(); });
  Wanted();
  executor_.RunAll();
  EXPECT_EQ(engine_.searches().landmarks().made(), 0);
  EXPECT_TRUE(engine_.scheduler().WaitIdle(std::chrono::milliseconds(0)));
  EXPECT_EQ(Used(), 0);
}

class NoQueueTest : public LandmarkMakerTest {
 protected:
  static Limits NoQueue() {
    Limits limits = SmallLimits();
    limits.max_queued_jobs = 0;
    return limits;
  }
  NoQueueTest() : LandmarkMakerTest(NoQueue()) {}
};

TEST_F(NoQueueTest, AStepTakesNobodysThread) {
  int started = 0;
  AtEachStart([&](const ValidQuery&) {
    if (++started == 1) {
      const auto call = AskForField(5);
      EXPECT_TRUE(call.ok()) << call.status();
    }
  });
  Wanted();
  executor_.RunAll();
  EXPECT_EQ(observer_->calls, 1);
  EXPECT_EQ(Count(), Landmarks::kMost);
}

// Room for the landmarks of one mesh while they are made, and no more.
class LittleMemoryTest : public LandmarkMakerTest {
 protected:
  static Limits LittleMemory() {
    Limits limits = SmallLimits();
    limits.landmark_memory_bytes = 180 << 10;
    return limits;
  }
  LittleMemoryTest() : LandmarkMakerTest(LittleMemory()) {}
};

TEST_F(LittleMemoryTest, TheLeastRecentlyUsedGoFirst) {
  const MeshHandle first = mesh_;
  Wanted();
  executor_.RunAll();
  EXPECT_EQ(Count(), Landmarks::kMost);
  mesh_ = Make(geodesic::test::Torus({.around = 30, .across = 30}));
  Wanted();
  executor_.RunAll();
  EXPECT_EQ(Count(), Landmarks::kMost);
  EXPECT_EQ(engine_.meshes().landmarks().CountOf(first->digest), 0);
  EXPECT_LE(Used(), 180 << 10);
}

TEST_F(LittleMemoryTest, WhatCanNeverFitIsNotBegun) {
  mesh_ = Make(geodesic::test::Icosphere(4));
  EXPECT_EQ(Wanted(), nullptr);
  EXPECT_EQ(executor_.size(), 0);
}

}  // namespace
}  // namespace geodesic::server
