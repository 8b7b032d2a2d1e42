// Computes the rows of a matrix.

#ifndef GEODESIC_SERVER_ENGINE_MATRICES_MATRIX_WORK_H_
#define GEODESIC_SERVER_ENGINE_MATRICES_MATRIX_WORK_H_

#include <cstddef>
#include <cstdint>
#include <optional>

#include "absl/status/statusor.h"
#include "geodesic/checkpoint.h"
#include "geodesic/matrix_rows.h"
#include "geodesic/solve_options.h"
#include "geodesic/valid_query.h"
#include "server/engine/jobs/row_pipeline.h"
#include "server/engine/jobs/start_function.h"
#include "server/engine/matrices/row_filter.h"
#include "server/engine/meshes/mesh_store.h"
#include "server/engine/meshes/method_store.h"
#include "server/engine/searches/search_engine.h"

namespace geodesic::server {

// One question. Const functions are thread-safe.
struct MatrixWork {
  // What answers questions. They outlive the work.
  const StartFunction& start;
  const SolveOptions& options;
  SearchEngine& searches;

  MeshHandle mesh;
  // Every source is a row; every target a column, or without targets every
  // vertex.
  ValidQuery query;
  std::optional<MethodHandle> method;  // if distances are approximate
  RowFilter filter;

  uint64_t rows() const { return query->sources.size(); }
  uint64_t columns() const;
  // The most memory that one row takes, for its solver and for its values.
  uint64_t PlannedBytes() const;
  uint64_t RowBytes() const;

  // Whether fields from the targets, whose values are put in rows then, cost
  // less. Says that landmarks are wanted, if searches may need them.
  bool TransposingPays() const;

  // REQUIRES: it is given RowBytes. Errors: the checkpoint's.
  absl::StatusOr<MatrixRow> Answer(uint64_t row, Checkpoint& checkpoint,
                                   ByteReservation memory) const;

 private:
  // Of the targets, as many as a row is about.
  uint64_t wanted() const;
  MatrixShape Shape(size_t field_in_searches) const;
  absl::Status Compute(const ValidQuery& of_row, Checkpoint& checkpoint,
                       MatrixRow& result) const;
  // The distances of the targets, or of all vertices, by the method.
  absl::Status Approximate(const ValidQuery& of_row, Checkpoint& checkpoint,
                           MatrixRow& result) const;
  absl::Status Search(const ValidQuery& of_row, const SearchMeans& means,
                      Checkpoint& checkpoint, MatrixRow& result) const;
  absl::Status Solve(const ValidQuery& of_row, Checkpoint& checkpoint,
                     MatrixRow& result) const;
  // What searches for the targets of a row have, if they may take the place of
  // a field.
  std::optional<SearchMeans> MeansFor(const ValidQuery& of_row) const;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_MATRICES_MATRIX_WORK_H_
