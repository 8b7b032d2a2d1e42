// Beside whose jobs others may start.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "server/engine/jobs/scheduler.h"
#include "tests/engine/fakes.h"

namespace geodesic::server {
namespace {

using ::testing::ElementsAre;

// Beside a job that has run long another client's may start, but no more than
// that.
TEST(SchedulerLongTest, NobodyWaitsForOthersLongJobs) {
  test::ManualExecutor executor;
  Scheduler scheduler(executor, /*max_running=*/1, /*max_queued=*/9);
  std::vector<std::string> ran;
  const auto submit = [&](
                          std::string client,
                          std::function<void()> meanwhile = [] {}) {
    ASSERT_TRUE(scheduler
                    .Submit({.client = client,
                             .run =
                                 [&ran, client, meanwhile](std::stop_token) {
                                   meanwhile();
                                   ran.push_back(client);
                                 }})
                    .ok());
  };
  submit("long", [&] {
    submit("long");
    submit("short", [&] {
      EXPECT_EQ(scheduler.running(), 2u);
      EXPECT_EQ(scheduler.idle(), 0u);
      submit("third");
      EXPECT_FALSE(executor.RunOne()) << "a short job has the thread";
      scheduler.LetOthersStart(kYoung);
      EXPECT_TRUE(executor.RunOne());
    });
    EXPECT_FALSE(executor.RunOne());
    scheduler.LetOthersStart(kYoung);
    EXPECT_TRUE(executor.RunOne());
    EXPECT_FALSE(executor.RunOne()) << "its client has one that runs";
  });
  executor.RunAll();
  EXPECT_THAT(ran, ElementsAre("third", "short", "long", "long"));
}

// Whose client has used most makes room earlier.
TEST(SchedulerLongTest, WhoAsksLittleWaitsLessForWhoAsksMuch) {
  constexpr Duration kLonger = Scheduler::kBrief;
  constexpr Duration kShorter = kLonger - std::chrono::milliseconds(1);
  test::ManualExecutor executor;
  test::FakeClock clock;
  Scheduler scheduler(executor, /*max_running=*/1, /*max_queued=*/9);
  scheduler.ObserveJobs(clock, [](const JobTimes&) {});
  const auto submit = [&](std::string client, std::function<void()> run) {
    ASSERT_TRUE(scheduler
                    .Submit({.client = client,
                             .run = [run](std::stop_token) { run(); }})
                    .ok());
  };
  // So that both have accounts: "much" has used a second more.
  submit("much", [&] { clock.Advance(std::chrono::seconds(1)); });
  submit("little", [&] {
    EXPECT_FALSE(scheduler.LetOthersStart(kLonger));
    EXPECT_FALSE(executor.RunOne());
  });
  submit("much", [&] {
    submit("little", [] {});
    EXPECT_FALSE(scheduler.LetOthersStart(kShorter));
    EXPECT_FALSE(executor.RunOne());
    EXPECT_TRUE(scheduler.LetOthersStart(kLonger));
    EXPECT_TRUE(executor.RunOne());
  });
  executor.RunAll();
}

// What nobody waits for takes half of the disk's threads at the most.
TEST(SchedulerDiskTest, StoresLeaveThreadsToWhoWaits) {
  test::ManualExecutor executor;
  Scheduler scheduler(executor, /*max_running=*/1, /*max_queued=*/9);
  int stored = 0;
  bool was_read = false;
  scheduler.Store([&] {
    EXPECT_TRUE(executor.RunOne());
    ++stored;
  });
  scheduler.Store([&] {
    executor.RunAll();
    EXPECT_EQ(stored, 0) << "two are written: the third waits";
    EXPECT_TRUE(scheduler
                    .Submit({.waits_for_disk = [] { return true; },
                             .run = [&](std::stop_token) { was_read = true; }})
                    .ok());
    executor.RunAll();
    EXPECT_TRUE(was_read);
    ++stored;
  });
  scheduler.Store([&] { ++stored; });
  executor.RunAll();
  EXPECT_EQ(stored, 3);
}

// It makes room for one, however often it says that it has run long, and until
// it ends.
TEST(SchedulerLongTest, ALongJobMakesRoomOnce) {
  test::ManualExecutor executor;
  Scheduler scheduler(executor, /*max_running=*/1, /*max_queued=*/9);
  const auto submit = [&](
                          std::string client,
                          std::function<void()> meanwhile = [] {}) {
    ASSERT_TRUE(
        scheduler
            .Submit({.client = client,
                     .run = [meanwhile](std::stop_token) { meanwhile(); }})
            .ok());
  };
  submit("long", [&] {
    scheduler.LetOthersStart(kYoung);
    scheduler.LetOthersStart(kYoung);
    submit("a", [&] { EXPECT_FALSE(executor.RunOne()); });
    submit("b");
    EXPECT_TRUE(executor.RunOne());
  });
  executor.RunAll();
  submit("a", [&] { EXPECT_FALSE(executor.RunOne()); });
  submit("b");
  executor.RunAll();
  EXPECT_TRUE(scheduler.WaitIdle(std::chrono::milliseconds(0)));
}

TEST(SchedulerLongTest, FourTimesAsManyRunAtMost) {
  test::ManualExecutor executor;
  Scheduler scheduler(executor, /*max_running=*/1, /*max_queued=*/9);
  size_t most = 0;
  // Each of another client, within the one before.
  const std::function<void(int)> submit = [&](int number) {
    const auto run = [&, number](std::stop_token) {
      most = std::max(most, scheduler.running());
      if (number == 6) return;
      submit(number + 1);
      scheduler.LetOthersStart(kYoung);
      executor.RunOne();
    };
    ASSERT_TRUE(
        scheduler.Submit({.client = std::to_string(number), .run = run}).ok());
  };
  submit(1);
  executor.RunAll();
  EXPECT_EQ(most, 4u);
  EXPECT_TRUE(scheduler.WaitIdle(std::chrono::milliseconds(0)));
}

}  // namespace
}  // namespace geodesic::server
