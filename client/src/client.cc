#include "geodesic_client/client.h"

#include <utility>

#include "connection.h"
#include "mesh_assembler.h"
#include "translate.h"

namespace geodesic::client {

Client::Client(const std::string& server, const ConnectionOptions& options)
    : connection_(std::make_unique<Connection>(server, options)) {}

Client::~Client() = default;

absl::StatusOr<MeshInfo> Client::GetMesh(const std::string& digest,
                                         const CallOptions& options) {
  v1::GetMeshRequest request;
  request.set_digest(digest);
  v1::GetMeshResponse response;
  Call call(options, digest);
  absl::Status status = FromRpcStatus(
      connection_->meshes->GetMesh(call.context(), request, &response));
  if (!status.ok()) return status;
  return FromProto(response.mesh());
}

absl::StatusOr<std::vector<MeshInfo>> Client::ListMeshes(
    const CallOptions& options) {
  std::vector<MeshInfo> meshes;
  v1::ListMeshesRequest request;
  request.set_page_size(1000);  // The largest there is.
  v1::ListMeshesResponse response;
  do {
    Call call(options, "");
    absl::Status status = FromRpcStatus(
        connection_->meshes->ListMeshes(call.context(), request, &response));
    if (!status.ok()) return status;
    if (!response.next_page_token().empty() &&
        response.next_page_token() == request.page_token()) {
      return absl::DataLossError("the server's list of meshes does not end");
    }
    for (const v1::Mesh& mesh : response.meshes()) {
      meshes.push_back(FromProto(mesh));
    }
    request.set_page_token(response.next_page_token());
  } while (!request.page_token().empty());
  return meshes;
}

absl::StatusOr<MeshArrays> Client::ReadMesh(const std::string& digest,
                                            const CallOptions& options) {
  v1::ReadMeshRequest request;
  request.set_digest(digest);
  MeshAssembler assembler;
  Call call(options, digest);
  absl::Status status =
      ReadStream(&call, connection_->meshes->ReadMesh(call.context(), request),
                 [&assembler](const v1::ReadMeshResponse& response) {
                   return assembler.Consume(response);
                 });
  if (!status.ok()) return status;
  return std::move(assembler).Finish();
}

absl::Status Client::DeleteMesh(const std::string& digest,
                                const CallOptions& options) {
  v1::DeleteMeshRequest request;
  request.set_digest(digest);
  v1::DeleteMeshResponse response;
  Call call(options, digest);
  return FromRpcStatus(
      connection_->meshes->DeleteMesh(call.context(), request, &response));
}

absl::StatusOr<Capabilities> Client::GetCapabilities(
    const CallOptions& options) {
  v1::GetCapabilitiesRequest request;
  v1::GetCapabilitiesResponse response;
  Call call(options, "");
  absl::Status status =
      FromRpcStatus(connection_->capabilities->GetCapabilities(
          call.context(), request, &response));
  if (!status.ok()) return status;
  return FromProto(response);
}

}  // namespace geodesic::client
