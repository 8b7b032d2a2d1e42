#include "server/engine/meshes/known_files.h"

#include <utility>

namespace geodesic::server {
namespace {

// The same mesh in every format, and a few spellings of it.
constexpr size_t kMaxFilesPerMesh = 16;

}  // namespace

std::optional<std::string> KnownFiles::Find(const FileKey& file) const {
  std::lock_guard lock(mutex_);
  const auto it = digest_of_file_.find(file);
  if (it == digest_of_file_.end()) return std::nullopt;
  return it->second;
}

void KnownFiles::Add(FileKey file, const std::string& digest) {
  std::lock_guard lock(mutex_);
  if (!digest_of_file_.emplace(file, digest).second) return;
  std::deque<FileKey>& files = files_of_digest_[digest];
  files.push_back(std::move(file));
  if (files.size() > kMaxFilesPerMesh) {
    digest_of_file_.erase(files.front());
    files.pop_front();
  }
}

void KnownFiles::Remove(const std::string& digest) {
  std::lock_guard lock(mutex_);
  const auto it = files_of_digest_.find(digest);
  if (it == files_of_digest_.end()) return;
  for (const FileKey& file : it->second) digest_of_file_.erase(file);
  files_of_digest_.erase(it);
}

}  // namespace geodesic::server
