#include "server/engine/jobs/thread_pool.h"

#include <algorithm>
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
      workers_.push_back({.line = lines_[kind]});
      Start(workers_.back());
    }
  }
  replacer_ = std::jthread([this] { Replace(); });
}

ThreadPool::~ThreadPool() {
  {
    std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  is_spent_.notify_one();
  replacer_.join();
  for (Line& line : lines_) line.changed.notify_all();
  workers_.clear();  // joins, while the other members still live
}

void ThreadPool::Schedule(Task task, ThreadKind kind) {
  Line& line = lines_[static_cast<size_t>(kind)];
  {
    std::lock_guard lock(mutex_);
    line.tasks.push_back(std::move(task));
  }
  line.changed.notify_one();
}

void ThreadPool::Start(Worker& worker) {
  worker.thread = std::jthread([this, &worker] { Work(worker); });
}

void ThreadPool::Work(Worker& worker) {
  Line& line = worker.line;
  std::unique_lock lock(mutex_);
  for (;;) {
    line.changed.wait(lock, [&] { return stopping_ || !line.tasks.empty(); });
    if (line.tasks.empty()) return;
    Task task = std::move(line.tasks.front());
    line.tasks.pop_front();
    lock.unlock();
    std::move(task)();
    task = nullptr;  // what it captured dies before the lock is taken
    lock.lock();
    if (HasSmallShare() && !stopping_) {
      worker.is_spent = true;
      is_spent_.notify_one();
      return;
    }
  }
}

void ThreadPool::Replace() {
  std::unique_lock lock(mutex_);
  for (;;) {
    const auto spent = [this] {
      return std::ranges::find(workers_, true, &Worker::is_spent);
    };
    is_spent_.wait(lock,
                   [&] { return stopping_ || spent() != workers_.end(); });
    const auto worker = spent();
    if (worker == workers_.end()) return;
    worker->is_spent = false;
    lock.unlock();
    worker->thread = {};  // joins
    try {
      Start(*worker);
      lock.lock();
    } catch (const std::system_error&) {
      lock.lock();
      worker->is_spent = true;
      is_spent_.wait_for(lock, kRetry, [this] { return stopping_; });
      if (!stopping_) continue;
      worker->is_spent = false;
      lock.unlock();
      Work(*worker);  // what is left
      lock.lock();
    }
  }
}

}  // namespace geodesic::server
