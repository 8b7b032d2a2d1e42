#include "rows.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace geodesic::python {
namespace {

class StopFlag final : public Checkpoint {
 public:
  absl::Status Poll(const Progress&) override {
    return is_set() ? absl::CancelledError("stopped") : absl::OkStatus();
  }
  void Set() { flag_ = true; }
  bool is_set() const { return flag_; }

 private:
  std::atomic<bool> flag_ = false;
};

}  // namespace

absl::Status RunRows(
    uint64_t count, uint32_t threads, Watch& watch,
    const std::function<absl::Status(uint64_t row, Checkpoint& checkpoint)>&
        row) {
  StopFlag stop;
  std::atomic<uint64_t> next = 0;
  std::atomic<uint64_t> done = 0;
  std::mutex mutex;
  std::condition_variable has_ended;
  uint64_t running = std::min<uint64_t>(threads, count);  // guarded by mutex
  absl::Status first_error;                               // guarded by mutex

  const auto work = [&] {
    while (!stop.is_set()) {
      const uint64_t i = next++;
      if (i >= count) break;
      absl::Status status = row(i, stop);
      if (!status.ok()) {
        const std::scoped_lock lock(mutex);
        if (!stop.is_set()) first_error = std::move(status);
        stop.Set();
        break;
      }
      ++done;
    }
    const std::scoped_lock lock(mutex);
    --running;
    has_ended.notify_one();
  };

  std::vector<std::jthread> workers;
  for (uint64_t started = running; started > 0; --started) {
    workers.emplace_back(work);
  }
  std::unique_lock lock(mutex);
  while (!has_ended.wait_for(lock, Watch::kInterval,
                             [&] { return running == 0; })) {
    lock.unlock();
    const absl::Status status = watch.Report(done, count);
    lock.lock();
    if (!status.ok()) {
      if (!stop.is_set()) first_error = status;
      stop.Set();
    }
  }
  return first_error;
}

}  // namespace geodesic::python
