#include "server/engine/meshes/mesh_catalogue.h"

#include "server/engine/base/argument_checks.h"

namespace geodesic::server {
namespace {

// Enough for a mesh in every format, and a few variants of each.
constexpr size_t kMaxFilesPerMesh = 16;

}  // namespace

std::optional<std::string> MeshCatalogue::FindFile(const FileKey& file) const {
  MutexLock lock(files_mutex_);
  const auto it = digest_of_file_.find(file);
  if (it == digest_of_file_.end()) return std::nullopt;
  return it->second;
}

void MeshCatalogue::AddFile(const FileKey& file, const std::string& digest) {
  RememberFile(file, digest);
  // The mesh may have been dropped just before its file was remembered.
  if (!Contains(digest)) ForgetFiles(digest);
}

absl::StatusOr<TriangleSoup> MeshCatalogue::Load(const MeshDescription& mesh,
                                                 Checkpoint&) {
  return NotResident(mesh.digest);
}

void MeshCatalogue::RememberFile(const FileKey& file,
                                 const std::string& digest) {
  MutexLock lock(files_mutex_);
  if (!digest_of_file_.emplace(file, digest).second) return;
  std::deque<FileKey>& files = files_of_digest_[digest];
  files.push_back(file);
  if (files.size() > kMaxFilesPerMesh) {
    digest_of_file_.erase(files.front());
    files.pop_front();
  }
}

void MeshCatalogue::ForgetFiles(const std::string& digest) {
  MutexLock lock(files_mutex_);
  const auto it = files_of_digest_.find(digest);
  if (it == files_of_digest_.end()) return;
  for (const FileKey& file : it->second) digest_of_file_.erase(file);
  files_of_digest_.erase(it);
}

}  // namespace geodesic::server
