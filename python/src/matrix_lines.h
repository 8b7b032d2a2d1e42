// The values of a matrix of distances, by rows or by columns, whichever costs
// less.

#ifndef GEODESIC_PYTHON_MATRIX_LINES_H_
#define GEODESIC_PYTHON_MATRIX_LINES_H_

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/checkpoint.h"
#include "geodesic/matrix_rows.h"
#include "geodesic/valid_query.h"
#include "subject.h"
#include "watch.h"

namespace geodesic::python {

// Of each source its distances to the targets, or to all vertices where there
// are no targets.
class MatrixLines {
 public:
  // A line's values: for each target or vertex if it is a row, for each source
  // if it is a column.
  using Put = std::function<void(uint64_t number, std::span<double> values)>;

  // Values beyond `radius` are +infinity. So many targets of each source are
  // wanted, the nearest ones; the others may be +infinity.
  MatrixLines(QueryHandle question, double radius, uint64_t wanted);

  // Whether the lines are columns.
  bool are_columns() const { return transposed_.has_value(); }

  // Computes all lines, on `threads` threads, from which it calls `put` for
  // each. Errors: as RunRows.
  absl::Status Compute(uint32_t threads, Watch& watch, const Put& put) const;

  // The same, but lines are rows; columns are kept in a table until all are
  // there.
  absl::Status ComputeRows(uint32_t threads, Watch& watch,
                           const Put& put) const;

 private:
  absl::StatusOr<std::vector<double>> LineOf(const ValidQuery& of_line,
                                             uint64_t wanted,
                                             Checkpoint& checkpoint) const;
  // For each source of the query.
  absl::Status ComputeSources(const ValidQuery& query, uint64_t wanted,
                              uint32_t threads, Watch& watch,
                              const Put& put) const;
  MatrixShape ShapeOf(const ValidQuery& of_line, uint64_t sources,
                      uint64_t wanted) const;

  const QueryHandle question_;
  const double radius_;
  const uint64_t wanted_;
  std::optional<ValidQuery> transposed_;
};

}  // namespace geodesic::python

#endif  // GEODESIC_PYTHON_MATRIX_LINES_H_
