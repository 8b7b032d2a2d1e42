#include "server/rpc/unary_calls.h"

#include <string>
#include <utility>
#include <vector>

#include "absl/status/statusor.h"
#include "absl/strings/str_cat.h"
#include "codec/algorithms.h"
#include "geodesic_types/algorithms.h"
#include "server/rpc/messages/translation.h"

namespace geodesic::server {

absl::StatusOr<v1::FindMissingMeshesResponse> AnswerOf(
    const ServiceContext& service,
    const v1::FindMissingMeshesRequest& request) {
  std::vector<FileKey> files;
  for (int i = 0; i < request.files_size(); ++i) {
    absl::StatusOr<FileKey> file =
        FromProto(request.files(i), absl::StrCat("files[", i, "]"));
    if (!file.ok()) return file.status();
    files.push_back(*std::move(file));
  }
  absl::StatusOr<MissingMeshes> missing = service.engine.meshes().FindMissing(
      {request.mesh_digests().begin(), request.mesh_digests().end()}, files);
  if (!missing.ok()) return missing.status();
  v1::FindMissingMeshesResponse response;
  for (std::string& digest : missing->mesh_digests) {
    response.add_missing_mesh_digests(std::move(digest));
  }
  for (const FileKey& file : missing->files) {
    *response.add_missing_files() = ToProto(file);
  }
  for (const MissingMeshes::KnownFile& known : missing->known_files) {
    v1::KnownFile& proto = *response.add_known_files();
    *proto.mutable_file() = ToProto(known.file);
    proto.set_mesh_digest(known.mesh_digest);
  }
  return response;
}

absl::StatusOr<v1::GetMeshResponse> AnswerOf(
    const ServiceContext& service, const v1::GetMeshRequest& request) {
  absl::StatusOr<MeshDescription> mesh =
      service.engine.meshes().Describe(request.digest());
  if (!mesh.ok()) return mesh.status();
  v1::GetMeshResponse response;
  *response.mutable_mesh() = ToProto(*mesh);
  return response;
}

absl::StatusOr<v1::ListMeshesResponse> AnswerOf(
    const ServiceContext& service, const v1::ListMeshesRequest& request) {
  absl::StatusOr<MeshPage> page =
      service.engine.meshes().List(request.page_size(), request.page_token());
  if (!page.ok()) return page.status();
  v1::ListMeshesResponse response;
  for (const MeshDescription& mesh : page->meshes) {
    *response.add_meshes() = ToProto(mesh);
  }
  response.set_next_page_token(std::move(page->next_token));
  return response;
}

absl::Status DeleteMeshCall::Ask() {
  const auto answer = [self = Shared(this)](const absl::Status& status) {
    self->Answer(status.ok() ? absl::StatusOr<v1::DeleteMeshResponse>(
                                   v1::DeleteMeshResponse())
                             : status);
  };
  std::string client;
  {
    MutexLock lock(mutex_);
    client = entry().client();
  }
  return engine().meshes().Delete(request().digest(), answer, client);
}

v1::GetCapabilitiesResponse MakeCapabilities(const Limits& limits,
                                             uint64_t max_message_bytes,
                                             const std::string& version) {
  v1::GetCapabilitiesResponse capabilities;
  capabilities.set_version(version);
  for (const AlgorithmInfo& info : kAlgorithms) {
    v1::AlgorithmCapability& algorithm = *capabilities.add_algorithms();
    algorithm.set_algorithm(codec::ToProto(info.algorithm));
    algorithm.set_name(info.name.data(), info.name.size());
    algorithm.set_summary(info.summary.data(), info.summary.size());
    algorithm.set_is_default(info.algorithm == kDefaultAlgorithm);
  }
  for (const ApproximateMethodInfo& info : kApproximateMethods) {
    v1::AlgorithmCapability& algorithm =
        *capabilities.add_approximate_algorithms();
    algorithm.set_algorithm(codec::ToProto(info.method));
    algorithm.set_name(info.name.data(), info.name.size());
    algorithm.set_summary(info.summary.data(), info.summary.size());
  }
  capabilities.add_formats(v1::MESH_FORMAT_ARRAYS);
  for (const MeshFormatInfo& info : kMeshFormats) {
    capabilities.add_formats(ToProto(info.format));
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
  published.set_max_pairs(limits.max_pairs);
  published.set_max_matrix_rows(limits.max_matrix_rows);
  published.set_max_matrix_values(limits.max_matrix_values);
  published.set_mesh_disk_bytes(limits.mesh_disk_bytes);
  published.set_field_disk_bytes(limits.field_disk_bytes);
  published.set_landmark_memory_bytes(limits.landmark_memory_bytes);
  published.set_prepared_memory_bytes(limits.prepared_memory_bytes);
  return capabilities;
}

}  // namespace geodesic::server
