// The engine uses threads only through Executor; ThreadPool has a fixed number.

#ifndef GEODESIC_SERVER_ENGINE_JOBS_THREAD_POOL_H_
#define GEODESIC_SERVER_ENGINE_JOBS_THREAD_POOL_H_

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <mutex>
#include <thread>
#include <vector>

#include "absl/functional/any_invocable.h"

namespace geodesic::server {

using Task = absl::AnyInvocable<void()>;

class Executor {
 public:
  virtual ~Executor() = default;

  // Runs `task` once, later and not on the calling thread's stack. Thread-safe.
  virtual void Schedule(Task task) = 0;
};

// Starts tasks in order. The queue is unbounded; Scheduler bounds what it puts
// there. Thread-safe.
class ThreadPool final : public Executor {
 public:
  // REQUIRES: threads > 0.
  explicit ThreadPool(size_t threads);

  // Runs every task that was scheduled, then joins the threads.
  ~ThreadPool() override;

  void Schedule(Task task) override;

 private:
  void Work();

  std::mutex mutex_;
  std::condition_variable changed_;
  // Guarded by mutex_:
  std::deque<Task> tasks_;
  bool stopping_ = false;

  std::vector<std::jthread> threads_;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_JOBS_THREAD_POOL_H_
