// Saddle vertex graphs, kept beside the fields. A graph that is lost here is
// built again. Other methods are prepared as fast as they would be read.

#ifndef GEODESIC_SERVER_ENGINE_METHODS_GRAPH_FILES_H_
#define GEODESIC_SERVER_ENGINE_METHODS_GRAPH_FILES_H_

#include <cstdint>
#include <memory>
#include <string>
#include <utility>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/approximate/saddle_vertex_graph.h"
#include "geodesic/mesh.h"
#include "server/store/blob_tiers.h"

namespace geodesic::server {

// Thread-safe. Every method waits for the disk or the shared tier.
class GraphFiles {
 public:
  // Graphs that another `version` of the program built are not found.
  // REQUIRES: `blobs`, those of FieldFiles, outlives the object.
  GraphFiles(BlobTiers& blobs, std::string version)
      : blobs_(blobs), version_(std::move(version)) {}

  // Errors: as BlobTiers::Keep.
  absl::Status Put(const std::string& digest, uint32_t neighbours,
                   const SaddleVertexGraph& graph);

  // From the disk or else from the shared tier; the disk then has it, too.
  // Errors: NOT_FOUND, DATA_LOSS (set aside), UNAVAILABLE, RESOURCE_EXHAUSTED.
  absl::StatusOr<std::shared_ptr<const SaddleVertexGraph>> Load(
      const std::string& digest, uint32_t neighbours, const Mesh& mesh);

  // Drops those of a mesh from the disk. On a disk that is read-only they stay;
  // they are still right, because meshes are named by their content.
  void EraseMesh(const std::string& digest);

 private:
  std::string NameOf(const std::string& digest, uint32_t neighbours) const;

  BlobTiers& blobs_;
  const std::string version_;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_METHODS_GRAPH_FILES_H_
