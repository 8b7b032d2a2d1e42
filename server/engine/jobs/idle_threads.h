// Solves on threads that would have nothing to do.

#ifndef GEODESIC_SERVER_ENGINE_JOBS_IDLE_THREADS_H_
#define GEODESIC_SERVER_ENGINE_JOBS_IDLE_THREADS_H_

#include <algorithm>
#include <cstdint>

#include "geodesic/solve_options.h"
#include "server/engine/jobs/scheduler.h"

namespace geodesic::server {

// For a solve that starts now, in a job of the scheduler: it shares its work
// with as many threads as are idle, `most` in all. They are threads of its own:
// if other jobs come meanwhile, it takes a little of their processors until it
// ends, and waits for none of its threads that gets no turn.
inline SolveOptions WithIdleThreads(SolveOptions options,
                                    const Scheduler& scheduler, uint64_t most) {
  options.threads =
      static_cast<uint32_t>(std::min<uint64_t>(scheduler.idle() + 1, most));
  return options;
}

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_JOBS_IDLE_THREADS_H_
