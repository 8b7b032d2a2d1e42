#include "server/engine/meshes/shared_meshes.h"

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>

#include "absl/strings/str_cat.h"
#include "server/engine/base/binary_codec.h"
#include "server/engine/base/status_details.h"
#include "server/engine/meshes/mesh_body.h"

namespace geodesic::server {
namespace {

// Beyond this there is no mesh, and sizes would not be numbers.
constexpr uint64_t kMostCount = std::numeric_limits<uint32_t>::max();

std::string Encode(const Mesh& mesh) {
  BinaryWriter writer;
  writer.Put(kSharedMeshRecord);
  writer.Put(uint64_t{mesh.vertex_count()});
  writer.Put(uint64_t{mesh.face_count()});
  return writer.bytes();
}

// Without the digest; empty if the metadata is another record.
std::optional<SharedMesh> Decode(std::string_view bytes) {
  return DecodeRecord<SharedMesh>(bytes, kSharedMeshRecord,
                                  [](BinaryReader& reader, SharedMesh& mesh) {
                                    reader.Get(mesh.vertices);
                                    reader.Get(mesh.faces);
                                  });
}

}  // namespace

std::optional<SharedMesh> SharedMeshes::Find(const std::string& digest) {
  std::optional<SharedMesh> found;
  const auto look = [&](std::string_view metadata, BlobBody& body) {
    found = Decode(metadata);
    if (!found || found->vertices > kMostCount || found->faces > kMostCount ||
        !IsMeshBodySize(body.bytes_left(), found->vertices, found->faces)) {
      found.reset();
      return absl::NotFoundError("the mesh that is kept is of no use here");
    }
    return absl::CancelledError("memory for the body is taken first");
  };
  (void)tier_.Read(digest, look);
  if (found) found->digest = digest;
  return found;
}

absl::StatusOr<TriangleSoup> SharedMeshes::Read(const SharedMesh& mesh,
                                                Checkpoint& checkpoint) {
  absl::StatusOr<TriangleSoup> soup = TriangleSoup();
  absl::Status status =
      tier_.Read(mesh.digest, [&](std::string_view, BlobBody& body) {
        soup = ReadMeshBody(body, mesh.vertices, mesh.faces, checkpoint);
        return soup.status();
      });
  if (status.ok()) return soup;
  if (absl::Status asked = checkpoint.Poll({}); !asked.ok()) return asked;
  return absl::NotFoundError(
      absl::StrCat("mesh ", mesh.digest, " did not come whole from the shared ",
                   "tier: ", status.message()));
}

void SharedMeshes::Put(const ResidentMesh& mesh) {
  const std::string metadata = Encode(*mesh.mesh);
  const uint64_t bytes = MeshBodyBytes(*mesh.mesh);
  if (!tier_.Admit(bytes, metadata.size()).ok()) return;
  // What cannot be shared is no fault of the upload.
  (void)Guarded("shared a mesh", [&] {
    std::string body;
    body.reserve(bytes);
    (void)WriteMeshBody(*mesh.mesh, [&](std::string_view piece) {
      body += piece;
      return absl::OkStatus();
    });
    return tier_.Put(mesh.digest, metadata,
                     std::array<std::string_view, 1>{body});
  });
}

}  // namespace geodesic::server
