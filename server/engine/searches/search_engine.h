// Searches directed at targets, and what is kept for them: landmarks of meshes
// and the memory of searches.

#ifndef GEODESIC_SERVER_ENGINE_SEARCHES_SEARCH_ENGINE_H_
#define GEODESIC_SERVER_ENGINE_SEARCHES_SEARCH_ENGINE_H_

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "absl/status/statusor.h"
#include "geodesic/checkpoint.h"
#include "geodesic/path.h"
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

// A search that is not directed (see TargetSearch) is a field itself.
inline constexpr size_t kFieldInUndirectedSearches = 2;

// What helps the searches of a question.
struct SearchMeans {
  LandmarksHandle landmarks;  // may be null
  // From so many searches on, a field costs less.
  size_t field_in_searches = kFieldInUndirectedSearches;
};

// Thread-safe. No call but Run waits for anything.
class SearchEngine {
 public:
  // REQUIRES: the references outlive the engine, and `scheduler` has no job
  // left when it is destroyed.
  SearchEngine(const Limits& limits, const SolveOptions& options,
               const Clock& clock, Scheduler& scheduler,
               const std::shared_ptr<ByteBudget>& solver_memory,
               const StartFunction& start, MeshLibrary& meshes);

  // For searches with the algorithm that runs. Says that landmarks of the mesh
  // are wanted, if they are of use.
  SearchMeans MeansFor(const MeshHandle& mesh, Algorithm algorithm);

  // Runs one search, with a memory from the pool. Errors: as TargetSearch::Run.
  absl::StatusOr<TargetDistances> Run(const MeshHandle& mesh,
                                      const ValidQuery& query,
                                      const SearchMeans& means,
                                      Checkpoint& checkpoint);

  // Bytes to reserve before a search starts.
  static uint64_t PlannedBytes(const Mesh& mesh, const ValidQuery& query);

  LandmarkMaker& landmarks() { return landmarks_; }
  const LandmarkMaker& landmarks() const { return landmarks_; }
  SearchPool& pool() { return *pool_; }
  const SearchPool& pool() const { return *pool_; }

 private:
  LandmarkMaker landmarks_;
  const std::shared_ptr<SearchPool> pool_;
};

// What paths take in memory. O(paths).
uint64_t BytesOf(std::span<const GeodesicPath> paths);

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_SEARCHES_SEARCH_ENGINE_H_
