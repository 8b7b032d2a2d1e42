// A mesh as the body of a blob: what its digest is of.

#ifndef GEODESIC_SERVER_ENGINE_MESHES_MESH_BODY_H_
#define GEODESIC_SERVER_ENGINE_MESHES_MESH_BODY_H_

#include <cstdint>
#include <string_view>

#include "absl/functional/function_ref.h"
#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/checkpoint.h"
#include "geodesic/mesh.h"
#include "geodesic/triangle_soup.h"
#include "server/store/blobs.h"

namespace geodesic::server {

// How many bytes that of a plain mesh has, and how many that of `mesh` has:
// more where vertices were joined.
uint64_t MeshBodyBytes(uint64_t vertices, uint64_t faces);
uint64_t MeshBodyBytes(const Mesh& mesh);
// Whether a mesh of these counts can have a body of that size.
bool IsMeshBodySize(uint64_t bytes, uint64_t vertices, uint64_t faces);

// Gives `append` the bytes in pieces. Errors: those of `append`.
absl::Status WriteMeshBody(
    const Mesh& mesh,
    absl::FunctionRef<absl::Status(std::string_view bytes)> append);

// Reads a mesh of these counts. Polls the checkpoint about every 10 ms.
// Errors: DATA_LOSS if the body is of another mesh; those of `body` and of
// `checkpoint`.
absl::StatusOr<TriangleSoup> ReadMeshBody(BlobBody& body, uint64_t vertices,
                                          uint64_t faces,
                                          Checkpoint& checkpoint);

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_MESHES_MESH_BODY_H_
