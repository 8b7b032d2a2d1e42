// What a running solver checks at each poll: who still waits for it, whether it
// was asked to stop, the memory budget that all solvers share, and its share of
// the processor.

#ifndef GEODESIC_SERVER_ENGINE_JOBS_JOB_CHECKPOINT_H_
#define GEODESIC_SERVER_ENGINE_JOBS_JOB_CHECKPOINT_H_

#include <stop_token>
#include <utility>

#include "absl/status/status.h"
#include "geodesic/checkpoint.h"
#include "server/engine/base/byte_budget.h"
#include "server/engine/base/clock.h"
#include "server/engine/jobs/scheduler.h"

namespace geodesic::server {

// The clients that wait for a job. Called from the job's thread.
class JobWaiters {
 public:
  virtual ~JobWaiters() = default;

  // Removes the waiters whose deadline has come.
  // Errors: DEADLINE_EXCEEDED or CANCELLED when nobody is left.
  virtual absl::Status Expire(TimePoint now) = 0;

  virtual void Publish(const Progress& progress) = 0;
};

// Belongs to one job and its thread, and begins with it.
class JobCheckpoint final : public Checkpoint {
 public:
  // `scheduler` runs the job. The references outlive the checkpoint.
  JobCheckpoint(JobWaiters& waiters, const Clock& clock, Scheduler& scheduler,
                std::stop_token stop, Duration progress_interval);

  // Takes over the solver's reservation. Without one it may take no memory.
  void Hold(ByteReservation memory) { memory_ = std::move(memory); }

  // Tells the waiters now, not at the next interval.
  void Publish(const Progress& progress) { waiters_.Publish(progress); }

  // Errors: as JobWaiters::Expire; UNAVAILABLE when the job was asked to stop
  // though somebody waits; RESOURCE_EXHAUSTED when the solver has outgrown the
  // memory budget.
  absl::Status Poll(const Progress& progress) override;

  // As of the last poll.
  uint64_t windows_propagated() const { return windows_propagated_; }

 private:
  // Lets others go first, the more the longer the job has run.
  void MakeWay(Duration ran);

  JobWaiters& waiters_;
  const Clock& clock_;
  Scheduler& scheduler_;
  const std::stop_token stop_;
  const Duration progress_interval_;
  const TimePoint began_;
  ByteReservation memory_;
  bool is_long_ = false;
  TimePoint next_progress_;
  uint64_t windows_propagated_ = 0;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_JOBS_JOB_CHECKPOINT_H_
