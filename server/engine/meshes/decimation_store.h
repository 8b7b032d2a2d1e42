// Decimated meshes: shorter lists of triangles over the vertices of meshes in
// memory. Whatever is dropped here can be made again.

#ifndef GEODESIC_SERVER_ENGINE_MESHES_DECIMATION_STORE_H_
#define GEODESIC_SERVER_ENGINE_MESHES_DECIMATION_STORE_H_

#include <compare>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/triangle_soup.h"
#include "server/engine/base/lru_store.h"

namespace geodesic::server {

// Which mesh, and how many faces it is to have at most.
struct DecimationKey {
  std::string mesh_digest;
  uint64_t max_faces = 0;

  friend auto operator<=>(const DecimationKey&, const DecimationKey&) = default;
};

// Pins the triangles while it is held.
using DecimationHandle = std::shared_ptr<const std::vector<Triangle>>;

// Thread-safe. See LruStore for what is kept and what is evicted.
class DecimationStore {
 public:
  explicit DecimationStore(uint64_t capacity)
      : decimations_("decimated memory", capacity) {}

  // Null if there is none; marks it as used.
  DecimationHandle Find(const DecimationKey& key) {
    return decimations_.Find(key);
  }

  // Whether room for so many faces can ever be made. Errors: as Insert.
  absl::Status CheckCapacity(uint64_t faces) const {
    return decimations_.CheckCapacity(BytesOf(faces));
  }

  // Makes room, if it can ever be had, and keeps the triangles, or those that
  // are there already. Returns a handle to them.
  // Errors: RESOURCE_EXHAUSTED naming the budget and the need.
  absl::StatusOr<DecimationHandle> Insert(DecimationKey key,
                                          std::vector<Triangle> triangles);

  void EraseMesh(const std::string& digest);

  size_t size() const { return decimations_.size(); }
  uint64_t used_bytes() const { return decimations_.used_bytes(); }
  uint64_t evictions() const { return decimations_.evictions(); }

 private:
  static uint64_t BytesOf(uint64_t faces);

  LruStore<DecimationKey, std::vector<Triangle>> decimations_;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_MESHES_DECIMATION_STORE_H_
