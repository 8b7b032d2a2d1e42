// The engine uses threads only through Executor; ThreadPool has as many at any
// time.

#ifndef GEODESIC_SERVER_ENGINE_JOBS_THREAD_POOL_H_
#define GEODESIC_SERVER_ENGINE_JOBS_THREAD_POOL_H_

#include <array>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <thread>
#include <utility>

#include "absl/functional/any_invocable.h"
#include "server/locks/mutex.h"

namespace geodesic::server {

using Task = absl::AnyInvocable<void()>;

// No task waits for a thread of another kind than its own.
enum class ThreadKind {
  kCompute,
  kDisk,    // for tasks that wait for the disk
  kBeside,  // for one long task at a time
};
inline constexpr int kThreadKinds = 3;

// A disk serves more than one at a time, but not many faster.
inline constexpr size_t kDiskThreads = 4;

class Executor {
 public:
  virtual ~Executor() = default;

  // Runs `task` once, later and not on the calling thread's stack. Thread-safe.
  virtual void Schedule(Task task, ThreadKind kind) = 0;
};

// Starts tasks in order. The queue is unbounded; Scheduler bounds what it puts
// there. A thread whose task left it a small share of the processor
// (processor_share.h) is replaced. Thread-safe.
class ThreadPool final : public Executor {
 public:
  // So many threads are for kCompute, kDiskThreads for kDisk, one for kBeside.
  // REQUIRES: threads > 0.
  explicit ThreadPool(size_t threads);

  // Runs every task that was scheduled, then joins the threads.
  ~ThreadPool() override;

  void Schedule(Task task, ThreadKind kind) override;

 private:
  struct Worker {
    size_t kind;
    std::jthread thread;
  };

  void Work(Worker& worker);
  void Start(Worker& worker);
  // Replaces workers that are spent. On a thread of its own, since a new thread
  // has the share of the one that starts it.
  void Replace();

  Mutex mutex_;
  std::array<std::deque<Task>, kThreadKinds> tasks_ ABSL_GUARDED_BY(mutex_);
  std::deque<Worker*> spent_ ABSL_GUARDED_BY(mutex_);
  bool stopping_ ABSL_GUARDED_BY(mutex_) = false;
  std::array<std::condition_variable_any, kThreadKinds> tasks_changed_;
  std::condition_variable_any spent_changed_;

  std::deque<Worker> workers_;
  std::jthread replacer_;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_JOBS_THREAD_POOL_H_
