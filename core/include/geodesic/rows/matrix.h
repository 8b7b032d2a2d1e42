// Matrices of distances, and the nearest targets of each source.
//
//   KeptSearches searches(*mesh);
//   auto question = MatrixQuestion::Make(*mesh, query, {}, {}, searches);
//   for (uint64_t line = 0; line < question->lines(); ++line) {
//     absl::StatusOr<DistanceRow> row = question->Answer(line, checkpoint);
//   }
//
// Every source of the query is a row, and every target a column; without
// targets every vertex is one. Where targets are fewer than sources, the
// columns may cost less:
//
//   if (question->TransposingPays()) question->Transpose();
//   MatrixTable table(*question);  // lines are columns; it gives rows

#ifndef GEODESIC_ROWS_MATRIX_H_
#define GEODESIC_ROWS_MATRIX_H_

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/checkpoint.h"
#include "geodesic/mesh.h"
#include "geodesic/rows/rows.h"
#include "geodesic/valid_query.h"
#include "geodesic_types/algorithms.h"

namespace geodesic {

// What a row of a matrix keeps of its values.
struct RowFilter {
  // Larger values become infinite.
  double radius = std::numeric_limits<double>::infinity();
  // Whether rows leave out infinite values and list columns.
  bool sparse = false;
  // If set, each row has only this many of its least finite values, in
  // ascending order, equal ones in that of their columns, which it lists.
  std::optional<uint64_t> nearest = {};

  // REQUIRES: the row has a value for each column. O(columns), and their
  // logarithm for the nearest.
  void Apply(DistanceRow& row) const;
};

// One question. Const functions are thread-safe.
class MatrixQuestion {
 public:
  // O(sources + targets). If there is a method, targets are vertices. REQUIRES:
  // mesh and means outlive the question; the query is the mesh's. Errors:
  // INVALID_ARGUMENT with the path (field_path.h) of the offender: "radius",
  // "count" of the nearest, a source or target that the method does not take,
  // "targets" if there are none to be near.
  static absl::StatusOr<MatrixQuestion> Make(const Mesh& mesh, ValidQuery query,
                                             const RowFilter& filter,
                                             std::optional<RowMethod> method,
                                             RowMeans& means);

  uint64_t rows() const { return is_transposed_ ? targets() : lines(); }
  uint64_t columns() const { return is_transposed_ ? lines() : targets(); }
  const RowFilter& filter() const { return filter_; }
  // That of the first line, if it is exact.
  Algorithm algorithm() const;

  // Whether the columns, which are found from the targets, cost less than half
  // of what the rows would. Rows are there when the last column is, and until
  // then take MatrixTable::PlannedBytes.
  bool TransposingPays() const;
  // From now on lines are columns. REQUIRES: TransposingPays(), or at least
  // that there are targets, no source is a curve, and no method is set.
  void Transpose();
  bool is_transposed() const { return is_transposed_; }

  // Of which each is computed alone: the rows, unless they are transposed.
  uint64_t lines() const { return query_->sources.size(); }

  // The most bytes that one line takes, for its solver and for its values.
  uint64_t PlannedBytes() const;
  uint64_t LineBytes() const;

  // A row as the filter leaves it, or a column, whose values beyond the radius
  // are infinite. Costs a field from the line's source, as far as the radius
  // and the wanted targets lie, or searches that cost less. REQUIRES: the
  // method, if there is one, is prepared. Errors: the checkpoint's; what the
  // means return.
  absl::StatusOr<DistanceRow> Answer(uint64_t line,
                                     Checkpoint& checkpoint) const;

 private:
  MatrixQuestion(const Mesh& mesh, ValidQuery query, const RowFilter& filter,
                 std::optional<RowMethod> method, RowMeans& means);

  // Of a line.
  uint64_t targets() const;
  // So many of them are wanted, the nearest ones.
  uint64_t wanted() const;
  // Whether searches may take the place of the line's field.
  bool MayBeSearched(const ValidQuery& of_line) const;

  absl::StatusOr<DistanceRow> Compute(const ValidQuery& of_line,
                                      Checkpoint& checkpoint) const;
  absl::StatusOr<DistanceRow> Approximate(const ValidQuery& of_line,
                                          Checkpoint& checkpoint) const;
  absl::StatusOr<DistanceRow> Solve(const ValidQuery& of_line,
                                    Checkpoint& checkpoint) const;

  const Mesh* mesh_;
  ValidQuery query_;  // of lines: its sources
  RowFilter filter_;
  std::optional<RowMethod> method_;
  RowMeans* means_;
  bool is_transposed_ = false;
  std::vector<double> offsets_;  // of the rows, if they are transposed
};

// The values of a matrix, column by column, until all are there.
class MatrixTable {
 public:
  // Of a question that is transposed.
  explicit MatrixTable(const MatrixQuestion& question);

  // What one of that size takes.
  static uint64_t PlannedBytes(uint64_t rows, uint64_t columns);

  // As many as the question has.
  uint64_t rows() const { return rows_; }
  // As many as the question has lines.
  uint64_t columns() const { return columns_; }

  // What the question answers for a column. In any order. O(rows).
  void Add(uint64_t column, const DistanceRow& line);
  // As the filter leaves it. REQUIRES: all columns were added. O(columns).
  DistanceRow Row(uint64_t row) const;

 private:
  uint64_t rows_, columns_;
  RowFilter filter_;
  std::vector<double> values_;  // by rows
  double certified_error_ = 0;
};

}  // namespace geodesic

#endif  // GEODESIC_ROWS_MATRIX_H_
