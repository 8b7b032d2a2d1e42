#include "server/engine/jobs/thread_pool.h"

#include <gtest/gtest.h>

#include <atomic>
#include <latch>
#include <mutex>
#include <set>
#include <thread>

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

}  // namespace
}  // namespace geodesic::server
