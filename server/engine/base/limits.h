// All limits of the engine; GetCapabilities publishes those that clients meet.
// geodesicd divides --memory among the budgets (options/memory.cc).

#ifndef GEODESIC_SERVER_ENGINE_BASE_LIMITS_H_
#define GEODESIC_SERVER_ENGINE_BASE_LIMITS_H_

#include <chrono>
#include <cstdint>

namespace geodesic::server {

struct Limits {
  // For one upload and the mesh in it.
  uint64_t max_upload_bytes = uint64_t{1} << 30;
  uint64_t max_vertices = uint64_t{100'000'000};
  uint64_t max_faces = uint64_t{200'000'000};

  // For one query; the curve points are those of all its curves together.
  uint64_t max_sources = 100'000;
  uint64_t max_curve_points = 100'000;
  uint64_t max_targets = 1'000'000;
  uint64_t max_levels = 1'000;
  uint64_t max_samples = 100'000;

  // Pairs of one question for their distances.
  uint64_t max_pairs = 65'536;

  // For one matrix: rows, and rows times columns.
  uint64_t max_matrix_rows = 1'000'000;
  uint64_t max_matrix_values = uint64_t{100'000'000'000};

  // Jobs (solves and mesh builds) that run at once.
  uint64_t max_concurrent_jobs = 2;
  // Threads that share one solve, if they are idle when it starts.
  uint64_t max_threads_per_solve = 8;
  uint64_t max_queued_jobs = 256;
  // Waiting jobs of one client.
  uint64_t max_queued_jobs_per_client = 64;

  // Byte budgets: resident meshes, finished fields, uploads on their way to
  // become meshes, what running solvers hold, landmarks (0: none are made), and
  // what approximate methods prepare.
  uint64_t mesh_store_bytes = uint64_t{4} << 30;
  uint64_t field_cache_bytes = uint64_t{1} << 30;
  uint64_t upload_memory_bytes = uint64_t{4} << 30;
  uint64_t solver_memory_bytes = uint64_t{8} << 30;
  uint64_t landmark_memory_bytes = uint64_t{512} << 20;
  uint64_t prepared_memory_bytes = uint64_t{1} << 30;

  // Byte budgets of meshes and fields on disk; 0: nothing outlives the server.
  uint64_t mesh_disk_bytes = 0;
  uint64_t field_disk_bytes = 0;

  // Progress of one computation is published no more often than this.
  std::chrono::milliseconds progress_interval{50};
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_BASE_LIMITS_H_
