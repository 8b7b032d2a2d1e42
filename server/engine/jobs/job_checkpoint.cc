#include "server/engine/jobs/job_checkpoint.h"

#include <algorithm>
#include <utility>

#include "server/engine/base/status_details.h"
#include "server/engine/jobs/processor_share.h"

namespace geodesic::server {
namespace {

// The reservation grows in steps of this size while there is room, so it also
// covers what the solver takes between two polls.
constexpr uint64_t kMemoryStep = uint64_t{16} << 20;

}  // namespace

JobCheckpoint::JobCheckpoint(JobWaiters& waiters, const Clock& clock,
                             Scheduler& scheduler, std::stop_token stop,
                             Duration progress_interval)
    : waiters_(waiters),
      clock_(clock),
      scheduler_(scheduler),
      stop_(std::move(stop)),
      progress_interval_(progress_interval),
      began_(clock.Now()),
      next_progress_(began_) {}

absl::Status JobCheckpoint::Poll(const Progress& progress) {
  windows_propagated_ = progress.windows_propagated;
  const TimePoint now = clock_.Now();
  MakeWay(now - began_);
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

// It does not yield at each poll instead: since 6.18 Linux charges a thread
// that yields the rest of its time slice, so it would get next to nothing
// beside threads that do not.
void JobCheckpoint::MakeWay(Duration ran) {
  if (!is_long_) is_long_ = scheduler_.LetOthersStart(ran);
  if (is_long_ && scheduler_.HasSeveralClients()) {
    ShareByAge(std::max(ran, kYoung));
  }
}

}  // namespace geodesic::server
