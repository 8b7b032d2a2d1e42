// Locks that clang checks: -Wthread-safety makes an error of each use of a
// member that is ABSL_GUARDED_BY a mutex, where that is not held.
//
//   Mutex mutex_;
//   int count_ ABSL_GUARDED_BY(mutex_) = 0;
//   std::condition_variable_any changed_;
//   ...
//   MutexLock lock(mutex_);
//   while (count_ == 0) changed_.wait(lock);
//
// absl::Mutex is annotated as well, but ThreadSanitizer sees nothing of it in
// the Abseil that Debian builds, and would report each use as a race.

#ifndef GEODESIC_SERVER_LOCKS_MUTEX_H_
#define GEODESIC_SERVER_LOCKS_MUTEX_H_

#include <mutex>

#include "absl/base/thread_annotations.h"  // IWYU pragma: export

namespace geodesic::server {

// A std::mutex.
class ABSL_LOCKABLE Mutex {
 public:
  void lock() ABSL_EXCLUSIVE_LOCK_FUNCTION() { mutex_.lock(); }
  void unlock() ABSL_UNLOCK_FUNCTION() { mutex_.unlock(); }

 private:
  std::mutex mutex_;
};

// A std::unique_lock that is held from the start.
class ABSL_SCOPED_LOCKABLE MutexLock {
 public:
  explicit MutexLock(Mutex& mutex) ABSL_EXCLUSIVE_LOCK_FUNCTION(mutex)
      : lock_(mutex) {}
  ~MutexLock() ABSL_UNLOCK_FUNCTION() {}

  MutexLock(const MutexLock&) = delete;
  MutexLock& operator=(const MutexLock&) = delete;

  void lock() ABSL_EXCLUSIVE_LOCK_FUNCTION() { lock_.lock(); }
  void unlock() ABSL_UNLOCK_FUNCTION() { lock_.unlock(); }

 private:
  std::unique_lock<Mutex> lock_;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_LOCKS_MUTEX_H_
