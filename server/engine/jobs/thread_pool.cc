#include "server/engine/jobs/thread_pool.h"

#include <sched.h>

namespace geodesic::server {
namespace {

// Where Linux refuses, the thread is one like the others.
void TakeIdleTimeOnly() {
  const sched_param none{};
  (void)sched_setscheduler(0, SCHED_IDLE, &none);  // 0: this thread
}

}  // namespace

ThreadPool::ThreadPool(size_t threads) {
  threads_.reserve(threads + 1);
  for (size_t i = 0; i < threads; ++i) {
    threads_.emplace_back([this] { Work(tasks_); });
  }
  threads_.emplace_back([this] {
    TakeIdleTimeOnly();
    Work(idle_tasks_);
  });
}

ThreadPool::~ThreadPool() {
  {
    std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  tasks_.changed.notify_all();
  idle_tasks_.changed.notify_all();
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
