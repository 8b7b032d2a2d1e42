// geodesic.v1.MatrixService.

#ifndef GEODESIC_SERVER_RPC_MATRIX_SERVICE_H_
#define GEODESIC_SERVER_RPC_MATRIX_SERVICE_H_

#include <string>

#include "geodesic/v1/matrix_service.grpc.pb.h"
#include "server/engine/query_engine.h"
#include "server/rpc/request_log.h"

namespace geodesic::server {

class MatrixService final : public v1::MatrixService::CallbackService {
 public:
  // REQUIRES: `engine` and `log` outlive the service.
  MatrixService(QueryEngine& engine, std::string version, RequestLog& log);

  grpc::ServerWriteReactor<v1::ComputeMatrixResponse>* ComputeMatrix(
      grpc::CallbackServerContext* context,
      const v1::ComputeMatrixRequest* request) override;
  grpc::ServerWriteReactor<v1::FindNearestResponse>* FindNearest(
      grpc::CallbackServerContext* context,
      const v1::FindNearestRequest* request) override;

 private:
  QueryEngine& engine_;
  const std::string version_;
  RequestLog& log_;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_MATRIX_SERVICE_H_
