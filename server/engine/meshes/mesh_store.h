// The resident meshes, by digest and by the files they were uploaded as.

#ifndef GEODESIC_SERVER_ENGINE_MESHES_MESH_STORE_H_
#define GEODESIC_SERVER_ENGINE_MESHES_MESH_STORE_H_

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/mesh.h"
#include "geodesic/mesh_summary.h"
#include "server/engine/base/lru_store.h"
#include "server/engine/meshes/known_files.h"
#include "server/engine/meshes/mesh_description.h"
#include "server/engine/meshes/upload_header.h"

namespace geodesic::server {

struct ResidentMesh {
  std::string digest;
  std::shared_ptr<const Mesh> mesh;
  MeshSummary summary;

  MeshDescription Describe() const {
    return {.digest = digest,
            .summary = summary,
            .resident_bytes = mesh->resident_bytes()};
  }
};

// Pins the mesh while it is held.
using MeshHandle = std::shared_ptr<const ResidentMesh>;

// Thread-safe. See LruStore for what is kept and what is evicted.
class MeshStore {
 public:
  explicit MeshStore(uint64_t capacity);

  // Null when not resident.
  MeshHandle Find(const std::string& digest);

  // The digest of the resident mesh that was uploaded as this file.
  std::optional<std::string> FindFile(const FileKey& file) const;

  // Whether so many bytes can ever be reserved. Errors: as Reserve.
  absl::Status CheckCapacity(uint64_t bytes) const {
    return meshes_.CheckCapacity(bytes);
  }

  // Makes room for a mesh before it is built.
  // Errors: RESOURCE_EXHAUSTED naming the budget and the need.
  absl::StatusOr<ByteReservation> Reserve(uint64_t bytes);

  struct Inserted {
    MeshHandle mesh;
    bool is_new = false;
  };

  // Keeps `mesh`, charged with what of `room` it really takes.
  Inserted Insert(ResidentMesh mesh, ByteReservation room);

  // Remembers that `file` holds the mesh `digest`, for as long as the mesh is
  // resident. A mesh remembers its latest few files.
  void AddFile(FileKey file, const std::string& digest);

  // Whether the mesh was resident. Those who hold it keep it.
  bool Erase(const std::string& digest);

  // Up to `count` meshes in order of digest, from the first above `after`.
  std::vector<MeshHandle> List(const std::string& after, size_t count) const;

  uint64_t used_bytes() const { return meshes_.used_bytes(); }
  uint64_t evictions() const { return meshes_.evictions(); }

 private:
  // Its own lock is taken after the store's, never before.
  KnownFiles files_;
  LruStore<std::string, ResidentMesh> meshes_;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_MESHES_MESH_STORE_H_
