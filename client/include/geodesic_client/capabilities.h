// What a server can do and where its limits are.

#ifndef GEODESIC_CLIENT_CAPABILITIES_H_
#define GEODESIC_CLIENT_CAPABILITIES_H_

#include <cstdint>
#include <string>
#include <vector>

namespace geodesic::client {

// An algorithm that a server has.
struct AlgorithmCapability {
  // As FieldQuery::algorithm spells it.
  std::string name;
  std::string summary;
  bool is_default = false;
};

// Limits of a server. A request beyond them is refused with RESOURCE_EXHAUSTED.
struct ServerLimits {
  uint64_t max_upload_bytes = 0;
  uint64_t max_vertices = 0;
  uint64_t max_faces = 0;
  uint64_t max_sources = 0;
  uint64_t max_message_bytes = 0;
  uint64_t max_concurrent_jobs = 0;
  uint64_t max_queued_jobs = 0;
  uint64_t mesh_store_bytes = 0;
  uint64_t field_cache_bytes = 0;
  // Limits of one request. The points of all its curves count together.
  uint64_t max_curve_points = 0;
  uint64_t max_targets = 0;
  uint64_t max_levels = 0;
  uint64_t max_samples = 0;
  // Pairs of one call; ComputePairs makes as many calls as it takes.
  uint64_t max_pairs = 0;
  // Limits of one matrix: rows, and rows times columns.
  uint64_t max_matrix_rows = 0;
  uint64_t max_matrix_values = 0;
  // Byte budgets on disk. 0: nothing outlives the server.
  uint64_t mesh_disk_bytes = 0;
  uint64_t field_disk_bytes = 0;
  // How many of the waiting jobs may belong to one client.
  uint64_t max_queued_jobs_per_client = 0;
  // Memory for landmarks of meshes. 0: none are made.
  uint64_t landmark_memory_bytes = 0;
  // Memory for what approximate algorithms prepare.
  uint64_t prepared_memory_bytes = 0;
};

// What a server can do.
struct Capabilities {
  std::string version;
  std::vector<AlgorithmCapability> algorithms;
  // No bound on the error of these is known.
  std::vector<AlgorithmCapability> approximate_algorithms;
  // Names of the mesh formats the server reads, "arrays" among them.
  std::vector<std::string> formats;
  ServerLimits limits;
};

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_CAPABILITIES_H_
