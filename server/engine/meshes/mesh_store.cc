#include "server/engine/meshes/mesh_store.h"

#include <utility>

#include "server/engine/base/argument_checks.h"

namespace geodesic::server {
namespace {

constexpr uint64_t kDigestBytes = 64;

// The bytes charged for a mesh whose own memory is `mesh_bytes`.
uint64_t ChargeOf(uint64_t mesh_bytes) {
  return mesh_bytes + sizeof(ResidentMesh) + kDigestBytes;
}

}  // namespace

MeshStore::MeshStore(uint64_t capacity,
                     std::function<void(const std::string&)> dropped)
    : meshes_("mesh store", capacity,
              [this, dropped = std::move(dropped)](const std::string& digest) {
                ForgetFiles(digest);
                if (dropped) dropped(digest);
              }) {}

std::optional<MeshDescription> MeshStore::Describe(const std::string& digest) {
  const MeshHandle mesh = Find(digest);
  return mesh == nullptr ? std::nullopt : std::optional(mesh->Describe());
}

std::vector<MeshDescription> MeshStore::List(const std::string& after,
                                             size_t count) const {
  std::vector<MeshDescription> page;
  for (const MeshHandle& mesh : meshes_.List(after, count)) {
    page.push_back(mesh->Describe());
  }
  return page;
}

absl::Status MeshStore::Erase(const std::string& digest) {
  return meshes_.Erase(digest) ? absl::OkStatus() : NotResident(digest);
}

absl::Status MeshStore::CheckCapacity(uint64_t vertices, uint64_t faces) const {
  return meshes_.CheckCapacity(
      ChargeOf(Mesh::EstimateResidentBytes(vertices, faces)));
}

absl::StatusOr<ByteReservation> MeshStore::Reserve(uint64_t vertices,
                                                   uint64_t faces) {
  return meshes_.Reserve(
      ChargeOf(Mesh::EstimateResidentBytes(vertices, faces)));
}

MeshStore::Inserted MeshStore::Insert(ResidentMesh mesh, ByteReservation room) {
  room.ShrinkTo(ChargeOf(mesh.mesh->resident_bytes()));
  std::string digest = mesh.digest;
  return meshes_.Insert(std::move(digest), std::move(mesh), std::move(room));
}

}  // namespace geodesic::server
