// Hands out the rows of a matrix in order, whether rows or columns are
// computed.

#ifndef GEODESIC_SERVER_ENGINE_ROWS_MATRIX_ROWS_H_
#define GEODESIC_SERVER_ENGINE_ROWS_MATRIX_ROWS_H_

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

#include "absl/status/statusor.h"
#include "geodesic/rows/matrix.h"
#include "server/engine/base/byte_budget.h"
#include "server/engine/jobs/row_pipeline.h"

namespace geodesic::server {

// Takes columns, and gives rows.
struct ColumnTable {
  ByteReservation memory;
  MatrixTable values;
};

// Not thread-safe, but for Cancel.
class MatrixRows {
 public:
  // If there is a `table`, the pipeline's rows are its columns; otherwise they
  // are the rows.
  MatrixRows(std::shared_ptr<RowPipeline> pipeline,
             std::optional<ColumnTable> table)
      : pipeline_(std::move(pipeline)), table_(std::move(table)) {}

  // As those of RowPipeline.
  std::optional<absl::StatusOr<AnswerRow>> Take();
  void Cancel() { pipeline_->Cancel(); }
  // As far as columns are computed, so are rows.
  uint64_t rows_finished() const;
  double seconds() const { return pipeline_->seconds(); }
  uint64_t windows_propagated() const {
    return pipeline_->windows_propagated();
  }

 private:
  const std::shared_ptr<RowPipeline> pipeline_;
  std::optional<ColumnTable> table_;
  uint64_t columns_ = 0;   // that the table has
  uint64_t next_row_ = 0;  // of the table
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_ROWS_MATRIX_ROWS_H_
