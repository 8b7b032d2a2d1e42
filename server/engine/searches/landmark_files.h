// The finished landmarks of meshes, kept beside the fields and within their
// budget. What is lost here is made again.

#ifndef GEODESIC_SERVER_ENGINE_SEARCHES_LANDMARK_FILES_H_
#define GEODESIC_SERVER_ENGINE_SEARCHES_LANDMARK_FILES_H_

#include <string>
#include <utility>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/landmarks.h"
#include "geodesic/mesh.h"
#include "server/store/blob_tiers.h"

namespace geodesic::server {

// Thread-safe. All calls wait for the disk or the shared tier.
class LandmarkFiles {
 public:
  // Landmarks that another `version` of the program made are not found.
  // REQUIRES: `blobs`, those of FieldFiles, outlives the object.
  LandmarkFiles(BlobTiers& blobs, std::string version)
      : blobs_(blobs), version_(std::move(version)) {}

  // Errors: as BlobTiers::Keep.
  absl::Status Put(const std::string& digest, const Landmarks& landmarks);

  // From the disk or else from the shared tier; the disk then has them, too.
  // Errors: NOT_FOUND, DATA_LOSS (set aside), UNAVAILABLE, RESOURCE_EXHAUSTED.
  absl::StatusOr<Landmarks> Load(const std::string& digest, const Mesh& mesh);

  // Drops those of a mesh from the disk. On a disk that is read-only they stay;
  // they are still right, because meshes are named by their content.
  void Erase(const std::string& digest);

 private:
  std::string NameOf(const std::string& digest) const;

  BlobTiers& blobs_;
  const std::string version_;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_SEARCHES_LANDMARK_FILES_H_
