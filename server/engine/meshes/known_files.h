// Which mesh came from which file.

#ifndef GEODESIC_SERVER_ENGINE_MESHES_KNOWN_FILES_H_
#define GEODESIC_SERVER_ENGINE_MESHES_KNOWN_FILES_H_

#include <deque>
#include <map>
#include <mutex>
#include <optional>
#include <string>

#include "server/engine/meshes/upload_header.h"

namespace geodesic::server {

// Thread-safe; calls nobody under its lock.
class KnownFiles {
 public:
  // The digest of the mesh that was uploaded as this file.
  std::optional<std::string> Find(const FileKey& file) const;

  // A mesh remembers its latest few files.
  void Add(FileKey file, const std::string& digest);

  // Forgets the files of a mesh.
  void Remove(const std::string& digest);

 private:
  mutable std::mutex mutex_;
  // Guarded by mutex_; each is the other's inverse:
  std::map<FileKey, std::string> digest_of_file_;
  std::map<std::string, std::deque<FileKey>> files_of_digest_;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_MESHES_KNOWN_FILES_H_
