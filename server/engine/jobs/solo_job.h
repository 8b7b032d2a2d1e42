// Work for one client alone, with the scheduling, deadlines, cancellation and
// memory budget that fields have.

#ifndef GEODESIC_SERVER_ENGINE_JOBS_SOLO_JOB_H_
#define GEODESIC_SERVER_ENGINE_JOBS_SOLO_JOB_H_

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "absl/functional/any_invocable.h"
#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/checkpoint.h"
#include "server/engine/base/byte_budget.h"
#include "server/engine/base/clock.h"
#include "server/engine/jobs/scheduler.h"
#include "server/engine/jobs/shared_jobs.h"

namespace geodesic::server {

// How a job ended.
struct JobReport {
  absl::Status status;
  // The time it took on its thread.
  double seconds = 0;
  uint64_t windows_propagated = 0;
};

struct SoloJob {
  JobPriority priority = JobPriority::kSolve;
  std::string client;                        // see Requester
  std::shared_ptr<const void> account = {};  // see Waiter
  bool is_continuation = false;              // see Job
  TimePoint deadline = kNoDeadline;
  // Memory taken from the solver budget before the work begins: for the solver,
  // and for the answer. The work is given the latter.
  uint64_t planned_bytes = 0;
  uint64_t answer_bytes = 0;
  absl::AnyInvocable<absl::Status(Checkpoint&, ByteReservation answer)> work;
  // See Waiter.
  std::function<void(const JobReport&)> done;
  std::function<void(const Progress&)> progress;
};

// Thread-safe.
class SoloJobs {
 public:
  // For Cancel.
  using Call = SharedJobs<uint64_t, JobReport>::Ticket;

  // REQUIRES: the references outlive the object, and `scheduler` has no job
  // left when it is destroyed.
  SoloJobs(const Clock& clock, Scheduler& scheduler,
           std::shared_ptr<ByteBudget> solver_memory,
           Duration progress_interval);

  // Errors: as Scheduler::Submit; RESOURCE_EXHAUSTED when the memory can never
  // be had. `done` is not called after an error; it may be called before this
  // returns.
  absl::StatusOr<Call> Start(SoloJob job);

  // Nobody waits any longer: the work is dropped, or stops at its next poll.
  void Cancel(const Call& call) { jobs_.Leave(call); }

 private:
  struct Memory {
    ByteReservation solver;
    ByteReservation answer;
  };

  const Clock& clock_;
  const std::shared_ptr<ByteBudget> solver_memory_;
  SharedJobs<uint64_t, JobReport> jobs_;  // each of a key of its own
  std::atomic<uint64_t> next_key_ = 0;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_JOBS_SOLO_JOB_H_
