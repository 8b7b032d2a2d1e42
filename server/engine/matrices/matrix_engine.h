// Distances from each of many sources to the same targets.

#ifndef GEODESIC_SERVER_ENGINE_MATRICES_MATRIX_ENGINE_H_
#define GEODESIC_SERVER_ENGINE_MATRICES_MATRIX_ENGINE_H_

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "absl/status/statusor.h"
#include "geodesic/query.h"
#include "geodesic/rows/matrix.h"
#include "geodesic_types/algorithms.h"
#include "server/engine/base/byte_budget.h"
#include "server/engine/base/clock.h"
#include "server/engine/base/limits.h"
#include "server/engine/jobs/scheduler.h"
#include "server/engine/jobs/solo_job.h"
#include "server/engine/matrices/matrix_rows.h"
#include "server/engine/meshes/mesh_library.h"
#include "server/engine/meshes/method_store.h"
#include "server/engine/searches/search_engine.h"

namespace geodesic::server {

struct MatrixRequest {
  std::string mesh_digest;
  // Every source is a row and every target a column, in their order. Without
  // targets every vertex is a column.
  Query query;
  // If set, rows are computed by this approximate method; targets are vertices.
  std::optional<MethodHandle> method = {};
  RowFilter filter;
  // How many values of a dense matrix the caller has. Rows that it has as a
  // whole are left out, but for the last of the matrix, unless columns are
  // computed.
  uint64_t received_values = 0;
  TimePoint deadline = kNoDeadline;
  Requester requester;
};

struct MatrixCall {
  MeshHandle mesh;
  std::shared_ptr<MatrixRows> rows;
  uint64_t row_count = 0;
  uint64_t first_row = 0;  // those before are left out
  uint64_t column_count = 0;
  AlgorithmChoice algorithm = kDefaultAlgorithm;  // of the first row
};

// Thread-safe. No call waits for a job.
class MatrixEngine {
 public:
  // REQUIRES: the references outlive the engine, and `scheduler` has no job
  // left when it is destroyed.
  MatrixEngine(const Limits& limits, Scheduler& scheduler, SoloJobs& jobs,
               std::shared_ptr<ByteBudget> solver_memory, MeshLibrary& meshes,
               SearchEngine& searches);

  // Starts to compute the rows of a matrix; see RowPipeline for `on_row`.
  // Errors: as FieldEngine::Compute.
  absl::StatusOr<MatrixCall> Compute(MatrixRequest request,
                                     std::function<void()> on_row);

 private:
  // If columns cost less than rows, and there is memory for the table.
  std::optional<ColumnTable> Transpose(MatrixQuestion& question) const;

  const Limits& limits_;
  Scheduler& scheduler_;
  SoloJobs& jobs_;
  const std::shared_ptr<ByteBudget> solver_memory_;
  MeshLibrary& meshes_;
  SearchEngine& searches_;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_MATRICES_MATRIX_ENGINE_H_
