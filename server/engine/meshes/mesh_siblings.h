// Other servers, or what they share, that may have a mesh which this one lacks.

#ifndef GEODESIC_SERVER_ENGINE_MESHES_MESH_SIBLINGS_H_
#define GEODESIC_SERVER_ENGINE_MESHES_MESH_SIBLINGS_H_

#include <cstddef>
#include <cstdint>
#include <string>

#include "absl/status/statusor.h"
#include "geodesic/checkpoint.h"
#include "geodesic/triangle_soup.h"
#include "server/engine/meshes/mesh_store.h"

namespace geodesic::server {

// A mesh that a sibling has.
struct SiblingMesh {
  std::string digest;
  uint64_t vertices = 0;
  uint64_t faces = 0;
  size_t sibling = 0;  // which one
};

// Thread-safe. Find and Read wait for the network.
class MeshSiblings {
 public:
  virtual ~MeshSiblings() = default;

  // Asks one sibling after the other, from number `first` on.
  // Errors: NOT_FOUND (none has the mesh), UNAVAILABLE (none is known to have
  // it, and some did not answer), what `checkpoint` says.
  virtual absl::StatusOr<SiblingMesh> Find(const std::string& digest,
                                           size_t first,
                                           Checkpoint& checkpoint) = 0;

  // The arrays of a mesh that was found. Their digest is not checked.
  // Errors: UNAVAILABLE (the sibling is gone, no longer has the mesh, or sent
  // something else), what `checkpoint` says.
  virtual absl::StatusOr<TriangleSoup> Read(const SiblingMesh& mesh,
                                            Checkpoint& checkpoint) = 0;

  // Says that a mesh has come here, so that others get it, soon and if they
  // can. Returns at once.
  virtual void Spread(const MeshHandle& mesh) = 0;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_MESHES_MESH_SIBLINGS_H_
