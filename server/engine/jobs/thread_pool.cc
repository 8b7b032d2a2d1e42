#include "server/engine/jobs/thread_pool.h"

#include <chrono>
#include <system_error>

#include "server/engine/jobs/processor_share.h"

namespace geodesic::server {
namespace {

// Until a thread that the system refused is tried again.
constexpr std::chrono::milliseconds kRetry{100};

}  // namespace

ThreadPool::ThreadPool(size_t threads) {
  const std::array<size_t, kThreadKinds> counts = {threads, kDiskThreads, 1};
  for (size_t kind = 0; kind < counts.size(); ++kind) {
    for (size_t i = 0; i < counts[kind]; ++i) {
      workers_.push_back({.kind = kind});
      Start(workers_.back());
    }
  }
  replacer_ = std::jthread([this] { Replace(); });
}

ThreadPool::~ThreadPool() {
  {
    MutexLock lock(mutex_);
    stopping_ = true;
  }
  spent_changed_.notify_one();
  replacer_.join();
  for (auto& changed : tasks_changed_) changed.notify_all();
  workers_.clear();  // joins, while the other members still live
}

void ThreadPool::Schedule(Task task, ThreadKind kind) {
  const auto index = static_cast<size_t>(kind);
  {
    MutexLock lock(mutex_);
    tasks_[index].push_back(std::move(task));
  }
  tasks_changed_[index].notify_one();
}

void ThreadPool::Start(Worker& worker) {
  worker.thread = std::jthread([this, &worker] { Work(worker); });
}

void ThreadPool::Work(Worker& worker) {
  MutexLock lock(mutex_);
  std::deque<Task>& tasks = tasks_[worker.kind];
  for (;;) {
    while (!stopping_ && tasks.empty()) tasks_changed_[worker.kind].wait(lock);
    if (tasks.empty()) return;
    Task task = std::move(tasks.front());
    tasks.pop_front();
    lock.unlock();
    std::move(task)();
    task = nullptr;  // what it captured dies before the lock is taken
    lock.lock();
    if (HasSmallShare() && !stopping_) {
      spent_.push_back(&worker);
      spent_changed_.notify_one();
      return;
    }
  }
}

void ThreadPool::Replace() {
  MutexLock lock(mutex_);
  for (;;) {
    while (!stopping_ && spent_.empty()) spent_changed_.wait(lock);
    if (spent_.empty()) return;
    Worker& worker = *spent_.front();
    spent_.pop_front();
    lock.unlock();
    worker.thread = {};  // joins
    bool is_started = true;
    try {
      Start(worker);
    } catch (const std::system_error&) {
      is_started = false;
    }
    lock.lock();
    if (is_started) continue;
    spent_changed_.wait_for(
        lock, kRetry,
        [this]() ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) { return stopping_; });
    if (!stopping_) {
      spent_.push_front(&worker);
      continue;
    }
    lock.unlock();
    Work(worker);  // what is left
    lock.lock();
  }
}

}  // namespace geodesic::server
