#include "server/engine/jobs/scheduler.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "server/engine/base/byte_budget.h"
#include "server/engine/base/status_details.h"
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

TEST(SchedulerRoomTest, WithoutAQueueWhatHasNoThreadIsRefused) {
  test::ManualExecutor executor;
  Scheduler scheduler(executor, /*max_running=*/2, /*max_queued=*/0);
  const auto submit = [&] {
    return scheduler.Submit({.run = [](std::stop_token) {}}).status();
  };
  for (int round = 0; round < 2; ++round) {
    EXPECT_TRUE(submit().ok());
    EXPECT_TRUE(submit().ok());
    EXPECT_EQ(submit().code(), absl::StatusCode::kResourceExhausted);
    executor.RunAll();
  }
}

TEST(SchedulerIdleTest, ThreadsThatNoJobHasOrWaitsForAreIdle) {
  test::ManualExecutor executor;
  Scheduler scheduler(executor, /*max_running=*/3, /*max_queued=*/9);
  std::vector<size_t> idle;
  std::vector<uint32_t> threads;
  const auto submit = [&] {
    ASSERT_TRUE(
        scheduler
            .Submit({.run =
                         [&](std::stop_token) {
                           idle.push_back(scheduler.idle());
                           threads.push_back(
                               WithIdleThreads({}, scheduler, 2).threads);
                         }})
            .ok());
  };
  EXPECT_EQ(scheduler.idle(), 3u);
  for (int i = 0; i < 5; ++i) submit();
  EXPECT_EQ(scheduler.idle(), 0u);
  executor.RunAll();
  EXPECT_EQ(scheduler.idle(), 3u);
  // One after the other; the last of them has the scheduler to itself.
  EXPECT_THAT(idle, ElementsAre(0, 0, 0, 1, 2));
  EXPECT_THAT(threads, ElementsAre(1, 1, 1, 2, 2));
}

