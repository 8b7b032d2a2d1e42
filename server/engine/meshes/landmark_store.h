// Landmarks of meshes in memory, which make searches for a few targets faster.
// Whatever is dropped here can be made again, or done without.

#ifndef GEODESIC_SERVER_ENGINE_MESHES_LANDMARK_STORE_H_
#define GEODESIC_SERVER_ENGINE_MESHES_LANDMARK_STORE_H_

#include <cstdint>
#include <memory>
#include <string>

#include "absl/status/statusor.h"
#include "geodesic/landmarks.h"
#include "geodesic/mesh.h"
#include "server/engine/base/lru_store.h"

namespace geodesic::server {

// Pins the landmarks while it is held.
using LandmarksHandle = std::shared_ptr<const Landmarks>;

// Thread-safe. See LruStore for what is kept and what is evicted.
class LandmarkStore {
 public:
  explicit LandmarkStore(uint64_t capacity)
      : landmarks_("landmark memory", capacity) {}

  // Null if the mesh has none; marks them as used.
  LandmarksHandle Find(const std::string& digest) {
    return landmarks_.Find(digest);
  }
  // How many there are; marks nothing as used.
  uint32_t CountOf(const std::string& digest) const;

  // Whether a mesh's landmarks can ever be kept.
  bool CanHold(const Mesh& mesh) const;

  // Makes room for a mesh's landmarks before they are made.
  // Errors: RESOURCE_EXHAUSTED naming the budget and the need.
  absl::StatusOr<ByteReservation> Reserve(const Mesh& mesh);

  // Keeps the landmarks, unless there are as many already.
  void Insert(const std::string& digest, Landmarks landmarks,
              ByteReservation room);

  void Erase(const std::string& digest) { (void)landmarks_.Erase(digest); }

  uint64_t used_bytes() const { return landmarks_.used_bytes(); }
  uint64_t evictions() const { return landmarks_.evictions(); }

 private:
  LruStore<std::string, Landmarks> landmarks_;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_MESHES_LANDMARK_STORE_H_
