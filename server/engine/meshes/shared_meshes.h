// Meshes in the tier that servers share.

#ifndef GEODESIC_SERVER_ENGINE_MESHES_SHARED_MESHES_H_
#define GEODESIC_SERVER_ENGINE_MESHES_SHARED_MESHES_H_

#include <cstdint>
#include <optional>
#include <string>

#include "absl/status/statusor.h"
#include "geodesic/checkpoint.h"
#include "geodesic/triangle_soup.h"
#include "server/engine/meshes/mesh_store.h"
#include "server/store/blobs.h"

namespace geodesic::server {

// A mesh that the tier has.
struct SharedMesh {
  std::string digest;
  uint64_t vertices = 0;
  uint64_t faces = 0;
};

// Thread-safe. Every method waits for the network.
class SharedMeshes {
 public:
  // REQUIRES: `tier` outlives the object.
  explicit SharedMeshes(Blobs& tier) : tier_(tier) {}

  // Empty if the tier does not have the mesh, or does not answer.
  std::optional<SharedMesh> Find(const std::string& digest);

  // The arrays of a mesh that was found. Their digest is not checked.
  // Errors: NOT_FOUND (it did not come whole), what `checkpoint` says.
  absl::StatusOr<TriangleSoup> Read(const SharedMesh& mesh,
                                    Checkpoint& checkpoint);

  // Has the tier keep the mesh if it can.
  void Put(const ResidentMesh& mesh);

 private:
  Blobs& tier_;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_MESHES_SHARED_MESHES_H_
