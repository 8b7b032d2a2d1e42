// Questions that are answered in rows, a job each: matrices and nearest
// targets, pairs, straight lines, and paths from a field.

#ifndef GEODESIC_SERVER_ENGINE_ROWS_ROW_ENGINE_H_
#define GEODESIC_SERVER_ENGINE_ROWS_ROW_ENGINE_H_

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "geodesic/query.h"
#include "geodesic/rows/matrix.h"
#include "geodesic/trace.h"
#include "geodesic_types/algorithms.h"
#include "geodesic_types/places.h"
#include "server/engine/base/byte_budget.h"
#include "server/engine/base/clock.h"
#include "server/engine/base/limits.h"
#include "server/engine/fields/field_engine.h"
#include "server/engine/jobs/row_pipeline.h"
#include "server/engine/jobs/scheduler.h"
#include "server/engine/jobs/solo_job.h"
#include "server/engine/meshes/mesh_library.h"
#include "server/engine/meshes/method_store.h"
#include "server/engine/rows/matrix_rows.h"
#include "server/engine/rows/pair_work.h"
#include "server/engine/searches/search_engine.h"

namespace geodesic::server {

// Distances from each of many sources to the same targets.
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

// Distances of pairs of points.
struct PairRequest {
  std::string mesh_digest;
  std::vector<PointPair> pairs;
  // Whether rows have paths, too. They are then in order of the pairs.
  bool paths = false;
  // As Query::tolerance; 0 with a method.
  double tolerance = 0;
  // If set, distances are found by this approximate method; all ends are
  // vertices, and there are no paths.
  std::optional<MethodHandle> method = {};
  TimePoint deadline = kNoDeadline;
  Requester requester;
};

struct PairCall {
  MeshHandle mesh;
  // That of the searches.
  AlgorithmChoice algorithm = kDefaultAlgorithm;
  uint64_t pair_count = 0;
  // Their columns are numbers of pairs; PairOrder puts these in order.
  std::shared_ptr<RowPipeline> rows;
  // For its counts.
  std::shared_ptr<const PairWork> work;
};

// Straight lines from places in directions.
struct LineRequest {
  std::string mesh_digest;
  LineQuestion lines;
  TimePoint deadline = kNoDeadline;
  Requester requester;
};

struct LineCall {
  MeshHandle mesh;
  // Each has some of the lines, in their order.
  std::shared_ptr<RowPipeline> rows;
  uint64_t line_count = 0;
  AlgorithmChoice algorithm = kDefaultAlgorithm;
};

// Thread-safe. No call waits for a job. For `on_row` see RowPipeline.
class RowEngine {
 public:
  // REQUIRES: the references outlive the engine, and `scheduler` has no job
  // left when it is destroyed.
  RowEngine(const Limits& limits, Scheduler& scheduler, SoloJobs& jobs,
            std::shared_ptr<ByteBudget> solver_memory, MeshLibrary& meshes,
            SearchEngine& searches, FieldEngine& fields);

  // These start to compute the rows. Errors: as FieldEngine::Compute; of the
  // lines as CountLines, and those of TraceLines come with the rows.
  absl::StatusOr<MatrixCall> ComputeMatrix(MatrixRequest request,
                                           std::function<void()> on_row);
  absl::StatusOr<PairCall> ComputePairs(PairRequest request,
                                        std::function<void()> on_row);
  absl::StatusOr<LineCall> TraceLines(LineRequest request,
                                      std::function<void()> on_row);

  // Traces the paths to the targets of `call` in jobs of their own, as they are
  // taken: the rows hold some paths each, in order of target. The question has
  // been admitted: it takes no other place in the queue, and goes on while the
  // server drains.
  // REQUIRES: the call's extras have paths, and `answer` is its answer, which
  // was not searched for.
  // Errors: UNAVAILABLE after Scheduler::StopAll.
  absl::StatusOr<std::shared_ptr<RowPipeline>> TracePaths(
      const FieldCall& call, const FieldAnswer& answer, TimePoint deadline,
      const Requester& requester, std::function<void()> on_row);

  // Of all questions of pairs.
  PairCounts pair_counts() const { return pair_totals_.counts(); }

 private:
  // The mesh of a question. Errors: NOT_FOUND, INVALID_ARGUMENT.
  absl::StatusOr<MeshHandle> MeshOf(const std::string& digest,
                                    const std::optional<MethodHandle>& method);
  // If columns cost less than rows, and there is memory for the table.
  std::optional<ColumnTable> Transpose(MatrixQuestion& question) const;
  // Sets in the plan what the requester says.
  std::shared_ptr<RowPipeline> MakeRows(const Requester& requester,
                                        RowJobs plan, uint64_t rows,
                                        RowFunction function,
                                        std::function<void()> on_row);

  const Limits& limits_;
  Scheduler& scheduler_;
  SoloJobs& jobs_;
  const std::shared_ptr<ByteBudget> solver_memory_;
  MeshLibrary& meshes_;
  SearchEngine& searches_;
  FieldEngine& fields_;
  PairCounter pair_totals_;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_ROWS_ROW_ENGINE_H_
