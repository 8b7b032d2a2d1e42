#include "server/engine/meshes/mesh_store.h"

#include <utility>

namespace geodesic::server {
namespace {

uint64_t ChargeOf(const ResidentMesh& mesh) {
  return mesh.mesh->resident_bytes() + sizeof(ResidentMesh) +
         mesh.digest.capacity();
}

}  // namespace

MeshStore::MeshStore(uint64_t capacity)
    : meshes_("mesh store", capacity,
              [this](const std::string& digest) { files_.Remove(digest); }) {}

MeshHandle MeshStore::Find(const std::string& digest) {
  return meshes_.Find(digest);
}

std::optional<std::string> MeshStore::FindFile(const FileKey& file) const {
  return files_.Find(file);
}

absl::StatusOr<ByteReservation> MeshStore::Reserve(uint64_t bytes) {
  return meshes_.Reserve(bytes);
}

MeshStore::Inserted MeshStore::Insert(ResidentMesh mesh, ByteReservation room) {
  room.ShrinkTo(ChargeOf(mesh));
  std::string digest = mesh.digest;
  auto inserted =
      meshes_.Insert(std::move(digest), std::move(mesh), std::move(room));
  return {std::move(inserted.value), inserted.is_new};
}

void MeshStore::AddFile(FileKey file, const std::string& digest) {
  files_.Add(std::move(file), digest);
  // The mesh may have been dropped meanwhile, before there was a file to
  // forget.
  if (meshes_.Find(digest) == nullptr) files_.Remove(digest);
}

bool MeshStore::Erase(const std::string& digest) {
  return meshes_.Erase(digest);
}

std::vector<MeshHandle> MeshStore::List(const std::string& after,
                                        size_t count) const {
  return meshes_.List(after, count);
}

}  // namespace geodesic::server
