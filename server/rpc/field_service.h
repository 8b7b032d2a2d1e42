// geodesic.v1.FieldService.

#ifndef GEODESIC_SERVER_RPC_FIELD_SERVICE_H_
#define GEODESIC_SERVER_RPC_FIELD_SERVICE_H_

#include <string>

#include "geodesic/v1/field_service.grpc.pb.h"
#include "server/engine/query_engine.h"
#include "server/rpc/request_log.h"

namespace geodesic::server {

class FieldService final : public v1::FieldService::CallbackService {
 public:
  // REQUIRES: `engine` and `log` outlive the service.
  FieldService(QueryEngine& engine, std::string version, RequestLog& log);

  grpc::ServerWriteReactor<v1::ComputeFieldResponse>* ComputeField(
      grpc::CallbackServerContext* context,
      const v1::ComputeFieldRequest* request) override;
  grpc::ServerWriteReactor<v1::ComputeLogMapResponse>* ComputeLogMap(
      grpc::CallbackServerContext* context,
      const v1::ComputeLogMapRequest* request) override;
  grpc::ServerWriteReactor<v1::SampleFarthestPointsResponse>*
  SampleFarthestPoints(grpc::CallbackServerContext* context,
                       const v1::SampleFarthestPointsRequest* request) override;

 private:
  QueryEngine& engine_;
  const std::string version_;
  RequestLog& log_;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_FIELD_SERVICE_H_
