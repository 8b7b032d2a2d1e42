#include "server/engine/jobs/shared_jobs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "server/engine/base/byte_budget.h"
#include "server/engine/base/status_details.h"
#include "tests/engine/fakes.h"

namespace geodesic::server {
namespace {

using std::chrono::milliseconds;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

using Jobs = SharedJobs<std::string, int, std::string>;

// What a waiter was told.
struct Told {
  std::vector<absl::StatusOr<int>> results;
  std::vector<uint64_t> progress;
};

class SharedJobsTest : public ::testing::Test {
 protected:
  ~SharedJobsTest() override {
    scheduler_.StopAll();
    executor_.RunAll();
  }

  // Asks for the work of `run`, by this key.
  absl::StatusOr<Jobs::Ticket> Join(
      const std::string& key, Told& told, TimePoint deadline = kNoDeadline,
      JobPriority priority = JobPriority::kSolve) {
    return jobs_.Join(
        key,
        {.done = [&](const auto& result) { told.results.push_back(result); },
         .progress =
             [&](const Progress& progress) {
               told.progress.push_back(progress.vertices_reached);
             },
         .deadline = deadline},
        priority, [&, key] {
          return SharedWork<int, std::string>{
              .reserve = [this] { return reserve_(); },
              .run = [this, key](JobCheckpoint& checkpoint)
                  -> absl::StatusOr<std::optional<int>> {
                started_.push_back(key);
                return run_(checkpoint);
              },
              .shared = std::make_shared<std::string>(key)};
        });
  }

