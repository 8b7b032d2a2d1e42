#include "server/engine/searches/search_engine.h"

#include "geodesic/computation.h"

namespace geodesic::server {
SearchEngine::SearchEngine(const Limits& limits, const SolveOptions& options,
                           const Clock& clock, Scheduler& scheduler,
                           const std::shared_ptr<ByteBudget>& solver_memory,
                           const StartFunction& start, MeshLibrary& meshes)
    : landmarks_(options, clock, scheduler, solver_memory, start, meshes),
      pool_(std::make_shared<SearchPool>(clock, solver_memory,
                                         limits.max_concurrent_jobs)) {
  solver_memory->OnShortage([searches = std::weak_ptr<SearchPool>(pool_)] {
    if (const auto pool = searches.lock()) pool->DropIdle();
  });
}

SearchMeans SearchEngine::MeansFor(const MeshHandle& mesh,
                                   Algorithm algorithm) {
  SearchMeans means;
  // A field makes no use of landmarks.
  if (!TargetSearch::IsDirected(algorithm)) return means;
  means.landmarks = landmarks_.Present(*mesh);
  means.field_in_searches = FieldInSearches(
      means.landmarks == nullptr ? 0 : means.landmarks->count());
  return means;
}

absl::StatusOr<TargetDistances> SearchEngine::Run(const MeshHandle& mesh,
                                                  const ValidQuery& query,
                                                  const SearchMeans& means,
                                                  Checkpoint& checkpoint) {
  SearchPool::Loan search = pool_->Lend(mesh);
  absl::StatusOr<TargetDistances> found =
      search->Run(query, means.landmarks.get(), checkpoint);
  search.GiveBack();
  if (found.ok() && TargetSearch::IsDirected(query->algorithm)) {
    landmarks_.Want(mesh);
  }
  return found;
}

uint64_t SearchEngine::PlannedBytes(const Mesh& mesh, const ValidQuery& query) {
  const uint64_t of_search = TargetSearch::PlannedBytes(mesh);
  if (TargetSearch::IsDirected(query->algorithm)) return of_search;
  // A search that is not directed is computed as a field, beside its arrays.
  return of_search + PlannedSolverBytes(mesh, query);
}

uint64_t BytesOf(std::span<const GeodesicPath> paths) {
  uint64_t bytes = paths.size_bytes();
  for (const GeodesicPath& path : paths) {
    bytes += path.points.capacity() * sizeof(SurfacePoint) +
             path.positions.capacity() * sizeof(Point);
  }
  return bytes;
}

}  // namespace geodesic::server
