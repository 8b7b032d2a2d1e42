#include "server/engine/scheduler.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "server/engine/status_details.h"
#include "tests/engine/fakes.h"

namespace geodesic::server {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class SchedulerTest : public ::testing::Test {
 protected:
  // The scheduler's end waits for its tasks.
  ~SchedulerTest() override {
    scheduler_.StopAll();
    executor_.RunAll();
  }

  Job NamedJob(const std::string& name,
               JobPriority priority = JobPriority::kSolve) {
    return {.priority = priority,
            .run = [this, name](std::stop_token) { ran_.push_back(name); },
            .abandon =
                [this, name](const absl::Status& why) {
                  abandoned_.push_back(name);
                  reason_ = why;
                }};
  }

  test::ManualExecutor executor_;
  Scheduler scheduler_{executor_, /*max_running=*/1, /*max_queued=*/2};
  std::vector<std::string> ran_;
  std::vector<std::string> abandoned_;
  absl::Status reason_;
};

TEST_F(SchedulerTest, RunsJobsInOrder) {
  ASSERT_TRUE(scheduler_.Submit(NamedJob("a")).ok());
  ASSERT_TRUE(scheduler_.Submit(NamedJob("b")).ok());
  EXPECT_THAT(ran_, IsEmpty());
  executor_.RunAll();
  EXPECT_THAT(ran_, ElementsAre("a", "b"));
  EXPECT_THAT(abandoned_, IsEmpty());
}

TEST_F(SchedulerTest, BuildsGoBeforeSolves) {
  ASSERT_TRUE(scheduler_.Submit(NamedJob("solve")).ok());
  ASSERT_TRUE(scheduler_.Submit(NamedJob("build", JobPriority::kBuild)).ok());
  executor_.RunAll();
  EXPECT_THAT(ran_, ElementsAre("build", "solve"));
}

TEST_F(SchedulerTest, UsesNoMoreTasksThanJobsMayRun) {
  Scheduler wide(executor_, 2, 10);
  for (int i = 0; i < 5; ++i) ASSERT_TRUE(wide.Submit(NamedJob("x")).ok());
  EXPECT_EQ(executor_.size(), 2);
  executor_.RunAll();
  EXPECT_EQ(ran_.size(), 5);
}

TEST_F(SchedulerTest, RefusesWhenFullAndTakesAgainAfterwards) {
  for (const char* name : {"a", "b", "c"}) {
    ASSERT_TRUE(scheduler_.Submit(NamedJob(name)).ok());
  }
  const absl::Status status = scheduler_.Submit(NamedJob("d")).status();
  EXPECT_TRUE(absl::IsResourceExhausted(status));
  EXPECT_THAT(std::string(status.message()), HasSubstr("queue is full"));
  EXPECT_TRUE(RetryAfter(status).has_value());
  executor_.RunOne();
  EXPECT_TRUE(scheduler_.Submit(NamedJob("e")).ok());
  executor_.RunAll();
  EXPECT_THAT(ran_, ElementsAre("a", "b", "c", "e"));
}

TEST_F(SchedulerTest, AWaitingJobIsDroppedOnCancel) {
  ASSERT_TRUE(scheduler_.Submit(NamedJob("a")).ok());
  const auto b = scheduler_.Submit(NamedJob("b"));
  ASSERT_TRUE(b.ok());
  scheduler_.Cancel(*b);
  EXPECT_EQ(scheduler_.queued(), 1);
  executor_.RunAll();
  EXPECT_THAT(ran_, ElementsAre("a"));
  EXPECT_THAT(abandoned_, IsEmpty());
}

TEST_F(SchedulerTest, ADroppedJobReleasesWhatItHolds) {
  auto resource = std::make_shared<int>(1);
  const auto job = scheduler_.Submit(
      {.run = [resource](std::stop_token) {}, .abandon = [](const auto&) {}});
  ASSERT_TRUE(job.ok());
  EXPECT_EQ(resource.use_count(), 2);
  scheduler_.Cancel(*job);
  EXPECT_EQ(resource.use_count(), 1);
}

TEST_F(SchedulerTest, ARunningJobIsAskedToStop) {
  Scheduler::JobId id;
  bool before = true;
  bool after = false;
  const auto job = scheduler_.Submit({.run =
                                          [&](std::stop_token stop) {
                                            before = stop.stop_requested();
                                            scheduler_.Cancel(id);
                                            after = stop.stop_requested();
                                          },
                                      .abandon = [](const auto&) {}});
  ASSERT_TRUE(job.ok());
  id = *job;
  executor_.RunAll();
  EXPECT_FALSE(before);
  EXPECT_TRUE(after);
  scheduler_.Cancel(id);  // gone: nothing happens
}

TEST_F(SchedulerTest, TellsHowAJobSpentItsTime) {
  test::FakeClock clock;
  std::vector<JobTimes> seen;
  scheduler_.ObserveJobs(clock,
                         [&](const JobTimes& times) { seen.push_back(times); });
  const auto takes = [&](int seconds) {
    return Job{.priority = JobPriority::kBuild,
               .run = [&clock, seconds](std::stop_token) {
                 clock.Advance(std::chrono::seconds(seconds));
               }};
  };
  ASSERT_TRUE(scheduler_.Submit(takes(5)).ok());
  ASSERT_TRUE(scheduler_.Submit(takes(7)).ok());
  clock.Advance(std::chrono::seconds(1));
  executor_.RunAll();
  ASSERT_EQ(seen.size(), 2);
  EXPECT_EQ(seen[0].waited, std::chrono::seconds(1));
  EXPECT_EQ(seen[0].ran, std::chrono::seconds(5));
  EXPECT_EQ(seen[0].priority, JobPriority::kBuild);
  EXPECT_FALSE(seen[0].was_stopped);
  EXPECT_EQ(seen[1].waited, std::chrono::seconds(6));
  EXPECT_EQ(seen[1].ran, std::chrono::seconds(7));

  std::optional<Scheduler::JobId> id;
  const auto stopped = scheduler_.Submit(
      {.run = [&](std::stop_token) { scheduler_.Cancel(*id); }});
  ASSERT_TRUE(stopped.ok());
  id = *stopped;
  executor_.RunAll();
  ASSERT_EQ(seen.size(), 3);
  EXPECT_TRUE(seen[2].was_stopped);
}

TEST_F(SchedulerTest, DrainFinishesWhatWasAdmitted) {
  ASSERT_TRUE(scheduler_.Submit(NamedJob("a")).ok());
  ASSERT_TRUE(scheduler_.Submit(NamedJob("b")).ok());
  scheduler_.BeginDrain();
  EXPECT_TRUE(absl::IsUnavailable(scheduler_.Submit(NamedJob("c")).status()));
  EXPECT_FALSE(scheduler_.WaitIdle(std::chrono::milliseconds(0)));
  executor_.RunAll();
  EXPECT_TRUE(scheduler_.WaitIdle(std::chrono::milliseconds(0)));
  EXPECT_THAT(ran_, ElementsAre("a", "b"));
}

TEST_F(SchedulerTest, StopAbandonsWhatWaitsAndStopsWhatRuns) {
  bool stopped = false;
  ASSERT_TRUE(scheduler_
                  .Submit({.run =
                               [&](std::stop_token stop) {
                                 scheduler_.StopAll();
                                 stopped = stop.stop_requested();
                               },
                           .abandon = [](const auto&) {}})
                  .ok());
  ASSERT_TRUE(scheduler_.Submit(NamedJob("b")).ok());
  executor_.RunAll();
  EXPECT_TRUE(stopped);
  EXPECT_THAT(ran_, IsEmpty());
  EXPECT_THAT(abandoned_, ElementsAre("b"));
  EXPECT_TRUE(absl::IsUnavailable(reason_));
}

}  // namespace
}  // namespace geodesic::server
