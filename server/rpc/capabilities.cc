#include "server/rpc/capabilities.h"

#include "geodesic/algorithm.h"
#include "server/rpc/messages/field_translation.h"

namespace geodesic::server {

v1::GetCapabilitiesResponse MakeCapabilities(const Limits& limits,
                                             uint64_t max_message_bytes,
                                             const std::string& version) {
  v1::GetCapabilitiesResponse capabilities;
  capabilities.set_version(version);
  for (const AlgorithmInfo& info : kAlgorithms) {
    v1::AlgorithmCapability& algorithm = *capabilities.add_algorithms();
    algorithm.set_algorithm(ToProto(info.algorithm));
    algorithm.set_name(info.name.data(), info.name.size());
    algorithm.set_summary(info.summary.data(), info.summary.size());
    algorithm.set_is_default(info.algorithm == kDefaultAlgorithm);
  }
  for (const v1::MeshFormat format :
       {v1::MESH_FORMAT_ARRAYS, v1::MESH_FORMAT_OBJ, v1::MESH_FORMAT_PLY,
        v1::MESH_FORMAT_OFF, v1::MESH_FORMAT_STL}) {
    capabilities.add_formats(format);
  }
  v1::Limits& published = *capabilities.mutable_limits();
  published.set_max_upload_bytes(limits.max_upload_bytes);
  published.set_max_vertices(limits.max_vertices);
  published.set_max_faces(limits.max_faces);
  published.set_max_sources(limits.max_sources);
  published.set_max_message_bytes(max_message_bytes);
  published.set_max_concurrent_jobs(limits.max_concurrent_jobs);
  published.set_max_queued_jobs(limits.max_queued_jobs);
  published.set_max_queued_jobs_per_client(limits.max_queued_jobs_per_client);
  published.set_mesh_store_bytes(limits.mesh_store_bytes);
  published.set_field_cache_bytes(limits.field_cache_bytes);
  published.set_max_curve_points(limits.max_curve_points);
  published.set_max_targets(limits.max_targets);
  published.set_max_levels(limits.max_levels);
  published.set_max_samples(limits.max_samples);
  published.set_max_matrix_rows(limits.max_matrix_rows);
  published.set_max_matrix_values(limits.max_matrix_values);
  published.set_mesh_disk_bytes(limits.mesh_disk_bytes);
  published.set_field_disk_bytes(limits.field_disk_bytes);
  return capabilities;
}

}  // namespace geodesic::server
