// geodesic.v1.MeshService.

#ifndef GEODESIC_SERVER_RPC_MESH_SERVICE_H_
#define GEODESIC_SERVER_RPC_MESH_SERVICE_H_

#include "geodesic/v1/mesh_service.grpc.pb.h"
#include "server/engine/query_engine.h"
#include "server/rpc/request_log.h"

namespace geodesic::server {

class MeshService final : public v1::MeshService::CallbackService {
 public:
  // REQUIRES: `engine` and `log` outlive the service.
  MeshService(QueryEngine& engine, RequestLog& log);

  grpc::ServerUnaryReactor* FindMissingMeshes(
      grpc::CallbackServerContext* context,
      const v1::FindMissingMeshesRequest* request,
      v1::FindMissingMeshesResponse* response) override;

  grpc::ServerReadReactor<v1::CreateMeshRequest>* CreateMesh(
      grpc::CallbackServerContext* context,
      v1::CreateMeshResponse* response) override;

  grpc::ServerUnaryReactor* GetMesh(grpc::CallbackServerContext* context,
                                    const v1::GetMeshRequest* request,
                                    v1::GetMeshResponse* response) override;

  grpc::ServerWriteReactor<v1::ReadMeshResponse>* ReadMesh(
      grpc::CallbackServerContext* context,
      const v1::ReadMeshRequest* request) override;

  grpc::ServerUnaryReactor* ListMeshes(
      grpc::CallbackServerContext* context,
      const v1::ListMeshesRequest* request,
      v1::ListMeshesResponse* response) override;

  grpc::ServerUnaryReactor* DeleteMesh(
      grpc::CallbackServerContext* context,
      const v1::DeleteMeshRequest* request,
      v1::DeleteMeshResponse* response) override;

 private:
  QueryEngine& engine_;
  RequestLog& log_;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_MESH_SERVICE_H_
