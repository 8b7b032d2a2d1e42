// Puts a mesh together from what the server sends in pieces.

#ifndef GEODESIC_CLIENT_MESH_ASSEMBLER_H_
#define GEODESIC_CLIENT_MESH_ASSEMBLER_H_

#include <cstdint>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/v1/mesh_service.pb.h"
#include "geodesic_client/mesh.h"

namespace geodesic::client {

// Takes the messages of a ReadMesh stream. Memory grows with the bytes that
// have arrived, not with the announced counts. Not thread-safe.
class MeshAssembler {
 public:
  // Takes the next message of the stream.
  // Errors: DATA_LOSS if it breaks the stream's protocol.
  absl::Status Consume(const v1::ReadMeshResponse& message);

  // The mesh, once the stream has ended without error. Every index is checked.
  // Errors: DATA_LOSS if anything is missing.
  absl::StatusOr<MeshArrays> Finish() &&;

 private:
  MeshArrays mesh_;
  uint64_t vertex_count_ = 0;
  uint64_t face_count_ = 0;
  bool has_header_ = false;
};

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_MESH_ASSEMBLER_H_
