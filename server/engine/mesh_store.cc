#include "server/engine/mesh_store.h"

#include <algorithm>
#include <utility>

namespace geodesic::server {
namespace {

// The same mesh in every format, and a few spellings of it.
constexpr size_t kMaxFilesPerMesh = 16;

uint64_t ChargeOf(const ResidentMesh& mesh) {
  return mesh.mesh->resident_bytes() + sizeof(ResidentMesh) +
         mesh.digest.capacity();
}

}  // namespace

MeshStore::MeshStore(uint64_t capacity)
    : meshes_("mesh store", capacity,
              [this](const std::string& digest) { ForgetFiles(digest); }) {}

MeshHandle MeshStore::Find(const std::string& digest) {
  return meshes_.Find(digest);
}

std::optional<std::string> MeshStore::FindFile(const FileKey& file) const {
  std::lock_guard lock(mutex_);
  const auto it = digest_of_file_.find(file);
  if (it == digest_of_file_.end()) return std::nullopt;
  return it->second;
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
  {
    std::lock_guard lock(mutex_);
    if (!digest_of_file_.emplace(file, digest).second) return;
    std::deque<FileKey>& files = files_of_digest_[digest];
    files.push_back(std::move(file));
    if (files.size() > kMaxFilesPerMesh) {
      digest_of_file_.erase(files.front());
      files.pop_front();
    }
  }
  // The mesh may have been dropped meanwhile, before there was a file to
  // forget.
  if (meshes_.Find(digest) == nullptr) ForgetFiles(digest);
}

bool MeshStore::Erase(const std::string& digest) {
  return meshes_.Erase(digest);
}

std::vector<MeshHandle> MeshStore::List(const std::string& after,
                                        size_t count) const {
  return meshes_.List(after, count);
}

void MeshStore::ForgetFiles(const std::string& digest) {
  std::lock_guard lock(mutex_);
  const auto it = files_of_digest_.find(digest);
  if (it == files_of_digest_.end()) return;
  for (const FileKey& file : it->second) digest_of_file_.erase(file);
  files_of_digest_.erase(it);
}

}  // namespace geodesic::server
