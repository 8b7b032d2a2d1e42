// Client::ReadMesh: vertices and faces off a server stream.

#include <utility>

#include "call.h"
#include "connection.h"
#include "mesh_assembler.h"
#include "rpc_status.h"

namespace geodesic::client {

absl::StatusOr<MeshArrays> Client::ReadMesh(const std::string& digest,
                                            const CallOptions& options) {
  v1::ReadMeshRequest request;
  request.set_digest(digest);
  Call call(options);
  auto reader = connection_->meshes->ReadMesh(call.context(), request);
  MeshAssembler assembler;
  v1::ReadMeshResponse response;
  absl::Status broken;
  while (broken.ok() && reader->Read(&response)) {
    broken = assembler.Consume(response);
  }
  if (!broken.ok()) call.context()->TryCancel();
  const absl::Status status = FromRpcStatus(reader->Finish());
  if (!broken.ok()) return broken;
  if (!status.ok()) return status;
  return std::move(assembler).Finish();
}

}  // namespace geodesic::client
