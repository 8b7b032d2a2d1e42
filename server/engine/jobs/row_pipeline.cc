#include "server/engine/jobs/row_pipeline.h"

#include <utility>

namespace geodesic::server {

absl::StatusOr<AnswerRow> Charge(absl::StatusOr<DistanceRow> row,
                                 ByteReservation memory) {
  if (!row.ok()) return row.status();
  memory.ShrinkTo(row->bytes());
  absl::Status status = memory.GrowTo(row->bytes());
  if (!status.ok()) return status;
  return AnswerRow{*std::move(row), std::move(memory)};
}

RowPipeline::RowPipeline(SoloJobs& jobs, Scheduler& scheduler, RowJobs plan,
                         uint64_t rows, RowFunction function,
                         std::function<void()> on_row)
    : jobs_(jobs),
      scheduler_(scheduler),
      rows_(rows),
      function_(std::move(function)),
      plan_(std::move(plan)),
      on_row_(std::move(on_row)),
      next_row_(plan_.first_row),
      next_take_(plan_.first_row),
      rows_finished_(plan_.first_row) {}

absl::Status RowPipeline::Start() {
  MutexLock lock(mutex_);
  if (!plan_.is_continuation) {
    absl::StatusOr<Scheduler::Place> held = scheduler_.HoldPlace(plan_.client);
    if (!held.ok()) return held.status();
    place_ = *std::move(held);
  }
  return SubmitNext();
}

absl::Status RowPipeline::SubmitNext() {
  const uint64_t row = next_row_;
  auto result = std::make_shared<AnswerRow>();
  absl::StatusOr<SoloJobs::Call> call = jobs_.Start(
      {.priority = plan_.priority,
       .client = plan_.client,
       .account = plan_.account,
       .is_continuation = true,
       .deadline = plan_.deadline,
       .planned_bytes = plan_.planned_bytes,
       .answer_bytes = plan_.row_bytes,
       .work =
           [self = shared_from_this(), row, result](Checkpoint& checkpoint,
                                                    ByteReservation memory) {
             self->Begin();
             absl::StatusOr<AnswerRow> computed =
                 self->function_(row, checkpoint, std::move(memory));
             if (!computed.ok()) return computed.status();
             *result = *std::move(computed);
             return absl::OkStatus();
           },
       .done =
           [self = shared_from_this(), row, result](const JobReport& report) {
             self->Finish(row, report, std::move(*result));
           }});
  if (!call.ok()) return call.status();
  running_.emplace(next_row_++, *std::move(call));
  is_waiting_ = true;
  return absl::OkStatus();
}

void RowPipeline::GoOn() {
  if (!failure_.ok() || is_waiting_) return;
  if (next_row_ < rows_ && next_row_ <= next_take_ + scheduler_.max_running()) {
    failure_ = SubmitNext();
  }
  if (!failure_.ok() || (next_row_ == rows_ && !is_waiting_)) Release();
}

void RowPipeline::Release() {
  place_.reset();
  plan_.account.reset();
}

void RowPipeline::Begin() {
  MutexLock lock(mutex_);
  is_waiting_ = false;
  GoOn();
}

void RowPipeline::Finish(uint64_t row, const JobReport& report,
                         AnswerRow result) {
  std::function<void()> on_row;
  {
    MutexLock lock(mutex_);
    running_.erase(row);
    seconds_ += report.seconds;
    windows_propagated_ += report.windows_propagated;
    if (report.status.ok()) {
      ++rows_finished_;
      finished_.emplace(row, std::move(result));
    } else if (failure_.ok()) {
      failure_ = report.status;
      Release();
    }
    on_row = on_row_;
    // on_row_ holds the reader, which holds the pipeline: break that cycle.
    if (!failure_.ok() || rows_finished_ == rows_) on_row_ = nullptr;
  }
  if (on_row) on_row();
}

std::optional<absl::StatusOr<AnswerRow>> RowPipeline::Take() {
  MutexLock lock(mutex_);
  // Rows before the one that failed are still handed out.
  const auto it = finished_.find(next_take_);
  if (it == finished_.end()) {
    if (failure_.ok()) return std::nullopt;
    return failure_;
  }
  AnswerRow row = std::move(it->second);
  finished_.erase(it);
  ++next_take_;
  GoOn();
  return row;
}

void RowPipeline::Cancel() {
  // Destroyed after the lock is released.
  std::map<uint64_t, SoloJobs::Call> running;
  std::map<uint64_t, AnswerRow> finished;
  std::function<void()> on_row;
  {
    MutexLock lock(mutex_);
    if (failure_.ok()) failure_ = absl::CancelledError("nobody waits");
    Release();
    running.swap(running_);
    finished.swap(finished_);
    on_row.swap(on_row_);
  }
  for (const auto& [row, call] : running) jobs_.Cancel(call);
}

uint64_t RowPipeline::rows_finished() const {
  MutexLock lock(mutex_);
  return rows_finished_;
}

double RowPipeline::seconds() const {
  MutexLock lock(mutex_);
  return seconds_;
}

uint64_t RowPipeline::windows_propagated() const {
  MutexLock lock(mutex_);
  return windows_propagated_;
}

}  // namespace geodesic::server
