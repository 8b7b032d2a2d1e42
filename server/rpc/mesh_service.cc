#include "server/rpc/mesh_service.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "server/rpc/mesh_stream.h"
#include "server/rpc/mesh_translation.h"
#include "server/rpc/unary_call.h"
#include "server/rpc/upload_stream.h"

namespace geodesic::server {
namespace {

absl::Status FindMissing(QueryEngine& engine,
                         const v1::FindMissingMeshesRequest& request,
                         v1::FindMissingMeshesResponse& response) {
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
  return absl::OkStatus();
}

}  // namespace

MeshService::MeshService(QueryEngine& engine, RequestLog& log)
    : engine_(engine), log_(log) {}

grpc::ServerUnaryReactor* MeshService::FindMissingMeshes(
    grpc::CallbackServerContext* context,
    const v1::FindMissingMeshesRequest* request,
    v1::FindMissingMeshesResponse* response) {
  return AnswerUnary(context, log_, "FindMissingMeshes",
                     [&](RequestLog::Entry&) {
                       return FindMissing(engine_, *request, *response);
                     });
}

grpc::ServerReadReactor<v1::CreateMeshRequest>* MeshService::CreateMesh(
    grpc::CallbackServerContext* context, v1::CreateMeshResponse* response) {
  return UploadStream::Start(engine_, log_, *context, *response);
}

grpc::ServerUnaryReactor* MeshService::GetMesh(
    grpc::CallbackServerContext* context, const v1::GetMeshRequest* request,
    v1::GetMeshResponse* response) {
  return AnswerUnary(context, log_, "GetMesh", [&](RequestLog::Entry& entry) {
    entry.set_subject(DigestPrefix(request->digest()));
    absl::StatusOr<MeshDescription> mesh =
        engine_.DescribeMesh(request->digest());
    if (mesh.ok()) *response->mutable_mesh() = ToProto(*mesh);
    return mesh.status();
  });
}

grpc::ServerWriteReactor<v1::ReadMeshResponse>* MeshService::ReadMesh(
    grpc::CallbackServerContext* context, const v1::ReadMeshRequest* request) {
  return MeshStream::Start(engine_, log_, *context, *request);
}

grpc::ServerUnaryReactor* MeshService::ListMeshes(
    grpc::CallbackServerContext* context, const v1::ListMeshesRequest* request,
    v1::ListMeshesResponse* response) {
  return AnswerUnary(
      context, log_, "ListMeshes", [&](RequestLog::Entry&) -> absl::Status {
        absl::StatusOr<MeshPage> page =
            engine_.ListMeshes(request->page_size(), request->page_token());
        if (!page.ok()) return page.status();
        for (const MeshDescription& mesh : page->meshes) {
          *response->add_meshes() = ToProto(mesh);
        }
        response->set_next_page_token(std::move(page->next_token));
        return absl::OkStatus();
      });
}

grpc::ServerUnaryReactor* MeshService::DeleteMesh(
    grpc::CallbackServerContext* context, const v1::DeleteMeshRequest* request,
    v1::DeleteMeshResponse*) {
  const auto entry =
      std::make_shared<RequestLog::Entry>(log_, "DeleteMesh", *context);
  entry->set_subject(DigestPrefix(request->digest()));
  grpc::ServerUnaryReactor* reactor = context->DefaultReactor();
  const auto finish = [reactor, entry](const absl::Status& status) {
    reactor->Finish(entry->End(status));
  };
  absl::Status status = entry->Admit();
  if (status.ok()) {
    status = engine_.DeleteMesh(request->digest(), finish, entry->client());
  }
  if (!status.ok()) finish(status);
  return reactor;
}

}  // namespace geodesic::server
