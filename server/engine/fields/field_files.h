// The finished fields on disk: a second, larger FieldCache that outlives the
// process. A field that is lost here is computed again.

#ifndef GEODESIC_SERVER_ENGINE_FIELDS_FIELD_FILES_H_
#define GEODESIC_SERVER_ENGINE_FIELDS_FIELD_FILES_H_

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/distance_field.h"
#include "geodesic/mesh.h"
#include "server/engine/fields/field_key.h"
#include "server/store/blob_store.h"

namespace geodesic::server {

// Thread-safe. Put, Load and EraseMesh wait for the disk; Find does not.
class FieldFiles {
 public:
  // Fields that another `version` of the program computed are not found.
  // REQUIRES: `folder` outlives the object. Errors: as BlobStore::Open.
  static absl::StatusOr<std::unique_ptr<FieldFiles>> Open(
      const DataFolder& folder, uint64_t capacity, std::string version,
      std::function<void(const std::string&)> warn);

  // The key of a field that answers the question, as far as can be told
  // without reading it; see FieldCache::Find.
  std::optional<FieldKey> Find(const FieldKey& key, const FieldReach& reach);

  // Keeps the field unless one is there that reaches as far.
  // Errors: as BlobStore::Put.
  absl::Status Put(const FieldKey& key, const Mesh& mesh,
                   const DistanceField& field);

  // The field of a key that Find returned, on its mesh. A traced field names
  // half-edges, so it is found only while meshes are laid out as they were.
  // Errors: NOT_FOUND, DATA_LOSS (set aside), UNAVAILABLE, RESOURCE_EXHAUSTED.
  absl::StatusOr<DistanceField> Load(const FieldKey& key, const Mesh& mesh);

  // Drops the fields of a mesh. What cannot be removed now, for its disk is
  // read-only, stays and is right still: meshes are named by their content.
  void EraseMesh(const std::string& digest);

  const BlobStore& blobs() const { return *blobs_; }

 private:
  FieldFiles(std::string version, std::unique_ptr<BlobStore> blobs)
      : version_(std::move(version)), blobs_(std::move(blobs)) {}

  std::string NameOf(const FieldKey& key) const;

  const std::string version_;
  const std::unique_ptr<BlobStore> blobs_;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_FIELDS_FIELD_FILES_H_
