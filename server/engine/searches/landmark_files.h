// The finished landmarks of meshes on disk, beside the fields and within their
// budget. What is lost here is made again.

#ifndef GEODESIC_SERVER_ENGINE_SEARCHES_LANDMARK_FILES_H_
#define GEODESIC_SERVER_ENGINE_SEARCHES_LANDMARK_FILES_H_

#include <string>
#include <utility>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/landmarks.h"
#include "geodesic/mesh.h"
#include "server/store/blob_store.h"

namespace geodesic::server {

// Thread-safe. All calls wait for the disk.
class LandmarkFiles {
 public:
  // Landmarks that another `version` of the program made are not found.
  // REQUIRES: `blobs`, those of FieldFiles, outlives the object.
  LandmarkFiles(BlobStore& blobs, std::string version)
      : blobs_(blobs), version_(std::move(version)) {}

  // Errors: as BlobStore::Put.
  absl::Status Put(const std::string& digest, const Landmarks& landmarks);

  // Errors: NOT_FOUND, DATA_LOSS (set aside), UNAVAILABLE, RESOURCE_EXHAUSTED.
  absl::StatusOr<Landmarks> Load(const std::string& digest, const Mesh& mesh);

  // Drops those of a mesh. On a disk that is read-only they stay; they are
  // still right, because meshes are named by their content.
  void Erase(const std::string& digest);

 private:
  std::string NameOf(const std::string& digest) const;

  BlobStore& blobs_;
  const std::string version_;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_SEARCHES_LANDMARK_FILES_H_
