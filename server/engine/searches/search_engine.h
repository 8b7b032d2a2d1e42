// Searches directed at targets, and what is kept for them: landmarks of meshes
// and the memory of searches.

#ifndef GEODESIC_SERVER_ENGINE_SEARCHES_SEARCH_ENGINE_H_
#define GEODESIC_SERVER_ENGINE_SEARCHES_SEARCH_ENGINE_H_

#include <cstdint>
#include <functional>
#include <memory>
#include <utility>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/checkpoint.h"
#include "geodesic/computation.h"
#include "geodesic/rows/rows.h"
#include "geodesic/solve_options.h"
#include "geodesic/target_search.h"
#include "geodesic/valid_query.h"
#include "geodesic_types/algorithms.h"
#include "server/engine/base/byte_budget.h"
#include "server/engine/base/clock.h"
#include "server/engine/base/limits.h"
#include "server/engine/jobs/scheduler.h"
#include "server/engine/jobs/start_function.h"
#include "server/engine/meshes/landmark_store.h"
#include "server/engine/meshes/mesh_library.h"
#include "server/engine/meshes/mesh_store.h"
#include "server/engine/searches/landmark_maker.h"
#include "server/engine/searches/search_pool.h"

namespace geodesic::server {

// Thread-safe. No call waits for anything.
class SearchEngine {
 public:
  // REQUIRES: the references outlive the engine, and `scheduler` has no job
  // left when it is destroyed.
  SearchEngine(const Limits& limits, const SolveOptions& options,
               const Clock& clock, Scheduler& scheduler,
               const std::shared_ptr<ByteBudget>& solver_memory,
               const StartFunction& start, MeshLibrary& meshes);

  LandmarkMaker& landmarks() { return landmarks_; }
  const LandmarkMaker& landmarks() const { return landmarks_; }
  SearchPool& pool() { return *pool_; }
  const SearchPool& pool() const { return *pool_; }

  // A computation on one thread. Errors: as StartComputation.
  absl::StatusOr<std::unique_ptr<Computation>> Start(
      const Mesh& mesh, const ValidQuery& query) const {
    return start_(mesh, query, options_);
  }

 private:
  const SolveOptions options_;
  const StartFunction start_;
  LandmarkMaker landmarks_;
  const std::shared_ptr<SearchPool> pool_;
};

// What the rows about a mesh are answered with. Thread-safe. Pins the mesh.
class SearchMeans : public RowMeans {
 public:
  // REQUIRES: `searches` outlives it.
  SearchMeans(SearchEngine& searches, MeshHandle mesh)
      : searches_(searches), mesh_(std::move(mesh)) {}

  const MeshHandle& mesh() const { return mesh_; }

  LandmarksHandle landmarks() override {
    return searches_.landmarks().Present(*mesh_);
  }
  absl::StatusOr<bool> MakeLandmarks(uint32_t count,
                                     Checkpoint& checkpoint) override {
    return searches_.landmarks().MakeNow(mesh_, count, checkpoint);
  }
  void WantLandmarks() override { searches_.landmarks().Want(mesh_); }
  absl::Status WithSearch(
      const std::function<absl::Status(TargetSearch&)>& work) override;
  absl::StatusOr<std::unique_ptr<Computation>> Start(
      const ValidQuery& query) override {
    return searches_.Start(*mesh_->mesh, query);
  }

 private:
  SearchEngine& searches_;
  const MeshHandle mesh_;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_SEARCHES_SEARCH_ENGINE_H_
