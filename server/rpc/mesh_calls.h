// The unary RPCs of geodesic.v1.MeshService.

#ifndef GEODESIC_SERVER_RPC_MESH_CALLS_H_
#define GEODESIC_SERVER_RPC_MESH_CALLS_H_

#include "absl/status/status.h"
#include "geodesic/v1/mesh_service.pb.h"
#include "server/rpc/calls/unary_call.h"

namespace geodesic::server {

class FindMissingCall final : public UnaryCall<v1::FindMissingMeshesRequest,
                                               v1::FindMissingMeshesResponse> {
 public:
  using UnaryCall::UnaryCall;

 private:
  absl::Status Ask() override;
};

class GetMeshCall final
    : public UnaryCall<v1::GetMeshRequest, v1::GetMeshResponse> {
 public:
  using UnaryCall::UnaryCall;

 private:
  absl::Status Ask() override;
};

class ListMeshesCall final
    : public UnaryCall<v1::ListMeshesRequest, v1::ListMeshesResponse> {
 public:
  using UnaryCall::UnaryCall;

 private:
  absl::Status Ask() override;
};

// Answers when the mesh is gone from the disk, too.
class DeleteMeshCall final
    : public UnaryCall<v1::DeleteMeshRequest, v1::DeleteMeshResponse> {
 public:
  using UnaryCall::UnaryCall;

 private:
  absl::Status Ask() override;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_MESH_CALLS_H_
