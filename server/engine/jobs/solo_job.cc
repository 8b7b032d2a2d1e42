#include "server/engine/jobs/solo_job.h"

#include <chrono>
#include <optional>
#include <utility>

namespace geodesic::server {

SoloJobs::SoloJobs(const Clock& clock, Scheduler& scheduler,
                   std::shared_ptr<ByteBudget> solver_memory,
                   Duration progress_interval)
    : clock_(clock),
      solver_memory_(std::move(solver_memory)),
      jobs_(scheduler, clock, progress_interval) {}

absl::StatusOr<SoloJobs::Call> SoloJobs::Start(SoloJob job) {
  absl::Status fits =
      solver_memory_->CheckCapacity(job.planned_bytes + job.answer_bytes);
  if (!fits.ok()) return fits;
  Waiter<JobReport> waiter{
      .done =
          [done =
               std::move(job.done)](const absl::StatusOr<JobReport>& report) {
            done(report.ok() ? *report : JobReport{.status = report.status()});
          },
      .progress = std::move(job.progress),
      .deadline = job.deadline,
      .account = std::move(job.account)};
  auto memory = std::make_shared<Memory>();
  return jobs_.Join(next_key_++, std::move(waiter), job.priority, [&] {
    return SharedWork<JobReport>{
        .client = std::move(job.client),
        .is_continuation = job.is_continuation,
        .reserve = [this, memory, planned = job.planned_bytes,
                    answer = job.answer_bytes]() -> absl::Status {
          auto solver = ByteReservation::Make(solver_memory_, planned);
          if (!solver.ok()) return solver.status();
          auto rest = ByteReservation::Make(solver_memory_, answer);
          if (!rest.ok()) return rest.status();
          *memory = {*std::move(solver), *std::move(rest)};
          return absl::OkStatus();
        },
        .run = [this, memory,
                work = std::move(job.work)](JobCheckpoint& checkpoint) mutable
        -> absl::StatusOr<std::optional<JobReport>> {
          checkpoint.Hold(std::move(memory->solver));
          const TimePoint begin = clock_.Now();
          absl::Status status = work(checkpoint, std::move(memory->answer));
          if (!status.ok()) return status;
          return JobReport{
              .seconds =
                  std::chrono::duration<double>(clock_.Now() - begin).count(),
              .windows_propagated = checkpoint.windows_propagated()};
        }};
  });
}

}  // namespace geodesic::server
