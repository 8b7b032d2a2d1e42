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
    for (int i = 0; i < 1000; ++i) pool.Schedule([&] { ++count; });
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
      pool.Schedule([&] {
        both.arrive_and_wait();
        std::lock_guard lock(mutex);
        threads.insert(std::this_thread::get_id());
      });
    }
  }
  EXPECT_EQ(threads.size(), 2);
  EXPECT_FALSE(threads.contains(std::this_thread::get_id()));
}

TEST(ThreadPool, TasksMaySchedule) {
  std::latch done(1);
  ThreadPool pool(1);
  pool.Schedule([&] { pool.Schedule([&] { done.count_down(); }); });
  done.wait();
}

// The task beside waits for the other: if it had that one's thread, this would
// never end.
TEST(ThreadPool, ATaskBesideTakesNobodysThread) {
  std::latch both(2);
  ThreadPool pool(1);
  pool.ScheduleBeside([&] { both.arrive_and_wait(); });
  pool.Schedule([&] { both.count_down(); });
  both.wait();
}

}  // namespace
}  // namespace geodesic::server
