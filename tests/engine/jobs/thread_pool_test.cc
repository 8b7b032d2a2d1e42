#include "server/engine/jobs/thread_pool.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <latch>
#include <mutex>
#include <set>
#include <thread>
#include <vector>

#include "server/engine/jobs/processor_share.h"

namespace geodesic::server {
namespace {

TEST(ThreadPool, RunsEveryTaskBeforeItGoes) {
  std::atomic<int> count = 0;
  {
    ThreadPool pool(3);
    for (int i = 0; i < 1000; ++i)
      pool.Schedule([&] { ++count; }, ThreadKind::kCompute);
  }
  EXPECT_EQ(count, 1000);
}

// Though each task leaves its thread a small share, and no thread is replaced
// once the pool goes.
TEST(ThreadPool, SoDoThreadsOfASmallShare) {
  std::atomic<int> count = 0;
  {
    ThreadPool pool(1);
    for (int i = 0; i < 100; ++i) {
      pool.Schedule(
          [&] {
            ShareByAge(kYoung);
            ++count;
          },
          ThreadKind::kCompute);
    }
  }
  EXPECT_EQ(count, 100);
}

// Each task waits for the other: with fewer than two threads this never ends.
TEST(ThreadPool, RunsTasksSideBySide) {
  std::latch both(2);
  std::mutex mutex;
  std::set<std::thread::id> threads;
  {
    ThreadPool pool(2);
    for (int i = 0; i < 2; ++i) {
      pool.Schedule(
          [&] {
            both.arrive_and_wait();
            std::lock_guard lock(mutex);
            threads.insert(std::this_thread::get_id());
          },
          ThreadKind::kCompute);
    }
  }
  EXPECT_EQ(threads.size(), 2);
  EXPECT_FALSE(threads.contains(std::this_thread::get_id()));
}

TEST(ThreadPool, TasksMaySchedule) {
  std::latch done(1);
  ThreadPool pool(1);
  pool.Schedule(
      [&] { pool.Schedule([&] { done.count_down(); }, ThreadKind::kCompute); },
      ThreadKind::kCompute);
  done.wait();
}

// Each waits for all others: if one had another kind's thread, this would never
// end.
TEST(ThreadPool, NoKindTakesAnothersThreads) {
  std::latch all(1 + kDiskThreads + 1);
  ThreadPool pool(1);
  pool.Schedule([&] { all.arrive_and_wait(); }, ThreadKind::kBeside);
  for (size_t i = 0; i < kDiskThreads; ++i) {
    pool.Schedule([&] { all.arrive_and_wait(); }, ThreadKind::kDisk);
  }
  pool.Schedule([&] { all.arrive_and_wait(); }, ThreadKind::kCompute);
  all.wait();
}

int Nice() { return getpriority(PRIO_PROCESS, 0); }

// A third of the share, five steps of nice, and then a ninth.
TEST(ThreadPool, LongWorkMakesWayAndLeavesTheNextAFullShare) {
  using std::chrono::milliseconds;
  const int full = Nice();
  std::vector<int> nice;
  {
    ThreadPool pool(1);
    for (int i = 0; i < 2; ++i) {
      pool.Schedule(
          [&nice] {
            for (const int age : {0, 12, 13, 49, 50, 5000}) {
              ShareByAge(milliseconds(age));
              nice.push_back(Nice());
            }
          },
          ThreadKind::kCompute);
    }
    std::latch last(1);
    pool.Schedule([&] { last.count_down(); }, ThreadKind::kCompute);
    last.wait();
  }
  std::vector<int> expected;
  for (int i = 0; i < 2; ++i) {
    for (const int more : {0, 0, 5, 5, 10, 10})
      expected.push_back(std::min(full + more, 19));
  }
  EXPECT_EQ(nice, expected);
}

}  // namespace
}  // namespace geodesic::server
