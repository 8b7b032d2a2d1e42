#include "server/engine/rows/matrix_rows.h"

namespace geodesic::server {

std::optional<absl::StatusOr<AnswerRow>> MatrixRows::Take() {
  if (!table_.has_value()) return pipeline_->Take();
  MatrixTable& values = table_->values;
  while (columns_ < values.columns()) {
    std::optional<absl::StatusOr<AnswerRow>> column = pipeline_->Take();
    if (!column.has_value() || !column->ok()) return column;
    values.Add(columns_++, **column);
  }
  if (next_row_ == values.rows()) return std::nullopt;
  return AnswerRow{values.Row(next_row_++), {}};
}

uint64_t MatrixRows::rows_finished() const {
  if (!table_.has_value()) return pipeline_->rows_finished();
  return columns_ * table_->values.rows() / table_->values.columns();
}

}  // namespace geodesic::server
