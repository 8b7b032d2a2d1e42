// What the scheduler runs.

#ifndef GEODESIC_SERVER_ENGINE_JOBS_JOB_H_
#define GEODESIC_SERVER_ENGINE_JOBS_JOB_H_

#include <stop_token>
#include <string>

#include "absl/functional/any_invocable.h"
#include "absl/status/status.h"
#include "server/engine/base/requester.h"

namespace geodesic::server {

// The most urgent first.
enum class JobPriority {
  kBuild,  // of meshes: short, and queries wait for them
  kSolve,
  kRow,    // one of many that a single request needs
  kBatch,  // either of the two, of a request that can wait
  kStore,  // keeps on disk what would otherwise be computed again
};
inline constexpr int kJobPriorities = 5;

// The priority of what answers a request at once, and of its rows.
constexpr JobPriority SolvePriority(bool is_batch) {
  return is_batch ? JobPriority::kBatch : JobPriority::kSolve;
}
constexpr JobPriority RowPriority(bool is_batch) {
  return is_batch ? JobPriority::kBatch : JobPriority::kRow;
}

// Either `run` or `abandon` ends the job, unless it is cancelled while it
// waits: then neither is called. None of them may throw.
struct Job {
  JobPriority priority = JobPriority::kSolve;
  // See Requester.
  std::string client;
  // Whether a job that was admitted goes on in this one: it is then admitted
  // too, though the queue be full or draining.
  bool is_continuation = false;
  // Takes the memory that the job needs, just before it runs; may be empty.
  // Must be short. While it fails with a retry hint and other jobs may give
  // memory back, the job waits and is asked again (see Scheduler); any other
  // error is the job's end. What was taken goes with the job.
  absl::AnyInvocable<absl::Status()> reserve;
  // Does the work, on a thread of the executor. It should return soon after
  // the token asks it to stop.
  absl::AnyInvocable<void(std::stop_token)> run;
  // After `run`: whether there is more to do, for which the job waits in its
  // old place, takes memory and runs again; may be empty. One that was asked to
  // stop is dropped instead.
  absl::AnyInvocable<bool()> goes_on;
  // Hears why the job will never run. Must be short.
  absl::AnyInvocable<void(const absl::Status&)> abandon;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_JOBS_JOB_H_
