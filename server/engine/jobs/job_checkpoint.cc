#include "server/engine/jobs/job_checkpoint.h"

#include <thread>
#include <utility>

#include "server/engine/base/status_details.h"

namespace geodesic::server {
namespace {

// The reservation grows in steps of this size while there is room, so it also
// covers what the solver takes between two polls.
constexpr uint64_t kMemoryStep = uint64_t{16} << 20;

}  // namespace

JobCheckpoint::JobCheckpoint(JobWaiters& waiters, const Clock& clock,
                             std::stop_token stop, Duration progress_interval)
    : waiters_(waiters),
      clock_(clock),
      stop_(std::move(stop)),
      progress_interval_(progress_interval),
      next_progress_(clock.Now()) {}

absl::Status JobCheckpoint::Poll(const Progress& progress) {
  // When solvers use every processor, a short call would otherwise wait for the
  // end of a solver's time slice, which takes milliseconds.
  std::this_thread::yield();
  windows_propagated_ = progress.windows_propagated;
  const TimePoint now = clock_.Now();
  if (absl::Status status = waiters_.Expire(now); !status.ok()) {
    return status;
  }
  // Expire has seen waiters that left, so this stop comes from a shutdown.
  if (stop_.stop_requested()) {
    return ShuttingDown();
  }
  if (progress.solver_bytes > memory_.bytes()) {
    absl::Status status = memory_.GrowTo(progress.solver_bytes + kMemoryStep);
    if (!status.ok()) status = memory_.GrowTo(progress.solver_bytes);
    if (!status.ok()) return status;
  }
  if (now >= next_progress_) {
    next_progress_ = now + progress_interval_;
    waiters_.Publish(progress);
  }
  return absl::OkStatus();
}

}  // namespace geodesic::server