  std::function<absl::Status()> reserve_ = [] { return absl::OkStatus(); };
  std::function<absl::StatusOr<std::optional<int>>(JobCheckpoint&)> run_ =
      [](JobCheckpoint&) { return 7; };
  std::vector<std::string> started_;
  Told a_;
  Told b_;
  test::FakeClock clock_;
  test::ManualExecutor executor_;
  Scheduler scheduler_{executor_, /*max_running=*/1, /*max_queued=*/1};
  Jobs jobs_{scheduler_, clock_, milliseconds(50)};
};

TEST_F(SharedJobsTest, OneJobForAllWhoAskForTheSame) {
  const auto a = Join("x", a_);
  Told other;
  const auto c = Join("y", other);
  // Though the queue is full by now.
  const auto b = Join("x", b_);
  ASSERT_TRUE(a.ok() && b.ok() && c.ok());
  EXPECT_TRUE(a->is_first);
  EXPECT_FALSE(b->is_first);
  EXPECT_TRUE(c->is_first);
  EXPECT_EQ(a->shared, b->shared);
  EXPECT_NE(a->shared, c->shared);
  EXPECT_EQ(jobs_.size(), 2);
  EXPECT_EQ(jobs_.waiters(), 3);
  executor_.RunAll();
  EXPECT_THAT(started_, ElementsAre("x", "y"));
  for (const Told* told : {&a_, &b_, &other}) {
    EXPECT_THAT(told->results, ElementsAre(absl::StatusOr<int>(7)));
  }
  EXPECT_EQ(jobs_.size(), 0);
}

TEST_F(SharedJobsTest, ErrorsReachEveryone) {
  run_ = [](JobCheckpoint&) { return absl::InternalError("broken"); };
  ASSERT_TRUE(Join("x", a_).ok());
  ASSERT_TRUE(Join("x", b_).ok());
  executor_.RunAll();
  EXPECT_TRUE(absl::IsInternal(a_.results.at(0).status()));
  EXPECT_TRUE(absl::IsInternal(b_.results.at(0).status()));
}

TEST_F(SharedJobsTest, WhoComesAfterTheEndStartsAnother) {
  ASSERT_TRUE(Join("x", a_).ok());
  executor_.RunAll();
  ASSERT_TRUE(Join("x", b_)->is_first);
  executor_.RunAll();
  EXPECT_EQ(started_.size(), 2);
  EXPECT_EQ(b_.results.size(), 1);
}

// Else whoever joins it would wait for ever.
TEST_F(SharedJobsTest, AJobThatIsRefusedIsJoinedByNobody) {
  Told other;
  ASSERT_TRUE(Join("x", other).ok());
  ASSERT_TRUE(Join("y", other).ok());
  EXPECT_TRUE(absl::IsResourceExhausted(Join("z", a_).status()));
  EXPECT_TRUE(absl::IsResourceExhausted(Join("z", b_).status()));
  EXPECT_EQ(jobs_.size(), 2);
  executor_.RunAll();
  EXPECT_THAT(a_.results, IsEmpty());
  EXPECT_THAT(b_.results, IsEmpty());
  const auto again = Join("z", b_);
  ASSERT_TRUE(again.ok()) << again.status();
  EXPECT_TRUE(again->is_first);
  executor_.RunAll();
  EXPECT_EQ(b_.results.size(), 1);
}

// However close those who ask come to the refusal.
TEST_F(SharedJobsTest, WhoAsksBesideARefusalIsRefusedToo) {
  Told other;
  ASSERT_TRUE(Join("x", other).ok());
  ASSERT_TRUE(Join("y", other).ok());
  std::atomic<int> joined = 0;
  {
    std::vector<std::jthread> threads;
    for (int i = 0; i < 4; ++i) {
      threads.emplace_back([&] {
        for (int k = 0; k < 500; ++k) {
          const auto ticket = jobs_.Join(
              "z", {.done = [](const auto&) {}}, JobPriority::kSolve, [] {
                std::this_thread::yield();  // lets the others ask
                return SharedWork<int, std::string>();
              });
          if (ticket.ok()) ++joined;
        }
      });
    }
  }
  EXPECT_EQ(joined, 0);
  EXPECT_EQ(jobs_.size(), 2);
  executor_.RunAll();
}

TEST_F(SharedJobsTest, OnlyTheLastToLeaveDropsIt) {
  const auto a = Join("x", a_);
  const auto b = Join("x", b_);
  jobs_.Leave(*a);
  jobs_.Leave(*a);  // twice is once
  EXPECT_EQ(scheduler_.queued(), 1);
  jobs_.Leave(*b);
  EXPECT_EQ(scheduler_.queued(), 0);
  EXPECT_EQ(jobs_.size(), 0);
  executor_.RunAll();
  EXPECT_THAT(started_, IsEmpty());
  EXPECT_THAT(a_.results, IsEmpty());
  jobs_.Leave({});  // who did not have to wait
}

TEST_F(SharedJobsTest, ItStopsAtTheNextPollWhenTheLastHasLeft) {
  const auto a = Join("x", a_);
  int polls = 0;
  run_ = [&](JobCheckpoint& checkpoint) -> absl::StatusOr<std::optional<int>> {
    for (;; ++polls) {
      if (polls == 3) jobs_.Leave(*a);
      absl::Status status = checkpoint.Poll({});
      if (!status.ok()) return status;
    }
  };
  executor_.RunAll();
  EXPECT_EQ(polls, 3);
  EXPECT_THAT(a_.results, IsEmpty());
}

TEST_F(SharedJobsTest, NobodyJoinsAJobThatIsToStop) {
  const auto a = Join("x", a_);
  run_ = [&](JobCheckpoint& checkpoint) -> absl::StatusOr<std::optional<int>> {
    if (started_.size() == 2) {
      EXPECT_FALSE(Join("x", a_)->is_first);
      return 8;
    }
    jobs_.Leave(*a);
    EXPECT_TRUE(Join("x", b_)->is_first);
    return checkpoint.Poll({});
  };
  executor_.RunAll();
  // The end of the one does not touch the other, which others may join.
  for (const Told* told : {&a_, &b_}) {
    EXPECT_THAT(told->results, ElementsAre(absl::StatusOr<int>(8)));
  }
}

TEST_F(SharedJobsTest, NorOneThatAllAreTooLateFor) {
  ASSERT_TRUE(Join("x", a_, clock_.Now() + milliseconds(1)).ok());
  run_ = [&](JobCheckpoint& checkpoint) -> absl::StatusOr<std::optional<int>> {
    if (started_.size() == 2) return 8;
    clock_.Advance(milliseconds(1));
    absl::Status status = checkpoint.Poll({});
    EXPECT_TRUE(Join("x", b_)->is_first);
    return status;
  };
  executor_.RunAll();
  EXPECT_TRUE(absl::IsDeadlineExceeded(a_.results.at(0).status()));
  EXPECT_THAT(b_.results, ElementsAre(absl::StatusOr<int>(8)));
}

TEST_F(SharedJobsTest, ProgressReachesThoseWhoWait) {
  const auto a = Join("x", a_);
  ASSERT_TRUE(Join("x", b_).ok());
  run_ = [&](JobCheckpoint& checkpoint) {
    checkpoint.Publish({.vertices_reached = 1});
    jobs_.Leave(*a);
    checkpoint.Publish({.vertices_reached = 2});
    return 7;
  };
  executor_.RunAll();
  EXPECT_THAT(a_.progress, ElementsAre(1));
  EXPECT_THAT(b_.progress, ElementsAre(1, 2));
}

TEST_F(SharedJobsTest, EachWaiterHasItsOwnDeadline) {
  ASSERT_TRUE(Join("x", a_, clock_.Now() + milliseconds(10)).ok());
  ASSERT_TRUE(Join("x", b_, clock_.Now() + milliseconds(20)).ok());
  run_ = [&](JobCheckpoint& checkpoint) -> absl::StatusOr<std::optional<int>> {
    clock_.Advance(milliseconds(9));
    EXPECT_TRUE(checkpoint.Poll({}).ok());
    EXPECT_THAT(a_.results, IsEmpty());
    clock_.Advance(milliseconds(1));
    EXPECT_TRUE(checkpoint.Poll({}).ok());
    EXPECT_EQ(a_.results.size(), 1);
    clock_.Advance(milliseconds(10));
    absl::Status status = checkpoint.Poll({});
    EXPECT_TRUE(absl::IsDeadlineExceeded(status));
    return status;
  };
  executor_.RunAll();
  for (const Told* told : {&a_, &b_}) {
    ASSERT_EQ(told->results.size(), 1);
    EXPECT_TRUE(absl::IsDeadlineExceeded(told->results[0].status()));
  }
}

TEST_F(SharedJobsTest, WhatIsLateInTheQueueDoesNotRun) {
  ASSERT_TRUE(Join("x", a_, clock_.Now() + milliseconds(10)).ok());
  clock_.Advance(milliseconds(10));
  executor_.RunAll();
  EXPECT_THAT(started_, IsEmpty());
  EXPECT_TRUE(absl::IsDeadlineExceeded(a_.results.at(0).status()));
}

TEST_F(SharedJobsTest, ItIsAsUrgentAsTheMostUrgentWaiter) {
  ASSERT_TRUE(Join("x", a_, kNoDeadline, JobPriority::kBatch).ok());
  Told other;
  ASSERT_TRUE(Join("y", other, kNoDeadline, JobPriority::kRow).ok());
  ASSERT_TRUE(Join("x", b_, kNoDeadline, JobPriority::kSolve).ok());
  executor_.RunAll();
  EXPECT_THAT(started_, ElementsAre("x", "y"));
}

TEST_F(SharedJobsTest, AJobWithMoreToDoRunsAgain) {
  int reserves = 0;
  reserve_ = [&] {
    ++reserves;
    return absl::OkStatus();
  };
  run_ = [&](JobCheckpoint&) -> absl::StatusOr<std::optional<int>> {
    if (started_.size() < 3) return std::nullopt;
    return 9;
  };
  ASSERT_TRUE(Join("x", a_).ok());
  executor_.RunAll();
  EXPECT_EQ(reserves, 3);
  EXPECT_THAT(a_.results, ElementsAre(absl::StatusOr<int>(9)));
}

TEST_F(SharedJobsTest, WhatItHeldIsGoneWhenTheEndIsTold) {
  const auto memory = std::make_shared<ByteBudget>("memory", 100);
  auto held =
      std::make_shared<ByteReservation>(*ByteReservation::Make(memory, 100));
  std::optional<uint64_t> used;
  ASSERT_TRUE(jobs_
                  .Join("x",
                        {.done = [&](const auto&) { used = memory->used(); }},
                        JobPriority::kSolve,
                        [&] {
                          return SharedWork<int, std::string>{
                              .reserve = [held] { return absl::OkStatus(); },
                              .run = [held = std::move(held)](
                                         JobCheckpoint&) { return 7; }};
                        })
                  .ok());
  executor_.RunAll();
  EXPECT_EQ(used, 0);
}

// An account that is counted as long as somebody holds it.
class AccountTest : public SharedJobsTest {
 protected:
  // Asks for "x"; returns who holds the client's account.
  std::weak_ptr<const void> Ask(std::optional<Jobs::Ticket>& ticket,
                                TimePoint deadline = kNoDeadline) {
    const auto account = std::make_shared<int>(0);
    ticket = *jobs_.Join(
        "x",
        {.done = [this, held = std::weak_ptr<const void>(account)](
                     const auto&) { was_held_.push_back(!held.expired()); },
         .deadline = deadline,
         .account = account},
        JobPriority::kSolve, [&] {
          return SharedWork<int, std::string>{
              .run = [this](JobCheckpoint& checkpoint)
                  -> absl::StatusOr<std::optional<int>> {
                return run_(checkpoint);
              }};
        });
    return account;
  }

