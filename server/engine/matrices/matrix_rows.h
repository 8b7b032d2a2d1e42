// Hands out the rows of a matrix in order, whether rows or columns are
// computed.

#ifndef GEODESIC_SERVER_ENGINE_MATRICES_MATRIX_ROWS_H_
#define GEODESIC_SERVER_ENGINE_MATRICES_MATRIX_ROWS_H_

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "absl/status/statusor.h"
#include "server/engine/base/byte_budget.h"
#include "server/engine/jobs/row_pipeline.h"
#include "server/engine/matrices/row_filter.h"

namespace geodesic::server {

// The values of a matrix, column by column, until all are there.
class ColumnTable {
 public:
  // Row r has offsets[r] more than its columns say. `memory` is what it holds:
  // PlannedBytes.
  ColumnTable(std::vector<double> offsets, uint64_t columns, RowFilter filter,
              ByteReservation memory);

  static uint64_t PlannedBytes(uint64_t rows, uint64_t columns);

  uint64_t columns_taken() const { return taken_; }
  uint64_t columns() const { return columns_; }
  bool is_whole() const { return taken_ == columns_; }
  uint64_t rows() const { return offsets_.size(); }

  // The next column: a value for each row. REQUIRES: !is_whole().
  void Add(const MatrixRow& column);
  // REQUIRES: is_whole().
  MatrixRow Row(uint64_t row) const;

 private:
  const std::vector<double> offsets_;
  const uint64_t columns_;
  const RowFilter filter_;
  ByteReservation memory_;
  std::vector<double> values_;  // by rows
  uint64_t taken_ = 0;
  double certified_error_ = 0;
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
  std::optional<absl::StatusOr<MatrixRow>> Take();
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
  uint64_t next_ = 0;  // row of the table
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_MATRICES_MATRIX_ROWS_H_
