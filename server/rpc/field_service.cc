#include "server/rpc/field_service.h"

#include <utility>

#include "server/rpc/field_stream.h"

namespace geodesic::server {

FieldService::FieldService(QueryEngine& engine, std::string version,
                           RequestLog& log)
    : engine_(engine), version_(std::move(version)), log_(log) {}

grpc::ServerWriteReactor<v1::ComputeFieldResponse>* FieldService::ComputeField(
    grpc::CallbackServerContext* context,
    const v1::ComputeFieldRequest* request) {
  return FieldStream::Start(engine_, log_, version_, *context, *request);
}

}  // namespace geodesic::server
