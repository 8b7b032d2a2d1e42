// Flushes a file or folder once for all who wait.

#ifndef GEODESIC_SERVER_STORE_SHARED_FLUSH_H_
#define GEODESIC_SERVER_STORE_SHARED_FLUSH_H_

#include <condition_variable>
#include <memory>
#include <utility>

#include "absl/functional/function_ref.h"
#include "absl/status/status.h"
#include "server/locks/mutex.h"

namespace geodesic::server {

// Thread-safe.
class SharedFlush {
 public:
  // Returns once a flush has ended that began after this call, by `flush`,
  // which is the same for all: those who come while one runs share the next.
  // Errors: that flush's.
  absl::Status Run(absl::FunctionRef<absl::Status()> flush) {
    MutexLock lock(mutex_);
    if (next_ == nullptr) next_ = std::make_shared<Turn>();
    const std::shared_ptr<Turn> turn = next_;
    while (!turn->has_ended && is_running_) ended_.wait(lock);
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

  Mutex mutex_;
  std::condition_variable_any ended_;
  bool is_running_ ABSL_GUARDED_BY(mutex_) = false;
  // Of those who wait; null: nobody does.
  std::shared_ptr<Turn> next_ ABSL_GUARDED_BY(mutex_);
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_STORE_SHARED_FLUSH_H_
