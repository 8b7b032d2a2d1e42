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

struct Metadata {
  uint64_t vertices = 0;
  uint64_t faces = 0;
};

std::string Encode(const Mesh& mesh) {
  BinaryWriter writer;
  writer.Put(kSharedMeshRecord);
  writer.Put(uint64_t{mesh.vertex_count()});
  writer.Put(uint64_t{mesh.face_count()});
  return writer.bytes();
}

// Empty if the metadata is another record.
std::optional<Metadata> Decode(std::string_view bytes) {
  return DecodeRecord<Metadata>(bytes, kSharedMeshRecord,
                                [](BinaryReader& reader, Metadata& metadata) {
                                  reader.Get(metadata.vertices);
                                  reader.Get(metadata.faces);
                                });
}

}  // namespace

absl::StatusOr<SiblingMesh> SharedMeshes::Find(const std::string& digest,
                                               size_t first,
                                               Checkpoint& checkpoint) {
  if (first == 0) {
    std::optional<Metadata> found;
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
    if (found) {
      return SiblingMesh{.digest = digest,
                         .vertices = found->vertices,
                         .faces = found->faces,
                         .sibling = 0};
    }
    first = 1;
  }
  if (siblings_ == nullptr) {
    return absl::NotFoundError(absl::StrCat("mesh ", digest, " is not shared"));
  }
  absl::StatusOr<SiblingMesh> mesh =
      siblings_->Find(digest, first - 1, checkpoint);
  if (mesh.ok()) ++mesh->sibling;
  return mesh;
}

absl::StatusOr<TriangleSoup> SharedMeshes::Read(const SiblingMesh& mesh,
                                                Checkpoint& checkpoint) {
  if (mesh.sibling > 0) {
    SiblingMesh of_sibling = mesh;
    --of_sibling.sibling;
    return siblings_->Read(of_sibling, checkpoint);
  }
  absl::StatusOr<TriangleSoup> soup = TriangleSoup();
  absl::Status status =
      tier_.Read(mesh.digest, [&](std::string_view, BlobBody& body) {
        soup = ReadMeshBody(body, mesh.vertices, mesh.faces, checkpoint);
        return soup.status();
      });
  if (status.ok()) return soup;
  // What the checkpoint said ends the wait; anything else is for a sibling.
  if (absl::Status asked = checkpoint.Poll({}); !asked.ok()) return asked;
  return absl::UnavailableError(
      absl::StrCat("mesh ", mesh.digest, " did not come whole from the shared ",
                   "tier: ", status.message()));
}

void SharedMeshes::Spread(const MeshHandle& mesh) {
  const std::string metadata = Encode(*mesh->mesh);
  const uint64_t bytes = MeshBodyBytes(*mesh->mesh);
  if (tier_.Admit(bytes, metadata.size()).ok()) {
    // What cannot be shared is no fault of the upload.
    (void)Guarded("shared a mesh", [&] {
      std::string body;
      body.reserve(bytes);
      (void)WriteMeshBody(*mesh->mesh, [&](std::string_view piece) {
        body += piece;
        return absl::OkStatus();
      });
      return tier_.Put(mesh->digest, metadata,
                       std::array<std::string_view, 1>{body});
    });
  }
  if (siblings_ != nullptr) siblings_->Spread(mesh);
}

}  // namespace geodesic::server
