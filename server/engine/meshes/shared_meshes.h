// Meshes in the tier that servers share, which is asked before any server is.

#ifndef GEODESIC_SERVER_ENGINE_MESHES_SHARED_MESHES_H_
#define GEODESIC_SERVER_ENGINE_MESHES_SHARED_MESHES_H_

#include <cstddef>
#include <string>

#include "absl/status/statusor.h"
#include "server/engine/meshes/mesh_siblings.h"
#include "server/store/blobs.h"

namespace geodesic::server {

// The tier is number 0, and the siblings follow. Thread-safe.
class SharedMeshes final : public MeshSiblings {
 public:
  // `siblings` may be null. REQUIRES: both outlive the object.
  SharedMeshes(Blobs& tier, MeshSiblings* siblings)
      : tier_(tier), siblings_(siblings) {}

  absl::StatusOr<SiblingMesh> Find(const std::string& digest, size_t first,
                                   Checkpoint& checkpoint) override;
  absl::StatusOr<TriangleSoup> Read(const SiblingMesh& mesh,
                                    Checkpoint& checkpoint) override;
  void Spread(const MeshHandle& mesh) override;

 private:
  Blobs& tier_;
  MeshSiblings* const siblings_;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_MESHES_SHARED_MESHES_H_
