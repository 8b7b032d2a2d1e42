#include "server/engine/jobs/solo_job.h"

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <new>
#include <vector>

#include "server/engine/base/status_details.h"
#include "tests/engine/fakes.h"

namespace geodesic::server {
namespace {

using std::chrono::milliseconds;

// What was heard of a job.
struct Told {
  std::vector<Progress> seen;
  int calls = 0;
  JobReport report;
};

class SoloJobTest : public ::testing::Test {
 protected:
  ~SoloJobTest() override {
    scheduler_.StopAll();
    executor_.RunAll();
  }

  absl::StatusOr<SoloJobs::Call> Start(
      absl::AnyInvocable<absl::Status(Checkpoint&)> work) {
    return Start({.work = [work = std::move(work)](Checkpoint& checkpoint,
                                                   ByteReservation) mutable {
      return work(checkpoint);
    }});
  }
  absl::StatusOr<SoloJobs::Call> Start(SoloJob job) {
    return Start(jobs_, std::move(job));
  }
  absl::StatusOr<SoloJobs::Call> Start(SoloJobs& jobs, SoloJob job) {
    job.done = [told = told_](const JobReport& report) {
      ++told->calls;
      told->report = report;
    };
    job.progress = [told = told_](const Progress& progress) {
      told->seen.push_back(progress);
    };
    return jobs.Start(std::move(job));
  }

  test::FakeClock clock_;
  test::ManualExecutor executor_;
  std::shared_ptr<ByteBudget> memory_ =
      std::make_shared<ByteBudget>("solver memory", 1 << 20);
  std::shared_ptr<Told> told_ = std::make_shared<Told>();
  Scheduler scheduler_{executor_, /*max_running=*/1, /*max_queued=*/1};
  SoloJobs jobs_{clock_, scheduler_, memory_, milliseconds(50)};
};

TEST_F(SoloJobTest, PlannedMemoryIsTakenBeforeTheWork) {
  uint64_t used = 0;
  uint64_t for_answer = 0;
  const auto start = [&](uint64_t planned_bytes, uint64_t answer_bytes) {
    return Start(SoloJob{.planned_bytes = planned_bytes,
                         .answer_bytes = answer_bytes,
                         .work =
                             [&](Checkpoint&, ByteReservation answer) {
                               used = memory_->used();
                               for_answer = answer.bytes();
                               return absl::OkStatus();
                             }})
        .status();
  };
  ASSERT_TRUE(start(1000, 200).ok());
  executor_.RunAll();
  EXPECT_EQ(used, 1200);
  EXPECT_EQ(for_answer, 200);
  EXPECT_EQ(memory_->used(), 0);
  // What can never be had is refused before it waits.
  const absl::Status status = start(memory_->capacity() - 10, 11);
  EXPECT_TRUE(absl::IsResourceExhausted(status));
  EXPECT_FALSE(RetryAfter(status).has_value());
  EXPECT_EQ(scheduler_.queued(), 0);
  EXPECT_EQ(told_->calls, 1);
}

TEST_F(SoloJobTest, WaitsForMemoryThatOthersHold) {
  Scheduler wide(executor_, /*max_running=*/2, /*max_queued=*/2);
  SoloJobs jobs(clock_, wide, memory_, milliseconds(50));
  const uint64_t most = memory_->capacity() / 2 + 1;
  std::vector<int> ran;
  const auto start = [&](int number, std::function<void()> work) {
    const auto call = Start(
        jobs, {.planned_bytes = most,
               .work = [&ran, number, work](Checkpoint&, ByteReservation) {
                 ran.push_back(number);
                 work();
                 return absl::OkStatus();
               }});
    EXPECT_TRUE(call.ok());
  };
  // While the first runs, the second thread finds no memory for the second.
  start(1, [&] {
    start(2, [] {});
    executor_.RunAll();
    EXPECT_EQ(ran, std::vector<int>{1});
    EXPECT_EQ(wide.running(), 1);
    EXPECT_EQ(wide.queued(), 1);
  });
  executor_.RunAll();
  EXPECT_EQ(ran, (std::vector<int>{1, 2}));
  EXPECT_TRUE(told_->report.status.ok());
  EXPECT_EQ(memory_->used(), 0);
}

TEST_F(SoloJobTest, ReportsHowItWent) {
  ASSERT_TRUE(Start([&](Checkpoint& checkpoint) {
                clock_.Advance(milliseconds(1500));
                return checkpoint.Poll({.windows_propagated = 42});
              }).ok());
  EXPECT_EQ(told_->calls, 0);
  executor_.RunAll();
  EXPECT_EQ(told_->calls, 1);
  EXPECT_TRUE(told_->report.status.ok());
  EXPECT_EQ(told_->report.seconds, 1.5);
  EXPECT_EQ(told_->report.windows_propagated, 42);
  EXPECT_EQ(told_->seen.size(), 1);
  // Nothing holds the callbacks any more.
  EXPECT_EQ(told_.use_count(), 1);
}

TEST_F(SoloJobTest, ExceptionsBecomeStatuses) {
  ASSERT_TRUE(
      Start([](Checkpoint&) -> absl::Status { throw std::bad_alloc(); }).ok());
  executor_.RunAll();
  EXPECT_TRUE(absl::IsResourceExhausted(told_->report.status));
}

}  // namespace
}  // namespace geodesic::server
