#include "server/engine/matrices/matrix_rows.h"

#include <algorithm>
#include <utility>

namespace geodesic::server {

ColumnTable::ColumnTable(std::vector<double> offsets, uint64_t columns,
                         RowFilter filter, ByteReservation memory)
    : offsets_(std::move(offsets)),
      columns_(columns),
      filter_(filter),
      memory_(std::move(memory)),
      values_(offsets_.size() * columns) {}

uint64_t ColumnTable::PlannedBytes(uint64_t rows, uint64_t columns) {
  const uint64_t of_row = columns * (sizeof(double) + sizeof(uint32_t));
  return rows * (columns + 1) * sizeof(double) + of_row;
}

void ColumnTable::Add(const MatrixRow& column) {
  for (uint64_t row = 0; row < rows(); ++row) {
    values_[row * columns_ + taken_] = offsets_[row] + column.values[row];
  }
  certified_error_ = std::max(certified_error_, column.certified_error);
  ++taken_;
}

MatrixRow ColumnTable::Row(uint64_t row) const {
  const auto begin =
      values_.begin() + static_cast<std::ptrdiff_t>(row * columns_);
  MatrixRow result{
      .values = {begin, begin + static_cast<std::ptrdiff_t>(columns_)},
      .certified_error = certified_error_};
  filter_.Apply(result);
  return result;
}

std::optional<absl::StatusOr<MatrixRow>> MatrixRows::Take() {
  if (!table_.has_value()) return pipeline_->Take();
  while (!table_->is_whole()) {
    std::optional<absl::StatusOr<MatrixRow>> column = pipeline_->Take();
    if (!column.has_value() || !column->ok()) return column;
    table_->Add(**column);
  }
  if (next_ == table_->rows()) return std::nullopt;
  return table_->Row(next_++);
}

uint64_t MatrixRows::rows_finished() const {
  if (!table_.has_value()) return pipeline_->rows_finished();
  return table_->columns_taken() * table_->rows() / table_->columns();
}

}  // namespace geodesic::server
