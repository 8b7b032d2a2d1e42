// Searches that are kept from one question to the next, because making one
// takes time and memory in proportion to the mesh.

#ifndef GEODESIC_SERVER_ENGINE_SEARCHES_SEARCH_POOL_H_
#define GEODESIC_SERVER_ENGINE_SEARCHES_SEARCH_POOL_H_

#include <chrono>
#include <cstddef>
#include <list>
#include <memory>
#include <optional>

#include "geodesic/target_search.h"
#include "server/engine/base/byte_budget.h"
#include "server/engine/base/clock.h"
#include "server/engine/meshes/mesh_store.h"
#include "server/locks/mutex.h"

namespace geodesic::server {

// Thread-safe. A search that is lent is paid for by the job that has it; an
// idle one is charged to the solver memory. An idle search pins no mesh.
class SearchPool : public std::enable_shared_from_this<SearchPool> {
 public:
  // How long an idle search is kept.
  static constexpr std::chrono::seconds kPatience{5};

  // A search for one job, freed with the loan unless it is given back.
  class Loan {
   public:
    Loan(std::shared_ptr<SearchPool> pool, MeshHandle mesh)
        : pool_(std::move(pool)), mesh_(std::move(mesh)) {}
    Loan(Loan&&) = default;
    Loan& operator=(Loan&&) = delete;
    ~Loan();

    TargetSearch& operator*() { return *search_; }
    TargetSearch* operator->() { return &*search_; }

    // Call once, and then do not use it any more. It is kept if there is memory
    // for it. Not after an exception, which may leave the search half changed.
    void GiveBack();

   private:
    friend class SearchPool;

    std::shared_ptr<SearchPool> pool_;  // null: there is no search
    MeshHandle mesh_;
    std::optional<TargetSearch> search_;
  };

  // At most `most` searches are lent and idle together.
  // REQUIRES: `clock` outlives the pool; no more than `most` are lent at once.
  SearchPool(const Clock& clock, std::shared_ptr<ByteBudget> solver_memory,
             size_t most)
      : clock_(clock), memory_(std::move(solver_memory)), most_(most) {}

  // An idle search of the mesh, or a new one. O(mesh) for a new one.
  Loan Lend(const MeshHandle& mesh);

  // Frees the idle searches, because somebody needs the memory.
  void DropIdle();
  // Frees those that were idle for long, or whose mesh is gone.
  void DropOld();

  size_t idle() const;

 private:
  struct Idle {
    std::weak_ptr<const ResidentMesh> mesh;
    TargetSearch search;
    ByteReservation memory;
    TimePoint since;
  };

  const Clock& clock_;
  const std::shared_ptr<ByteBudget> memory_;
  const size_t most_;

  mutable Mutex mutex_;
  std::list<Idle> idle_ ABSL_GUARDED_BY(mutex_);  // longest idle first
  size_t lent_ ABSL_GUARDED_BY(mutex_) = 0;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_SEARCHES_SEARCH_POOL_H_
