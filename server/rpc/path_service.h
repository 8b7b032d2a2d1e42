// geodesic.v1.PathService.

#ifndef GEODESIC_SERVER_RPC_PATH_SERVICE_H_
#define GEODESIC_SERVER_RPC_PATH_SERVICE_H_

#include <string>

#include "geodesic/v1/path_service.grpc.pb.h"
#include "server/engine/query_engine.h"
#include "server/rpc/request_log.h"

namespace geodesic::server {

class PathService final : public v1::PathService::CallbackService {
 public:
  // REQUIRES: `engine` and `log` outlive the service.
  PathService(QueryEngine& engine, std::string version, RequestLog& log);

  grpc::ServerWriteReactor<v1::ComputePathsResponse>* ComputePaths(
      grpc::CallbackServerContext* context,
      const v1::ComputePathsRequest* request) override;
  grpc::ServerWriteReactor<v1::ComputeIsolinesResponse>* ComputeIsolines(
      grpc::CallbackServerContext* context,
      const v1::ComputeIsolinesRequest* request) override;

 private:
  QueryEngine& engine_;
  const std::string version_;
  RequestLog& log_;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_PATH_SERVICE_H_
