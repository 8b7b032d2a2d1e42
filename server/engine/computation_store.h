// Computations that stopped early and may be asked to go on.

#ifndef GEODESIC_SERVER_ENGINE_COMPUTATION_STORE_H_
#define GEODESIC_SERVER_ENGINE_COMPUTATION_STORE_H_

#include <cstddef>
#include <cstdint>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "geodesic/computation.h"
#include "server/engine/byte_budget.h"
#include "server/engine/field_key.h"
#include "server/engine/mesh_store.h"

namespace geodesic::server {

// A computation and the mesh it works on, which it pins.
struct PausedComputation {
  MeshHandle mesh;
  std::unique_ptr<Computation> computation;  // null: there is none
};

// Bounded in bytes; what was left alone longest goes first. A computation
// belongs to whoever took it out until it is put back. Thread-safe.
class ComputationStore {
 public:
  explicit ComputationStore(uint64_t capacity);

  // Takes the computation out, if there is one.
  PausedComputation Take(const FieldKey& key);

  bool Contains(const FieldKey& key) const;

  // Puts it in, if need be in place of others; drops it when it is larger than
  // the store or when one with its key is there.
  void Put(const FieldKey& key, PausedComputation paused);

  void EraseMesh(const std::string& digest);
  void Clear();

  size_t size() const;
  uint64_t used_bytes() const { return budget_->used(); }

 private:
  struct Entry {
    // Held so that an entry's memory is gone before its charge is.
    ByteReservation charge;
    PausedComputation paused;
    std::list<FieldKey>::iterator position;
  };
  using Entries = std::map<FieldKey, Entry>;

  const std::shared_ptr<ByteBudget> budget_;

  mutable std::mutex mutex_;
  // Guarded by mutex_:
  Entries entries_;
  std::list<FieldKey> recency_;  // keys of entries_, oldest first
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_COMPUTATION_STORE_H_
