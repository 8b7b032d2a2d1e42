#include "server/engine/searches/search_pool.h"

#include <utility>

namespace geodesic::server {

SearchPool::Loan::~Loan() {
  if (pool_ == nullptr) return;
  search_.reset();
  MutexLock lock(pool_->mutex_);
  --pool_->lent_;
}

void SearchPool::Loan::GiveBack() {
  // Without the pool's lock, because the budget may ask for idle searches.
  absl::StatusOr<ByteReservation> memory =
      ByteReservation::Make(pool_->memory_, search_->bytes());
  if (!memory.ok()) return;
  std::list<Idle> node;
  node.push_back({.mesh = mesh_,
                  .search = *std::move(search_),
                  .memory = *std::move(memory),
                  .since = pool_->clock_.Now()});
  const std::shared_ptr<SearchPool> pool = std::move(pool_);
  MutexLock lock(pool->mutex_);
  pool->idle_.splice(pool->idle_.end(), node);
  --pool->lent_;
}

SearchPool::Loan SearchPool::Lend(const MeshHandle& mesh) {
  Loan loan(shared_from_this(), mesh);
  std::list<Idle> found;    // one or none
  std::list<Idle> dropped;  // freed after the lock is released
  {
    MutexLock lock(mutex_);
    ++lent_;
    for (auto it = idle_.begin(); it != idle_.end(); ++it) {
      if (it->mesh.lock() != mesh) continue;
      found.splice(found.end(), idle_, it);
      break;
    }
    if (idle_.size() + lent_ > most_ && !idle_.empty()) {
      dropped.splice(dropped.end(), idle_, idle_.begin());
    }
  }
  if (found.empty()) {
    loan.search_.emplace(*mesh->mesh);
  } else {
    loan.search_.emplace(std::move(found.front().search));
  }
  return loan;
}

void SearchPool::DropIdle() {
  std::list<Idle> dropped;
  MutexLock lock(mutex_);
  dropped.swap(idle_);
}

void SearchPool::DropOld() {
  const TimePoint oldest = clock_.Now() - kPatience;
  std::list<Idle> dropped;
  MutexLock lock(mutex_);
  for (auto it = idle_.begin(); it != idle_.end();) {
    const auto idle = it++;
    if (idle->since > oldest && !idle->mesh.expired()) continue;
    dropped.splice(dropped.end(), idle_, idle);
  }
}

size_t SearchPool::idle() const {
  MutexLock lock(mutex_);
  return idle_.size();
}

}  // namespace geodesic::server
