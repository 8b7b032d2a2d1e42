// Blocks of the matrix of all distances, received row by row.

#ifndef GEODESIC_CLIENT_MATRIX_H_
#define GEODESIC_CLIENT_MATRIX_H_

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "geodesic_client/answer.h"
#include "geodesic_client/surface_point.h"

namespace geodesic::client {

struct MatrixQuery {
  std::string mesh_digest;
  // A row each; at least one.
  std::vector<Source> sources;
  // A column each. DEFAULT: empty, every vertex is a column.
  std::vector<SurfacePoint> targets;
  // As in FieldQuery.
  std::string algorithm;
  ValueType value_type = ValueType::kFloat64;
  // The searches end here. DEFAULT: no limit.
  std::optional<double> radius;
  // Whether to send only the finite values, with their columns.
  bool sparse = false;
  Priority priority = Priority::kInteractive;
};

struct MatrixShape {
  uint64_t rows = 0;
  uint64_t columns = 0;
};

struct MatrixRow {
  uint64_t row = 0;
  // The columns of `values`, ascending. Empty in a matrix that is not sparse,
  // whose rows hold a value for every column; +infinity where no path leads or
  // the search did not come.
  std::span<const uint32_t> columns;
  std::span<const double> values;
};

// Where a matrix goes. A status that is not OK ends the call with it. One row
// is in memory at a time; a slow receiver slows the server down.
struct MatrixReceiver {
  // Called once, first. May be empty.
  std::function<absl::Status(const MatrixShape&)> on_shape;
  // Called for every row, in order; the spans are valid during the call.
  std::function<absl::Status(const MatrixRow&)> on_row;
  // Called with the rows computed so far and those there are. May be empty.
  std::function<void(uint64_t finished, uint64_t rows)> on_progress;
};

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_MATRIX_H_
