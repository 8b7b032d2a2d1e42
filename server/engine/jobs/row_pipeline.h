// Computes each row of an answer (of a matrix; some pairs, lines or paths) in a
// job of its own and hands the rows out in order. Only a few rows are computed
// ahead of the reader.

#ifndef GEODESIC_SERVER_ENGINE_JOBS_ROW_PIPELINE_H_
#define GEODESIC_SERVER_ENGINE_JOBS_ROW_PIPELINE_H_

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/checkpoint.h"
#include "geodesic/rows/rows.h"
#include "geodesic/trace.h"
#include "server/engine/base/byte_budget.h"
#include "server/engine/base/clock.h"
#include "server/engine/jobs/solo_job.h"
#include "server/locks/mutex.h"

namespace geodesic::server {

// A row, and the memory that it takes.
struct AnswerRow : DistanceRow {
  ByteReservation memory;
  // Of a question about straight lines, in place of values.
  std::vector<TracedLine> lines = {};
};

// The row in the `memory` it was given, of which it keeps what it takes.
// Errors: its own; as ByteReservation::GrowTo.
absl::StatusOr<AnswerRow> Charge(absl::StatusOr<DistanceRow> row,
                                 ByteReservation memory);

// Computes a row in the `memory` it is given. Must be thread-safe, because rows
// are computed in parallel.
using RowFunction = std::function<absl::StatusOr<AnswerRow>(
    uint64_t row, Checkpoint&, ByteReservation memory)>;

// What the jobs of all rows have in common.
struct RowJobs {
  std::string client;  // see Requester
  // See Waiter. Held until the last row begins, and by the jobs of rows.
  std::shared_ptr<const void> account = {};
  // Whether the rows go on with a question that was admitted before: they take
  // no place in the queue.
  bool is_continuation = false;
  JobPriority priority = JobPriority::kRow;
  TimePoint deadline = kNoDeadline;
  // Rows before this one are not computed.
  uint64_t first_row = 0;
  // For one row: its solver's memory and its own; see SoloJob.
  uint64_t planned_bytes = 0;
  uint64_t row_bytes = 0;
};

// Thread-safe. Held by the reader of the rows and by the running jobs.
class RowPipeline : public std::enable_shared_from_this<RowPipeline> {
 public:
  // One row more than `scheduler` runs jobs may be computed or wait to be
  // taken, so no thread waits for the reader to take one; one row at a time
  // waits for a thread. `on_row` is called from a job's thread when there may
  // be a row to take. It must be short, and may still be called during Cancel
  // and just after it.
  // REQUIRES: there is a row; `jobs` run on `scheduler`, and both outlive the
  // pipeline's jobs.
  RowPipeline(SoloJobs& jobs, Scheduler& scheduler, RowJobs plan, uint64_t rows,
              RowFunction function, std::function<void()> on_row);

  // Call once. Holds a place in the queue until the last row begins, because
  // the reader may pause and then take many rows at once; a continuation needs
  // none.
  // Errors: as Scheduler::HoldPlace and SoloJobs::Start.
  absl::Status Start();

  // The next row if it is finished, or the error if there will be none.
  std::optional<absl::StatusOr<AnswerRow>> Take();

  // No more rows will be taken: running jobs stop at their next poll.
  void Cancel();

  // Totals of the jobs that have ended, and of rows that needed none:
  uint64_t rows_finished() const;
  double seconds() const;
  uint64_t windows_propagated() const;

 private:
  // Called when the waiting row gets a thread; the next row may then wait.
  void Begin();
  void Finish(uint64_t row, const JobReport& report, AnswerRow result);

  absl::Status SubmitNext() ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_);
  // Submits the next row when it is due.
  void GoOn() ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_);
  // No more rows will be submitted.
  void Release() ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_);

  SoloJobs& jobs_;
  Scheduler& scheduler_;
  const uint64_t rows_;
  const RowFunction function_;

  mutable Mutex mutex_;
  RowJobs plan_ ABSL_GUARDED_BY(mutex_);
  std::function<void()> on_row_ ABSL_GUARDED_BY(mutex_);
  Scheduler::Place place_ ABSL_GUARDED_BY(mutex_);
  // Row next_row_ - 1 waits for a thread.
  bool is_waiting_ ABSL_GUARDED_BY(mutex_) = false;
  // The next to submit, and the next to take.
  uint64_t next_row_ ABSL_GUARDED_BY(mutex_);
  uint64_t next_take_ ABSL_GUARDED_BY(mutex_);
  std::map<uint64_t, SoloJobs::Call> running_ ABSL_GUARDED_BY(mutex_);
  std::map<uint64_t, AnswerRow> finished_ ABSL_GUARDED_BY(mutex_);
  absl::Status failure_ ABSL_GUARDED_BY(mutex_);
  uint64_t rows_finished_ ABSL_GUARDED_BY(mutex_);
  double seconds_ ABSL_GUARDED_BY(mutex_) = 0;
  uint64_t windows_propagated_ ABSL_GUARDED_BY(mutex_) = 0;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_JOBS_ROW_PIPELINE_H_
