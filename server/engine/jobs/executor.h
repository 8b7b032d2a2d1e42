// The engine's only way to threads.

#ifndef GEODESIC_SERVER_ENGINE_JOBS_EXECUTOR_H_
#define GEODESIC_SERVER_ENGINE_JOBS_EXECUTOR_H_

#include "absl/functional/any_invocable.h"

namespace geodesic::server {

using Task = absl::AnyInvocable<void()>;

class Executor {
 public:
  virtual ~Executor() = default;

  // Runs `task` once, later and not on the calling thread's stack. Thread-safe.
  virtual void Schedule(Task task) = 0;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_JOBS_EXECUTOR_H_
