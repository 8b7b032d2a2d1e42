#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "geodesic/rows/matrix.h"

namespace geodesic {
namespace {

// The numbers of the finite values.
std::vector<uint32_t> FiniteOnes(std::span<const double> values) {
  std::vector<uint32_t> columns;
  for (uint32_t column = 0; column < values.size(); ++column) {
    if (std::isfinite(values[column])) columns.push_back(column);
  }
  return columns;
}

// Of these the `count` least, in their order. O(n + count log count).
std::vector<uint32_t> NearestOnes(std::span<const double> values,
                                  uint64_t count) {
  std::vector<std::pair<double, uint32_t>> order;
  for (const uint32_t column : FiniteOnes(values)) {
    order.emplace_back(values[column], column);
  }
  if (count < order.size()) {
    std::ranges::nth_element(
        order, order.begin() + static_cast<std::ptrdiff_t>(count));
    order.resize(count);
  }
  std::ranges::sort(order);
  std::vector<uint32_t> columns;
  columns.reserve(order.size());
  for (const auto& [value, column] : order) columns.push_back(column);
  return columns;
}

}  // namespace

void RowFilter::Apply(DistanceRow& row) const {
  for (double& value : row.values) {
    if (value > radius) value = std::numeric_limits<double>::infinity();
  }
  if (sparse || nearest.has_value()) {
    row.columns = nearest.has_value() ? NearestOnes(row.values, *nearest)
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
}

}  // namespace geodesic
