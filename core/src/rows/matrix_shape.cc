#include "rows/matrix_shape.h"

#include <algorithm>
#include <limits>

namespace geodesic {
namespace {

// The parts of a whole field that each way to compute a line takes.
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

}  // namespace geodesic
