// The meshes on disk. A file's body is what the mesh's digest is the digest of,
// so that a mesh cannot be read but as the one that was written.

#ifndef GEODESIC_SERVER_ENGINE_MESHES_MESH_FILES_H_
#define GEODESIC_SERVER_ENGINE_MESHES_MESH_FILES_H_

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/checkpoint.h"
#include "geodesic/triangle_soup.h"
#include "server/engine/meshes/known_files.h"
#include "server/engine/meshes/mesh_description.h"
#include "server/engine/meshes/mesh_store.h"
#include "server/engine/meshes/upload_header.h"
#include "server/store/blob_store.h"

namespace geodesic::server {

// Thread-safe. Put, Load and Erase wait for the disk; the others do not. See
// BlobStore for what outlives what.
class MeshFiles {
 public:
  // `warn` hears of damaged files. REQUIRES: `folder` outlives the object.
  // Errors: as BlobStore::Open.
  static absl::StatusOr<std::unique_ptr<MeshFiles>> Open(
      const DataFolder& folder, uint64_t capacity,
      std::function<void(const std::string&)> warn);

  // `removed` hears of each mesh that was evicted or found damaged, when it is
  // gone. Call before all else.
  void SetRemoved(std::function<void(const std::string& digest)> removed) {
    removed_ = std::move(removed);
  }

  // Whether it is there; marks it as used. Describe does, too.
  bool Contains(const std::string& digest);
  std::optional<MeshDescription> Describe(const std::string& digest);

  // Up to `count` meshes in order of digest, from the first above `after`.
  std::vector<MeshDescription> List(const std::string& after,
                                    size_t count) const;

  // The digest of the mesh that was uploaded as this file. After a restart
  // only the first such file is known of each mesh.
  std::optional<std::string> FindFile(const FileKey& file) const;
  void AddFile(FileKey file, const std::string& digest);

  // Whether a mesh of this size can ever be kept; see BlobStore::Admit.
  absl::Status Admit(uint64_t vertices, uint64_t faces);

  // Returns when the mesh is on the disk for good.
  // Errors: as Admit; RESOURCE_EXHAUSTED (disk or budget full), UNAVAILABLE,
  // both with a retry hint.
  absl::Status Put(const ResidentMesh& mesh,
                   const std::optional<FileKey>& file);

  // Takes memory for the arrays of the `mesh` described.
  // Errors: NOT_FOUND (not there, or damaged and set aside), what `checkpoint`
  // says, RESOURCE_EXHAUSTED, UNAVAILABLE (it cannot be read now).
  absl::StatusOr<TriangleSoup> Load(const MeshDescription& mesh,
                                    Checkpoint& checkpoint);

  // Errors: NOT_FOUND; UNAVAILABLE.
  absl::Status Erase(const std::string& digest);

  const BlobStore& blobs() const { return *blobs_; }

 private:
  MeshFiles() = default;
  void ReadFileKeys();

  KnownFiles files_;
  std::function<void(const std::string&)> removed_;
  std::unique_ptr<BlobStore> blobs_;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_MESHES_MESH_FILES_H_
