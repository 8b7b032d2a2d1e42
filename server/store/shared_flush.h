// Flushes a file or folder once for all who wait.

#ifndef GEODESIC_SERVER_STORE_SHARED_FLUSH_H_
#define GEODESIC_SERVER_STORE_SHARED_FLUSH_H_

#include <condition_variable>
#include <memory>
#include <mutex>
#include <utility>

#include "absl/functional/function_ref.h"
#include "absl/status/status.h"

namespace geodesic::server {

// Thread-safe.
class SharedFlush {
 public:
  // Returns once a flush has ended that began after this call, by `flush`,
  // which is the same for all: those who come while one runs share the next.
  // Errors: that flush's.
  absl::Status Run(absl::FunctionRef<absl::Status()> flush) {
    std::unique_lock lock(mutex_);
    if (next_ == nullptr) next_ = std::make_shared<Turn>();
    const std::shared_ptr<Turn> turn = next_;
    ended_.wait(lock, [&] { return turn->has_ended || !is_running_; });
    if (turn->has_ended) return turn->status;
    next_ = nullptr;
    is_running_ = true;
    lock.unlock();
    absl::Status status = flush();
    lock.lock();
    is_running_ = false;
    turn->status = status;
    turn->has_ended = true;
    ended_.notify_all();
    return status;
  }

 private:
  struct Turn {
    bool has_ended = false;
    absl::Status status;
  };

  std::mutex mutex_;
  std::condition_variable ended_;
  // Guarded by mutex_:
  bool is_running_ = false;
  std::shared_ptr<Turn> next_;  // of those who wait; null: nobody does
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_STORE_SHARED_FLUSH_H_
