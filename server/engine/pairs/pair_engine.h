// Distances of pairs of points.

#ifndef GEODESIC_SERVER_ENGINE_PAIRS_PAIR_ENGINE_H_
#define GEODESIC_SERVER_ENGINE_PAIRS_PAIR_ENGINE_H_

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "geodesic/rows/pairs.h"
#include "geodesic_types/algorithms.h"
#include "server/engine/base/clock.h"
#include "server/engine/base/limits.h"
#include "server/engine/fields/field_engine.h"
#include "server/engine/jobs/row_pipeline.h"
#include "server/engine/jobs/scheduler.h"
#include "server/engine/jobs/solo_job.h"
#include "server/engine/meshes/mesh_library.h"
#include "server/engine/meshes/method_store.h"
#include "server/engine/pairs/pair_work.h"
#include "server/engine/searches/search_engine.h"

namespace geodesic::server {

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

// Thread-safe. No call waits for a job.
class PairEngine {
 public:
  // REQUIRES: the references outlive the engine, and `scheduler` has no job
  // left when it is destroyed.
  PairEngine(const Limits& limits, Scheduler& scheduler, SoloJobs& jobs,
             MeshLibrary& meshes, SearchEngine& searches, FieldEngine& fields);

  // Starts to compute the distances of all pairs; see RowPipeline for `on_row`.
  // Errors: as FieldEngine::Compute.
  absl::StatusOr<PairCall> Compute(PairRequest request,
                                   std::function<void()> on_row);

  PairCounts counts() const { return totals_.counts(); }

 private:
  const Limits& limits_;
  Scheduler& scheduler_;
  SoloJobs& jobs_;
  MeshLibrary& meshes_;
  SearchEngine& searches_;
  FieldEngine& fields_;
  PairCounter totals_;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_PAIRS_PAIR_ENGINE_H_
