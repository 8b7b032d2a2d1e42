// The engine uses threads only through Executor; ThreadPool has a fixed number.

#ifndef GEODESIC_SERVER_ENGINE_JOBS_THREAD_POOL_H_
#define GEODESIC_SERVER_ENGINE_JOBS_THREAD_POOL_H_

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "absl/functional/any_invocable.h"

namespace geodesic::server {

using Task = absl::AnyInvocable<void()>;

class Executor {
 public:
  virtual ~Executor() = default;

  // Each runs `task` once, later and not on the calling thread's stack, the
  // second on a thread that no task of the first waits for. Thread-safe.
  virtual void Schedule(Task task) = 0;
  virtual void ScheduleBeside(Task task) = 0;
};

// Starts tasks in order. The queue is unbounded; Scheduler bounds what it puts
// there. Thread-safe.
class ThreadPool final : public Executor {
 public:
  // One more thread is for tasks beside. REQUIRES: threads > 0.
  explicit ThreadPool(size_t threads);

  // Runs every task that was scheduled, then joins the threads.
  ~ThreadPool() override;

  void Schedule(Task task) override { Add(std::move(task), tasks_); }
  void ScheduleBeside(Task task) override {
    Add(std::move(task), tasks_beside_);
  }

 private:
  // Guarded by mutex_ of the pool.
  struct Line {
    std::condition_variable changed;
    std::deque<Task> tasks;
  };

  void Add(Task task, Line& line);
  void Work(Line& line);

  std::mutex mutex_;
  Line tasks_;
  Line tasks_beside_;
  bool stopping_ = false;  // guarded by mutex_

  std::vector<std::jthread> threads_;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_JOBS_THREAD_POOL_H_