TEST(SchedulerIdleTest, PreparationsRunBesideTheOthersOneAtATime) {
  test::ManualExecutor executor;
  Scheduler scheduler(executor, /*max_running=*/1, /*max_queued=*/0);
  std::vector<std::string> ran;
  const auto submit = [&](
                          std::string name, JobPriority priority,
                          std::function<void()> meanwhile = [] {}) {
    ASSERT_TRUE(
        scheduler
            .Submit({.priority = priority,
                     .is_continuation = priority == JobPriority::kPrepare,
                     .run =
                         [&ran, name, meanwhile](std::stop_token) {
                           ran.push_back(name);
                           meanwhile();
                         }})
            .ok());
  };
  submit("prepare", JobPriority::kPrepare, [&] {
    EXPECT_EQ(scheduler.running(), 1);
    EXPECT_EQ(scheduler.queued(), 0);
    EXPECT_EQ(scheduler.idle(), 1) << "it has no thread of the others";
    submit("solve", JobPriority::kSolve);
    EXPECT_TRUE(executor.RunOne());
    submit("later", JobPriority::kPrepare);
    EXPECT_FALSE(executor.RunOne()) << "one at a time";
  });
  executor.RunAll();
  EXPECT_THAT(ran, ElementsAre("prepare", "solve", "later"));
  EXPECT_TRUE(scheduler.WaitIdle(std::chrono::milliseconds(0)));
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

TEST_F(SchedulerTest, OneClientCannotFillTheQueue) {
  Scheduler wide(executor_, /*max_running=*/2, /*max_queued=*/10,
                 /*max_queued_per_client=*/3);
  const auto submit = [&](const std::string& client,
                          bool is_continuation = false) {
    Job job = NamedJob(client);
    job.client = client;
    job.is_continuation = is_continuation;
    return wide.Submit(std::move(job)).status();
  };
  // Two for the threads, three that wait.
  for (int i = 0; i < 5; ++i) ASSERT_TRUE(submit("client:many").ok());
  const absl::Status status = submit("client:many");
  EXPECT_TRUE(absl::IsResourceExhausted(status));
  EXPECT_TRUE(RetryAfter(status).has_value());
  EXPECT_EQ(ReasonOf(status), reason::kQuotaExceeded);
  EXPECT_EQ(QuotaSubject(status), "client:many");
  EXPECT_THAT(std::string(status.message()),
              HasSubstr("max_queued_jobs_per_client is 3"));
  // Others have their own share, what was begun goes on, and the server's own
  // jobs have no share.
  EXPECT_TRUE(submit("client:one").ok());
  EXPECT_TRUE(submit("client:many", /*is_continuation=*/true).ok());
  for (int i = 0; i < 6; ++i) EXPECT_TRUE(submit("").ok());
  executor_.RunAll();
  EXPECT_TRUE(submit("client:many").ok());
  executor_.RunAll();
}

// Jobs that need more than is there until others end.
class MemoryTest : public SchedulerTest {
 protected:
  Job HungryJob(const std::string& name, uint64_t bytes) {
    Job job = NamedJob(name);
    job.reserve = [this, name, bytes, memory = memory_]() -> absl::Status {
      asked_.push_back(name);
      auto taken = ByteReservation::Make(memory, bytes);
      if (!taken.ok()) return taken.status();
      held_[name] = *std::move(taken);
      return absl::OkStatus();
    };
    job.run = [this, name](std::stop_token) {
      ran_.push_back(name);
      if (while_running_[name]) while_running_[name]();
      held_.erase(name);
    };
    return job;
  }

  std::shared_ptr<ByteBudget> memory_ =
      std::make_shared<ByteBudget>("solver memory", 100);
  std::map<std::string, ByteReservation> held_;
  std::map<std::string, std::function<void()>> while_running_;
  std::vector<std::string> asked_;
  Scheduler wide_{executor_, /*max_running=*/3, /*max_queued=*/10};
};

TEST_F(MemoryTest, WhatDoesNotFitWaitsAndIsNotOvertaken) {
  ASSERT_TRUE(wide_.Submit(HungryJob("a", 60)).ok());
  ASSERT_TRUE(wide_.Submit(HungryJob("b", 60)).ok());
  ASSERT_TRUE(wide_.Submit(HungryJob("c", 10)).ok());
  while_running_["a"] = [&] {
    // The other two threads find nothing to do.
    executor_.RunAll();
    EXPECT_THAT(ran_, ElementsAre("a"));
    EXPECT_THAT(asked_, ElementsAre("a", "b", "b"));
    EXPECT_EQ(wide_.queued(), 2);
    // What is more urgent is asked first.
    Job urgent = HungryJob("urgent", 10);
    urgent.priority = JobPriority::kBuild;
    EXPECT_TRUE(wide_.Submit(std::move(urgent)).ok());
    executor_.RunAll();
    EXPECT_THAT(ran_, ElementsAre("a", "urgent"));
  };
  executor_.RunAll();
  EXPECT_THAT(ran_, ElementsAre("a", "urgent", "b", "c"));
  EXPECT_THAT(abandoned_, IsEmpty());
  EXPECT_EQ(memory_->used(), 0);
}

TEST_F(MemoryTest, WhoWaitedBehindADroppedJobGoesOn) {
  absl::StatusOr<Scheduler::JobId> large;
  while_running_["a"] = [&] {
    executor_.RunAll();
    EXPECT_THAT(ran_, ElementsAre("a"));
    wide_.Cancel(*large);
    executor_.RunAll();
    EXPECT_THAT(ran_, ElementsAre("a", "c"));
  };
  ASSERT_TRUE(wide_.Submit(HungryJob("a", 60)).ok());
  large = wide_.Submit(HungryJob("b", 60));
  ASSERT_TRUE(large.ok());
  ASSERT_TRUE(wide_.Submit(HungryJob("c", 10)).ok());
  executor_.RunAll();
  EXPECT_THAT(ran_, ElementsAre("a", "c"));
  EXPECT_EQ(memory_->used(), 0);
}

TEST_F(MemoryTest, NobodyLacksMemoryOnceTheOneWhoDidIsDropped) {
  absl::StatusOr<Scheduler::JobId> large;
  while_running_["a"] = [&] {
    executor_.RunAll();
    EXPECT_TRUE(wide_.lacks_memory());
    wide_.Cancel(*large);
    EXPECT_FALSE(wide_.lacks_memory());
  };
  ASSERT_TRUE(wide_.Submit(HungryJob("a", 60)).ok());
  large = wide_.Submit(HungryJob("b", 60));
  ASSERT_TRUE(large.ok());
  executor_.RunAll();
  EXPECT_THAT(ran_, ElementsAre("a"));
}

TEST_F(MemoryTest, WhatIsRefusedDoesNotCountAsRunning) {
  Scheduler narrow(executor_, /*max_running=*/1, /*max_queued=*/10);
  for (const uint64_t bytes : {101, 10}) {
    Job job = HungryJob(std::to_string(bytes), bytes);
    job.client = "one";
    ASSERT_TRUE(narrow.Submit(std::move(job)).ok());
    executor_.RunAll();
  }
  EXPECT_THAT(abandoned_, ElementsAre("101"));
  EXPECT_THAT(ran_, ElementsAre("10"));
  EXPECT_EQ(narrow.queued(), 0);
}

TEST_F(MemoryTest, WhatNoJobWillGiveBackIsNotWaitedFor) {
  // Held by somebody who is no job: a reader that is slow.
  auto answer = ByteReservation::Make(memory_, 50);
  ASSERT_TRUE(answer.ok());
  ASSERT_TRUE(wide_.Submit(HungryJob("a", 60)).ok());
  ASSERT_TRUE(wide_.Submit(HungryJob("b", 40)).ok());
  executor_.RunAll();
  EXPECT_THAT(abandoned_, ElementsAre("a"));
  EXPECT_TRUE(absl::IsResourceExhausted(reason_));
  EXPECT_THAT(std::string(reason_.message()),
              HasSubstr("60 bytes are needed, but of the solver memory of 100 "
                        "bytes 50 are in use and 50 available"));
  EXPECT_THAT(std::string(reason_.message()), HasSubstr("solver-memory"));
  EXPECT_TRUE(RetryAfter(reason_).has_value());
  EXPECT_EQ(ReasonOf(reason_), reason::kMemoryFull);
  EXPECT_THAT(ran_, ElementsAre("b"));
  EXPECT_TRUE(wide_.WaitIdle(std::chrono::milliseconds(0)));
}

// Like a question that holds its mesh while it waits.
TEST_F(MemoryTest, ThoseWhoHoldMemoryInTheQueueGoFirst) {
  for (const char* name : {"a", "b"}) {
    Job job = NamedJob(name);
    held_[name] = *ByteReservation::Make(memory_, 50);
    job.run = [this, name](std::stop_token) {
      ran_.push_back(name);
      held_.erase(name);
    };
    ASSERT_TRUE(wide_.Submit(std::move(job)).ok());
  }
  Job large = HungryJob("large", 60);
  large.priority = JobPriority::kBuild;
  ASSERT_TRUE(wide_.Submit(std::move(large)).ok());
  ASSERT_TRUE(wide_.Submit(HungryJob("c", 30)).ok());
  executor_.RunAll();
  // As soon as there is enough, its turn comes.
  EXPECT_THAT(ran_, ElementsAre("a", "b", "large", "c"));
  EXPECT_THAT(abandoned_, IsEmpty());
}

TEST_F(MemoryTest, NobodyIsOvertakenForEver) {
  auto answer = ByteReservation::Make(memory_, 50);
  ASSERT_TRUE(answer.ok());
  ASSERT_TRUE(wide_.Submit(HungryJob("large", 60)).ok());
  // Another one comes whenever one has run.
  while_running_["small"] = [&] {
    if (ran_.size() > 1000) return;
    ASSERT_TRUE(wide_.Submit(HungryJob("small", 10)).ok());
  };
  ASSERT_TRUE(wide_.Submit(HungryJob("small", 10)).ok());
  while (abandoned_.empty() && executor_.RunOne()) {
  }
  EXPECT_THAT(abandoned_, ElementsAre("large"));
  EXPECT_LT(ran_.size(), 1000);
  executor_.RunAll();
}

TEST_F(MemoryTest, WhatCannotBeHadAtAllIsAnError) {
  Job job = HungryJob("a", 101);
  bool runs = false;
  while_running_["b"] = [&] {
    runs = true;
    ASSERT_TRUE(wide_.Submit(std::move(job)).ok());
    executor_.RunAll();
    EXPECT_THAT(abandoned_, ElementsAre("a"));
  };
  ASSERT_TRUE(wide_.Submit(HungryJob("b", 10)).ok());
  executor_.RunAll();
  EXPECT_TRUE(runs);
  EXPECT_FALSE(RetryAfter(reason_).has_value());
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

TEST_F(SchedulerTest, ARunningJobIsAskedToStop) {
  Scheduler::JobId id = 0;
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

// A job that runs twice, with memory taken before each time.
class SteppedJobTest : public SchedulerTest {
 protected:
  Job Stepped() {
    Job job = NamedJob("stepped");
    job.reserve = [this] {
      ++reserves_;
      return absl::OkStatus();
    };
    job.goes_on = [this] {
      if (at_end_) at_end_();
      return ++steps_ < 2;
    };
    return job;
  }

  int reserves_ = 0;
  int steps_ = 0;
  std::function<void()> at_end_;  // of each step
};

TEST_F(SteppedJobTest, WhatGoesOnWaitsInItsOldPlace) {
  ASSERT_TRUE(scheduler_.Submit(Stepped()).ok());
  ASSERT_TRUE(scheduler_.Submit(NamedJob("next")).ok());
  ASSERT_TRUE(scheduler_.Submit(NamedJob("build", JobPriority::kBuild)).ok());
  executor_.RunAll();
  EXPECT_THAT(ran_, ElementsAre("build", "stepped", "stepped", "next"));
  EXPECT_EQ(reserves_, 2);
  EXPECT_THAT(abandoned_, IsEmpty());
}

TEST_F(SteppedJobTest, ItIsAdmittedThoughTheQueueBeFullOrDraining) {
  at_end_ = [this] {
    if (steps_ > 0) return;
    ASSERT_TRUE(scheduler_.Submit(NamedJob("a")).ok());
    ASSERT_TRUE(scheduler_.Submit(NamedJob("b")).ok());
    EXPECT_FALSE(scheduler_.Submit(NamedJob("c")).ok());
    scheduler_.BeginDrain();
  };
  ASSERT_TRUE(scheduler_.Submit(Stepped()).ok());
  executor_.RunAll();
  EXPECT_THAT(ran_, ElementsAre("stepped", "stepped", "a", "b"));
}

TEST_F(SteppedJobTest, CancelledInAStepItHasNoOther) {
  absl::StatusOr<Scheduler::JobId> id;
  at_end_ = [&] { scheduler_.Cancel(*id); };
  id = scheduler_.Submit(Stepped());
  ASSERT_TRUE(id.ok());
  executor_.RunAll();
  EXPECT_THAT(ran_, ElementsAre("stepped"));
  EXPECT_THAT(abandoned_, IsEmpty());
  EXPECT_EQ(scheduler_.queued(), 0);
}

TEST_F(SteppedJobTest, CancelledBetweenItsStepsItIsDropped) {
  const auto id = scheduler_.Submit(Stepped());
  ASSERT_TRUE(id.ok());
  executor_.RunOne();
  EXPECT_EQ(scheduler_.queued(), 1);
  scheduler_.Cancel(*id);
  EXPECT_EQ(scheduler_.queued(), 0);
  executor_.RunAll();
  EXPECT_THAT(ran_, ElementsAre("stepped"));
  EXPECT_THAT(abandoned_, IsEmpty());
}

TEST_F(SteppedJobTest, TheEndIsTold) {
  at_end_ = [&] { scheduler_.StopAll(); };
  ASSERT_TRUE(scheduler_.Submit(Stepped()).ok());
  executor_.RunAll();
  EXPECT_THAT(ran_, ElementsAre("stepped"));
  EXPECT_THAT(abandoned_, ElementsAre("stepped"));
  EXPECT_TRUE(absl::IsUnavailable(reason_)) << reason_;
}

}  // namespace
}  // namespace geodesic::server
