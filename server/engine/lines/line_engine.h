// Straight lines from places in directions.

#ifndef GEODESIC_SERVER_ENGINE_LINES_LINE_ENGINE_H_
#define GEODESIC_SERVER_ENGINE_LINES_LINE_ENGINE_H_

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "absl/status/statusor.h"
#include "geodesic/trace.h"
#include "geodesic_types/algorithms.h"
#include "server/engine/base/clock.h"
#include "server/engine/jobs/row_pipeline.h"
#include "server/engine/jobs/scheduler.h"
#include "server/engine/jobs/solo_job.h"
#include "server/engine/meshes/mesh_library.h"
#include "server/engine/meshes/mesh_store.h"

namespace geodesic::server {

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

// Thread-safe. No call waits for a job.
class LineEngine {
 public:
  // REQUIRES: the references outlive the engine, and `scheduler` has no job
  // left when it is destroyed.
  LineEngine(Scheduler& scheduler, SoloJobs& jobs, MeshLibrary& meshes)
      : scheduler_(scheduler), jobs_(jobs), meshes_(meshes) {}

  // Starts to follow the lines; see RowPipeline for `on_row`.
  // Errors: INVALID_ARGUMENT: as CountLines; NOT_FOUND; as RowPipeline::Start.
  // Those of TraceLines come with the rows.
  absl::StatusOr<LineCall> Trace(LineRequest request,
                                 std::function<void()> on_row);

 private:
  Scheduler& scheduler_;
  SoloJobs& jobs_;
  MeshLibrary& meshes_;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_LINES_LINE_ENGINE_H_