  std::vector<bool> was_held_;  // when clients heard of the end
};

TEST_F(AccountTest, IsFreeWhenTheClientHearsOfTheEnd) {
  std::optional<Jobs::Ticket> ticket;
  Ask(ticket);
  executor_.RunAll();
  EXPECT_THAT(was_held_, ElementsAre(false));
}

TEST_F(AccountTest, OfTheLastWhoLeavesIsHeldUntilTheWorkEnds) {
  std::optional<Jobs::Ticket> a, b;
  const auto of_a = Ask(a), of_b = Ask(b);
  run_ = [&](JobCheckpoint& checkpoint) -> absl::StatusOr<std::optional<int>> {
    jobs_.Leave(*a);
    EXPECT_TRUE(of_a.expired()) << "the work goes on for another";
    jobs_.Leave(*b);
    EXPECT_FALSE(of_b.expired());
    return checkpoint.Poll({});
  };
  executor_.RunAll();
  EXPECT_TRUE(of_b.expired());
}

TEST_F(AccountTest, OfTheLastWhoIsLateIsHeldUntilTheWorkEnds) {
  std::optional<Jobs::Ticket> ticket;
  const auto account = Ask(ticket, clock_.Now() + milliseconds(1));
  run_ = [&](JobCheckpoint& checkpoint) -> absl::StatusOr<std::optional<int>> {
    clock_.Advance(milliseconds(1));
    absl::Status status = checkpoint.Poll({});
    EXPECT_TRUE(absl::IsDeadlineExceeded(status));
    EXPECT_FALSE(account.expired());
    return status;
  };
  executor_.RunAll();
  EXPECT_TRUE(account.expired());
}

TEST_F(AccountTest, IsFreeAtOnceWhereNothingRuns) {
  std::optional<Jobs::Ticket> ticket;
  const auto account = Ask(ticket);
  jobs_.Leave(*ticket);
  EXPECT_TRUE(account.expired());
}

TEST_F(SharedJobsTest, StoppingTellsThoseWhoWait) {
  run_ = [&](JobCheckpoint& checkpoint) -> absl::StatusOr<std::optional<int>> {
    scheduler_.StopAll();
    return checkpoint.Poll({});
  };
  ASSERT_TRUE(Join("x", a_).ok());
  ASSERT_TRUE(Join("y", b_).ok());
  executor_.RunAll();
  EXPECT_TRUE(absl::IsUnavailable(a_.results.at(0).status()));
  EXPECT_TRUE(absl::IsUnavailable(b_.results.at(0).status()));
}

}  // namespace
}  // namespace geodesic::server
