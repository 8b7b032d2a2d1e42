#include "server/engine/solo_job.h"

#include <gtest/gtest.h>

#include <memory>
#include <new>
#include <optional>
#include <vector>

#include "tests/engine/fakes.h"

namespace geodesic::server {
namespace {

using std::chrono::milliseconds;

class RecordingJobObserver final : public JobObserver {
 public:
  void OnProgress(const Progress& progress) override {
    seen.push_back(progress);
  }
  void OnDone(const JobReport& r) override {
    ++calls;
    report = r;
  }

  std::vector<Progress> seen;
  int calls = 0;
  std::optional<JobReport> report;
};

class SoloJobTest : public ::testing::Test {
 protected:
  ~SoloJobTest() override {
    scheduler_.StopAll();
    executor_.RunAll();
  }

  absl::StatusOr<SoloJobs::Call> Start(
      absl::AnyInvocable<absl::Status(Checkpoint&)> work,
      TimePoint deadline = kNoDeadline) {
    return jobs_.Start({.deadline = deadline, .work = std::move(work)},
                       observer_);
  }

  test::FakeClock clock_;
  test::ManualExecutor executor_;
  std::shared_ptr<ByteBudget> memory_ =
      std::make_shared<ByteBudget>("solver memory", 1 << 20);
  std::shared_ptr<RecordingJobObserver> observer_ =
      std::make_shared<RecordingJobObserver>();
  Scheduler scheduler_{executor_, /*max_running=*/1, /*max_queued=*/1};
  SoloJobs jobs_{clock_, scheduler_, memory_, milliseconds(50)};
};

TEST_F(SoloJobTest, PlannedMemoryIsTakenBeforeTheWork) {
  uint64_t used = 0;
  const auto start = [&](uint64_t planned_bytes) {
    return jobs_
        .Start({.planned_bytes = planned_bytes,
                .work =
                    [&](Checkpoint&) {
                      used = memory_->used();
                      return absl::OkStatus();
                    }},
               observer_)
        .ok();
  };
  ASSERT_TRUE(start(1000));
  executor_.RunAll();
  EXPECT_EQ(used, 1000);
  EXPECT_EQ(memory_->used(), 0);
  used = 0;
  ASSERT_TRUE(start(memory_->capacity() + 1));
  executor_.RunAll();
  EXPECT_EQ(used, 0);
  EXPECT_TRUE(absl::IsResourceExhausted(observer_->report->status));
}

TEST_F(SoloJobTest, ReportsHowItWent) {
  ASSERT_TRUE(Start([&](Checkpoint& checkpoint) {
                clock_.Advance(milliseconds(1500));
                return checkpoint.Poll({.windows_propagated = 42});
              }).ok());
  EXPECT_EQ(observer_->calls, 0);
  executor_.RunAll();
  EXPECT_EQ(observer_->calls, 1);
  EXPECT_TRUE(observer_->report->status.ok());
  EXPECT_EQ(observer_->report->seconds, 1.5);
  EXPECT_EQ(observer_->report->windows_propagated, 42);
  EXPECT_EQ(observer_->seen.size(), 1);
  // Nothing holds the observer any more.
  EXPECT_EQ(observer_.use_count(), 1);
}

TEST_F(SoloJobTest, CancelInTheQueueNeverRuns) {
  bool ran = false;
  const auto call = Start([&](Checkpoint&) {
    ran = true;
    return absl::OkStatus();
  });
  jobs_.Cancel(*call);
  executor_.RunAll();
  EXPECT_FALSE(ran);
  EXPECT_EQ(observer_->calls, 0);
  EXPECT_EQ(observer_.use_count(), 1);
}

TEST_F(SoloJobTest, CancelWhileItRunsStopsAtTheNextPoll) {
  absl::StatusOr<SoloJobs::Call> call;
  int polls = 0;
  call = Start([&](Checkpoint& checkpoint) {
    for (;; ++polls) {
      if (polls == 3) jobs_.Cancel(*call);
      absl::Status status = checkpoint.Poll({});
      if (!status.ok()) return status;
    }
  });
  executor_.RunAll();
  EXPECT_EQ(polls, 3);
  EXPECT_EQ(observer_->calls, 0);
}

TEST_F(SoloJobTest, DeadlinesHoldInTheQueueAndAfter) {
  const TimePoint soon = clock_.Now() + milliseconds(10);
  ASSERT_TRUE(Start([](Checkpoint&) { return absl::OkStatus(); }, soon).ok());
  clock_.Advance(milliseconds(10));
  executor_.RunAll();
  EXPECT_TRUE(absl::IsDeadlineExceeded(observer_->report->status));
  ASSERT_TRUE(Start(
                  [&](Checkpoint& checkpoint) {
                    clock_.Advance(milliseconds(10));
                    return checkpoint.Poll({});
                  },
                  clock_.Now() + milliseconds(5))
                  .ok());
  executor_.RunAll();
  EXPECT_EQ(observer_->calls, 2);
  EXPECT_TRUE(absl::IsDeadlineExceeded(observer_->report->status));
}

TEST_F(SoloJobTest, SharesTheSolversMemory) {
  ASSERT_TRUE(Start([&](Checkpoint& checkpoint) {
                return checkpoint.Poll({.solver_bytes = 2 << 20});
              }).ok());
  executor_.RunAll();
  EXPECT_TRUE(absl::IsResourceExhausted(observer_->report->status));
  EXPECT_EQ(memory_->used(), 0);
}

TEST_F(SoloJobTest, ExceptionsBecomeStatuses) {
  ASSERT_TRUE(
      Start([](Checkpoint&) -> absl::Status { throw std::bad_alloc(); }).ok());
  executor_.RunAll();
  EXPECT_TRUE(absl::IsResourceExhausted(observer_->report->status));
}

TEST_F(SoloJobTest, AFullQueueRefuses) {
  const auto nothing = [](Checkpoint&) { return absl::OkStatus(); };
  ASSERT_TRUE(Start(nothing).ok());
  ASSERT_TRUE(Start(nothing).ok());
  EXPECT_TRUE(absl::IsResourceExhausted(Start(nothing).status()));
}

TEST_F(SoloJobTest, StoppingTellsTheObserver) {
  ASSERT_TRUE(Start([](Checkpoint&) { return absl::OkStatus(); }).ok());
  scheduler_.StopAll();
  EXPECT_TRUE(absl::IsUnavailable(observer_->report->status));
}

}  // namespace
}  // namespace geodesic::server
