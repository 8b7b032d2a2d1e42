#include "server/engine/solo_job.h"

#include <chrono>
#include <mutex>
#include <stop_token>
#include <utility>

#include "server/engine/guarded.h"
#include "server/engine/job_checkpoint.h"

namespace geodesic::server {

class SoloJobs::Audience final : public JobAudience {
 public:
  Audience(std::shared_ptr<JobObserver> observer, TimePoint deadline)
      : deadline_(deadline), observer_(std::move(observer)) {}

  absl::Status Expire(TimePoint now) override {
    if (Observer() == nullptr) {
      return absl::CancelledError("nobody waits for the answer");
    }
    if (deadline_ > now) return absl::OkStatus();
    return absl::DeadlineExceededError(
        "the deadline came before the answer was computed");
  }

  void Publish(const Progress& progress) override {
    if (const auto observer = Observer()) observer->OnProgress(progress);
  }

  // Tells how the job ended, unless the observer has left.
  void Report(const JobReport& report) {
    if (const auto observer = Leave()) observer->OnDone(report);
  }

  // The observer, which is forgotten.
  std::shared_ptr<JobObserver> Leave() {
    std::lock_guard lock(mutex_);
    return std::exchange(observer_, nullptr);
  }

 private:
  std::shared_ptr<JobObserver> Observer() {
    std::lock_guard lock(mutex_);
    return observer_;
  }

  const TimePoint deadline_;
  std::mutex mutex_;
  std::shared_ptr<JobObserver> observer_;  // guarded by mutex_
};

SoloJobs::SoloJobs(const Clock& clock, Scheduler& scheduler,
                   std::shared_ptr<ByteBudget> solver_memory,
                   Duration progress_interval)
    : clock_(clock),
      scheduler_(scheduler),
      solver_memory_(std::move(solver_memory)),
      progress_interval_(progress_interval) {}

absl::StatusOr<SoloJobs::Call> SoloJobs::Start(
    SoloJob job, std::shared_ptr<JobObserver> observer) {
  absl::Status fits =
      solver_memory_->CheckCapacity(job.planned_bytes + job.answer_bytes);
  if (!fits.ok()) return fits;
  auto audience = std::make_shared<Audience>(std::move(observer), job.deadline);
  auto memory = std::make_shared<Memory>();
  absl::StatusOr<Scheduler::JobId> id = scheduler_.Submit(
      {.priority = job.priority,
       .client = std::move(job.client),
       .is_continuation = job.is_continuation,
       .reserve =
           [this, memory, planned = job.planned_bytes,
            answer = job.answer_bytes] {
             return Reserve(planned, answer, *memory);
           },
       .run =
           [this, audience, memory,
            work = std::move(job.work)](std::stop_token stop) mutable {
             JobCheckpoint checkpoint(*audience, clock_, std::move(stop),
                                      std::move(memory->solver),
                                      progress_interval_);
             const TimePoint begin = clock_.Now();
             absl::Status status = audience->Expire(begin);
             if (status.ok()) {
               status = Guarded("answered a request", [&] {
                 return work(checkpoint, std::move(memory->answer));
               });
             }
             work = nullptr;  // what it captured goes before anyone hears
             audience->Report(
                 {std::move(status),
                  std::chrono::duration<double>(clock_.Now() - begin).count(),
                  checkpoint.windows_propagated()});
           },
       .abandon =
           [audience](const absl::Status& why) {
             audience->Report({.status = why});
           }});
  if (!id.ok()) {
    audience->Leave();
    return id.status();
  }
  return Call{*id, std::move(audience)};
}

absl::Status SoloJobs::Reserve(uint64_t solver_bytes, uint64_t answer_bytes,
                               Memory& memory) const {
  auto solver = ByteReservation::Make(solver_memory_, solver_bytes);
  if (!solver.ok()) return solver.status();
  auto answer = ByteReservation::Make(solver_memory_, answer_bytes);
  if (!answer.ok()) return answer.status();
  memory = {*std::move(solver), *std::move(answer)};
  return absl::OkStatus();
}

void SoloJobs::Cancel(const Call& call) {
  if (call.audience == nullptr) return;
  call.audience->Leave();
  scheduler_.Cancel(call.job);
}

}  // namespace geodesic::server
