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
#include "server/engine/meshes/mesh_catalogue.h"
#include "server/store/blob_store.h"

namespace geodesic::server {

// Thread-safe. See BlobStore for what outlives what. After a restart only the
// first file that a mesh was uploaded as is known.
class MeshFiles final : public MeshCatalogue {
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

  std::optional<MeshDescription> Describe(const std::string& digest) override;
  std::vector<MeshDescription> List(const std::string& after,
                                    size_t count) const override;
  absl::Status Erase(const std::string& digest) override;
  bool is_durable() const override { return true; }
  absl::Status Admit(uint64_t vertices, uint64_t faces) override;
  absl::Status Put(const ResidentMesh& mesh,
                   const std::optional<FileKey>& file) override;
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
