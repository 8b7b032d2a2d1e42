#include <algorithm>

#include "geodesic/rows/matrix.h"

namespace geodesic {

MatrixTable::MatrixTable(const MatrixQuestion& question)
    : rows_(question.rows()),
      columns_(question.columns()),
      filter_(question.filter()),
      values_(rows_ * columns_) {}

uint64_t MatrixTable::PlannedBytes(uint64_t rows, uint64_t columns) {
  // With the offsets of the rows, and a row that is given.
  const uint64_t of_row = columns * (sizeof(double) + sizeof(uint32_t));
  return rows * (columns + 1) * sizeof(double) + of_row;
}

void MatrixTable::Add(uint64_t column, const DistanceRow& line) {
  for (uint64_t row = 0; row < rows_; ++row) {
    values_[row * columns_ + column] = line.values[row];
  }
  certified_error_ = std::max(certified_error_, line.certified_error);
}

DistanceRow MatrixTable::Row(uint64_t row) const {
  const auto begin =
      values_.begin() + static_cast<std::ptrdiff_t>(row * columns_);
  DistanceRow result{
      .values = {begin, begin + static_cast<std::ptrdiff_t>(columns_)},
      .certified_error = certified_error_};
  filter_.Apply(result);
  return result;
}

}  // namespace geodesic
