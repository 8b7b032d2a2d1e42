// The meshes in memory. With a data folder they are a cache of the disk,
// otherwise all meshes that the server has.

#ifndef GEODESIC_SERVER_ENGINE_MESHES_MESH_STORE_H_
#define GEODESIC_SERVER_ENGINE_MESHES_MESH_STORE_H_

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "server/engine/base/lru_store.h"
#include "server/engine/meshes/mesh_catalogue.h"

namespace geodesic::server {

// Pins the mesh while it is held.
using MeshHandle = std::shared_ptr<const ResidentMesh>;

// Thread-safe. See LruStore for what is kept and what is evicted.
class MeshStore final : public MeshCatalogue {
 public:
  // `dropped` is called for each mesh that leaves memory, as LruStore says.
  explicit MeshStore(uint64_t capacity,
                     std::function<void(const std::string&)> dropped = nullptr);

  // Null when not resident; marks the mesh as used.
  MeshHandle Find(const std::string& digest) { return meshes_.Find(digest); }

  // Whether it is resident; marks nothing as used.
  bool Holds(const std::string& digest) const {
    return meshes_.Peek(digest) != nullptr;
  }

  std::optional<MeshDescription> Describe(const std::string& digest) override;
  std::vector<MeshDescription> List(const std::string& after,
                                    size_t count) const override;
  absl::Status Erase(const std::string& digest) override;

  // Whether room for such a mesh can ever be made. Errors: as Reserve.
  absl::Status CheckCapacity(uint64_t vertices, uint64_t faces) const;

  // Makes room for a mesh before it is built.
  // Errors: RESOURCE_EXHAUSTED naming the budget and the need, without a retry
  // hint if there never will be room.
  absl::StatusOr<ByteReservation> Reserve(uint64_t vertices, uint64_t faces);

  using Inserted = LruStore<std::string, ResidentMesh>::Inserted;

  // Keeps `mesh`, charged with the part of `room` that it really takes.
  Inserted Insert(ResidentMesh mesh, ByteReservation room);

  uint64_t used_bytes() const { return meshes_.used_bytes(); }
  uint64_t evictions() const { return meshes_.evictions(); }

 private:
  // Its lock is taken before files_mutex_, never after.
  LruStore<std::string, ResidentMesh> meshes_;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_MESHES_MESH_STORE_H_
