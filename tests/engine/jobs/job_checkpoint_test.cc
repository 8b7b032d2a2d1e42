#include "server/engine/jobs/job_checkpoint.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "server/engine/jobs/processor_share.h"
#include "tests/engine/fakes.h"

namespace geodesic::server {
namespace {

using std::chrono::milliseconds;

constexpr uint64_t kMiB = uint64_t{1} << 20;

class RecordingWaiters final : public JobWaiters {
 public:
  absl::Status Expire(TimePoint) override { return absl::OkStatus(); }
  void Publish(const Progress& progress) override { seen.push_back(progress); }

  std::vector<Progress> seen;
};

class JobCheckpointTest : public ::testing::Test {
 protected:
  JobCheckpoint MakeCheckpoint() {
    JobCheckpoint checkpoint(waiters_, clock_, scheduler_, {},
                             milliseconds(50));
    checkpoint.Hold(*ByteReservation::Make(memory_, 0));
    return checkpoint;
  }

  test::FakeClock clock_;
  std::shared_ptr<ByteBudget> memory_ =
      std::make_shared<ByteBudget>("solver memory", 100 * kMiB);
  RecordingWaiters waiters_;
  test::ManualExecutor executor_;
  Scheduler scheduler_{executor_, /*max_running=*/1, /*max_queued=*/1};
};

TEST_F(JobCheckpointTest, AJobThatHasRunLongLetsAnotherStart) {
  bool has_ended = false;
  const auto run = [&](std::stop_token) {
    JobCheckpoint checkpoint = MakeCheckpoint();
    ASSERT_TRUE(scheduler_
                    .Submit({.client = "b",
                             .run = [&](std::stop_token) { has_ended = true; }})
                    .ok());
    for (const Duration ran :
         {Duration(0), Duration(Scheduler::kBrief - milliseconds(1))}) {
      clock_.Advance(ran);
      ASSERT_TRUE(checkpoint.Poll({}).ok());
      EXPECT_FALSE(executor_.RunOne());
    }
    clock_.Advance(milliseconds(1));
    ASSERT_TRUE(checkpoint.Poll({}).ok());
    EXPECT_TRUE(executor_.RunOne());
    EXPECT_TRUE(has_ended);
    ASSERT_TRUE(checkpoint.Poll({}).ok());
  };
  ASSERT_TRUE(scheduler_.Submit({.client = "a", .run = run}).ok());
  executor_.RunAll();
  EXPECT_TRUE(has_ended);
}

TEST_F(JobCheckpointTest, PublishesAtABoundedRate) {
  JobCheckpoint checkpoint = MakeCheckpoint();
  for (uint64_t i = 0; i < 100; ++i) {
    ASSERT_TRUE(checkpoint.Poll({.windows_propagated = i}).ok());
    clock_.Advance(milliseconds(1));
  }
  // At 0 and 50 ms of 100.
  ASSERT_EQ(waiters_.seen.size(), 2);
  EXPECT_EQ(waiters_.seen[0].windows_propagated, 0);
  EXPECT_EQ(waiters_.seen[1].windows_propagated, 50);
}

TEST_F(JobCheckpointTest, StopsASolverThatOutgrowsTheBudget) {
  {
    JobCheckpoint checkpoint = MakeCheckpoint();
    EXPECT_TRUE(checkpoint.Poll({.solver_bytes = 10 * kMiB}).ok());
    EXPECT_GE(memory_->used(), 10 * kMiB);
    EXPECT_TRUE(checkpoint.Poll({.solver_bytes = 80 * kMiB}).ok());
    const absl::Status status = checkpoint.Poll({.solver_bytes = 101 * kMiB});
    EXPECT_TRUE(absl::IsResourceExhausted(status));
    EXPECT_THAT(std::string(status.message()),
                ::testing::HasSubstr("solver memory"));
  }
  EXPECT_EQ(memory_->used(), 0);
}

}  // namespace
}  // namespace geodesic::server
