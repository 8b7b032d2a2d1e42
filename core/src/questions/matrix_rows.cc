#include "geodesic/matrix_rows.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace geodesic {
namespace {

// The parts of a whole field that each way to compute a row takes.
double FieldCost(const MatrixShape& shape) {
  return static_cast<double>(shape.wanted) / static_cast<double>(shape.targets);
}

double SearchCost(const MatrixShape& shape) {
  if (shape.field_in_searches == 0) {
    return std::numeric_limits<double>::infinity();
  }
  return static_cast<double>(shape.targets) /
         static_cast<double>(shape.field_in_searches);
}

double Cost(const MatrixShape& shape) {
  return static_cast<double>(shape.sources) *
         std::min(FieldCost(shape), SearchCost(shape));
}

}  // namespace

bool SearchingPays(const MatrixShape& shape) {
  return SearchCost(shape) < FieldCost(shape);
}

bool TransposingPays(const MatrixShape& shape) {
  const MatrixShape transposed{.sources = shape.targets,
                               .targets = shape.sources,
                               .wanted = shape.sources,
                               .field_in_searches = shape.field_in_searches};
  return 2 * Cost(transposed) < Cost(shape);
}

std::vector<uint32_t> NearestOf(std::span<const double> values,
                                uint64_t count) {
  std::vector<uint32_t> order;
  for (uint32_t i = 0; i < values.size(); ++i) {
    if (std::isfinite(values[i])) order.push_back(i);
  }
  const size_t kept = std::min<uint64_t>(count, order.size());
  std::ranges::partial_sort(
      order, order.begin() + static_cast<std::ptrdiff_t>(kept), {},
      [&](uint32_t i) { return std::pair(values[i], i); });
  order.resize(kept);
  return order;
}

}  // namespace geodesic
