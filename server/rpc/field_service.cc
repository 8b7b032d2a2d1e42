#include "server/rpc/field_service.h"

#include <utility>

#include "server/rpc/field_stream.h"
#include "server/rpc/log_map_stream.h"
#include "server/rpc/sample_stream.h"

namespace geodesic::server {

FieldService::FieldService(QueryEngine& engine, std::string version,
                           RequestLog& log)
    : engine_(engine), version_(std::move(version)), log_(log) {}

grpc::ServerWriteReactor<v1::ComputeFieldResponse>* FieldService::ComputeField(
    grpc::CallbackServerContext* context,
    const v1::ComputeFieldRequest* request) {
  return FieldStream::Start(engine_, log_, version_, *context, *request);
}

grpc::ServerWriteReactor<v1::ComputeLogMapResponse>*
FieldService::ComputeLogMap(grpc::CallbackServerContext* context,
                            const v1::ComputeLogMapRequest* request) {
  return LogMapStream::Start(engine_, log_, version_, *context, *request);
}

grpc::ServerWriteReactor<v1::SampleFarthestPointsResponse>*
FieldService::SampleFarthestPoints(
    grpc::CallbackServerContext* context,
    const v1::SampleFarthestPointsRequest* request) {
  return SampleStream::Start(engine_, log_, version_, *context, *request);
}

}  // namespace geodesic::server
