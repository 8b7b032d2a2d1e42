#include "server/engine/jobs/thread_pool.h"

namespace geodesic::server {

ThreadPool::ThreadPool(size_t threads) {
  threads_.reserve(threads + 1);
  for (size_t i = 0; i < threads; ++i) {
    threads_.emplace_back([this] { Work(tasks_); });
  }
  threads_.emplace_back([this] { Work(tasks_beside_); });
}

ThreadPool::~ThreadPool() {
  {
    std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  tasks_.changed.notify_all();
  tasks_beside_.changed.notify_all();
  threads_.clear();  // joins, while the other members still live
}

void ThreadPool::Add(Task task, Line& line) {
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
