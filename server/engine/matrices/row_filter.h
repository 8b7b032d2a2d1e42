// What a row of a matrix keeps of its values.

#ifndef GEODESIC_SERVER_ENGINE_MATRICES_ROW_FILTER_H_
#define GEODESIC_SERVER_ENGINE_MATRICES_ROW_FILTER_H_

#include <cstdint>
#include <limits>
#include <optional>

#include "server/engine/jobs/row_pipeline.h"

namespace geodesic::server {

struct RowFilter {
  // Larger values become infinite.
  double radius = std::numeric_limits<double>::infinity();
  // Whether rows leave out infinite values and list columns.
  bool sparse = false;
  // If set, each row has only this many of its least finite values, in
  // ascending order, and lists columns.
  std::optional<uint64_t> nearest = {};

  // REQUIRES: the row has a value for each column. Shrinks its memory, which
  // may be none, to what it keeps. O(columns).
  void Apply(MatrixRow& row) const;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_MATRICES_ROW_FILTER_H_
