#include "server/rpc/mesh_calls.h"

#include <string>
#include <utility>
#include <vector>

#include "absl/status/statusor.h"
#include "absl/strings/str_cat.h"
#include "server/rpc/messages/mesh_translation.h"

namespace geodesic::server {
namespace {

absl::StatusOr<v1::FindMissingMeshesResponse> FindMissing(
    QueryEngine& engine, const v1::FindMissingMeshesRequest& request) {
  std::vector<FileKey> files;
  for (int i = 0; i < request.files_size(); ++i) {
    const v1::FileDigest& file = request.files(i);
    absl::StatusOr<UploadFormat> format =
        FromProto(file.format(), absl::StrCat("files[", i, "].format"));
    if (!format.ok()) return format.status();
    files.push_back({*format, file.sha256()});
  }
  absl::StatusOr<MissingMeshes> missing = engine.FindMissing(
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

}  // namespace

absl::Status FindMissingCall::Ask() {
  Answer(FindMissing(engine(), request()));
  return absl::OkStatus();
}

absl::Status GetMeshCall::Ask() {
  absl::StatusOr<MeshDescription> mesh =
      engine().DescribeMesh(request().digest());
  if (!mesh.ok()) return mesh.status();
  v1::GetMeshResponse response;
  *response.mutable_mesh() = ToProto(*mesh);
  Answer(std::move(response));
  return absl::OkStatus();
}

absl::Status ListMeshesCall::Ask() {
  absl::StatusOr<MeshPage> page =
      engine().ListMeshes(request().page_size(), request().page_token());
  if (!page.ok()) return page.status();
  v1::ListMeshesResponse response;
  for (const MeshDescription& mesh : page->meshes) {
    *response.add_meshes() = ToProto(mesh);
  }
  response.set_next_page_token(std::move(page->next_token));
  Answer(std::move(response));
  return absl::OkStatus();
}

absl::Status DeleteMeshCall::Ask() {
  const auto answer = [self = std::static_pointer_cast<DeleteMeshCall>(
                           shared_from_this())](const absl::Status& status) {
    self->Answer(status.ok() ? absl::StatusOr<v1::DeleteMeshResponse>(
                                   v1::DeleteMeshResponse())
                             : status);
  };
  return engine().DeleteMesh(request().digest(), answer, client());
}

}  // namespace geodesic::server
