// The meshes on disk. A mesh's digest is the digest of its file's body, so a
// mesh that is read is the one that was written.

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
#include "server/engine/meshes/mesh_catalogue.h"
#include "server/store/blob_store.h"

namespace geodesic::server {

// Thread-safe. See BlobStore for what survives a crash. After a restart only
// the first file that a mesh was uploaded as is known.
class MeshFiles final : public MeshCatalogue {
 public:
  // `warn` is told of damaged files. REQUIRES: `folder` outlives the object.
  // Errors: as BlobStore::Open.
  static absl::StatusOr<std::unique_ptr<MeshFiles>> Open(
      const DataFolder& folder, uint64_t capacity,
      std::function<void(const std::string&)> warn);

  // `removed` is called after a mesh was evicted or found damaged. Call this
  // before any other method.
  void SetRemoved(std::function<void(const std::string& digest)> removed) {
    removed_ = std::move(removed);
  }

  std::optional<MeshDescription> Describe(const std::string& digest) override;
  std::vector<MeshDescription> List(const std::string& after,
                                    size_t count) const override;
  absl::Status Erase(const std::string& digest) override;
  bool is_durable() const override { return true; }
  absl::Status Admit(uint64_t vertices, uint64_t faces) override;
  absl::Status Put(const ResidentMesh& mesh,
                   const std::optional<FileKey>& file) override;
  absl::Status Look(const std::string& digest) override;
  absl::StatusOr<TriangleSoup> Load(const MeshDescription& mesh,
                                    Checkpoint& checkpoint) override;

  const BlobStore& blobs() const { return *blobs_; }

 private:
  MeshFiles() = default;

  std::function<void(const std::string&)> removed_;
  std::unique_ptr<BlobStore> blobs_;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_MESHES_MESH_FILES_H_
