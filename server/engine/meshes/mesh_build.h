// An upload on its way to become a mesh.

#ifndef GEODESIC_SERVER_ENGINE_MESHES_MESH_BUILD_H_
#define GEODESIC_SERVER_ENGINE_MESHES_MESH_BUILD_H_

#include <memory>
#include <optional>
#include <string>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/triangle_soup.h"
#include "server/engine/base/byte_budget.h"
#include "server/engine/meshes/mesh_library.h"
#include "server/engine/meshes/mesh_upload.h"

namespace geodesic::server {

// The work of a job that goes on: the bytes are parsed, then the mesh is built,
// and each begins when its memory is there. How much a build needs is known
// once the file is parsed.
//
// Not thread-safe.
class MeshBuild {
 public:
  // REQUIRES: upload->Finish() succeeded; `library` outlives the object.
  MeshBuild(MeshLibrary& library, std::unique_ptr<MeshUpload> upload);

  // Takes the memory for what comes next. See Job::reserve.
  // Errors: RESOURCE_EXHAUSTED, without a retry hint if it can never be had.
  absl::Status Reserve();

  // Goes on as far as memory is there. Nothing: Reserve, and run it again. Not
  // for a thread that must not wait. REQUIRES: Reserve succeeded.
  // Errors: INVALID_ARGUMENT, RESOURCE_EXHAUSTED, UNAVAILABLE; what
  // `checkpoint` says, and then no mesh is kept.
  absl::StatusOr<std::optional<UploadResult>> Run(Checkpoint& checkpoint);

 private:
  absl::Status ReserveForMesh();
  // Errors: INVALID_ARGUMENT when the upload expects another.
  absl::Status TakeDigest();

  MeshLibrary& library_;
  const std::unique_ptr<MeshUpload> upload_;
  // Once parsed:
  std::optional<TriangleSoup> soup_;
  std::string digest_;
  ByteReservation room_;  // of the mesh store
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_MESHES_MESH_BUILD_H_
