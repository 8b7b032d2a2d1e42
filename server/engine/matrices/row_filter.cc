#include "server/engine/matrices/row_filter.h"

#include <utility>
#include <vector>

#include "geodesic/matrix_rows.h"

namespace geodesic::server {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::vector<uint32_t> FiniteOnes(const std::vector<double>& values) {
  std::vector<uint32_t> columns;
  for (uint32_t column = 0; column < values.size(); ++column) {
    if (values[column] < kInfinity) columns.push_back(column);
  }
  return columns;
}

}  // namespace

void RowFilter::Apply(MatrixRow& row) const {
  for (double& value : row.values) {
    if (value > radius) value = kInfinity;
  }
  if (sparse || nearest.has_value()) {
    row.columns = nearest.has_value() ? NearestOf(row.values, *nearest)
                                      : FiniteOnes(row.values);
    std::vector<double> kept;
    kept.reserve(row.columns.size());
    for (const uint32_t column : row.columns) {
      kept.push_back(row.values[column]);
    }
    row.values = std::move(kept);
  }
  row.columns.shrink_to_fit();
  row.values.shrink_to_fit();
  row.memory.ShrinkTo(row.values.size() * sizeof(double) +
                      row.columns.size() * sizeof(uint32_t));
}

}  // namespace geodesic::server
