#include "server/engine/jobs/thread_pool.h"

namespace geodesic::server {

ThreadPool::ThreadPool(size_t threads) {
  const std::array<size_t, kThreadKinds> counts = {threads, kDiskThreads, 1};
  for (size_t kind = 0; kind < counts.size(); ++kind) {
    for (size_t i = 0; i < counts[kind]; ++i) {
      threads_.emplace_back([this, kind] { Work(lines_[kind]); });
    }
  }
}

ThreadPool::~ThreadPool() {
  {
    std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  for (Line& line : lines_) line.changed.notify_all();
  threads_.clear();  // joins, while the other members still live
}

void ThreadPool::Schedule(Task task, ThreadKind kind) {
  Line& line = lines_[static_cast<size_t>(kind)];
  {
    std::lock_guard lock(mutex_);
    line.tasks.push_back(std::move(task));
  }
  line.changed.notify_one();
}

void ThreadPool::Work(Line& line) {
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
  }
}

}  // namespace geodesic::server
