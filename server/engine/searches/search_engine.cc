#include "server/engine/searches/search_engine.h"

namespace geodesic::server {

SearchEngine::SearchEngine(const Limits& limits, const SolveOptions& options,
                           const Clock& clock, Scheduler& scheduler,
                           const std::shared_ptr<ByteBudget>& solver_memory,
                           const StartFunction& start, MeshLibrary& meshes)
    : options_(options),
      start_(start),
      landmarks_(options, clock, scheduler, solver_memory, start, meshes),
      pool_(std::make_shared<SearchPool>(clock, solver_memory,
                                         limits.max_concurrent_jobs)) {
  solver_memory->OnShortage([searches = std::weak_ptr<SearchPool>(pool_)] {
    if (const auto pool = searches.lock()) pool->DropIdle();
  });
}

absl::Status SearchMeans::WithSearch(
    const std::function<absl::Status(TargetSearch&)>& work) {
  SearchPool::Loan search = searches_.pool().Lend(mesh_);
  absl::Status status = work(*search);
  search.GiveBack();
  return status;
}

}  // namespace geodesic::server
