#include "server/rpc/path_service.h"

#include <utility>

#include "server/rpc/isoline_stream.h"
#include "server/rpc/path_stream.h"

namespace geodesic::server {

PathService::PathService(QueryEngine& engine, std::string version,
                         RequestLog& log)
    : engine_(engine), version_(std::move(version)), log_(log) {}

grpc::ServerWriteReactor<v1::ComputePathsResponse>* PathService::ComputePaths(
    grpc::CallbackServerContext* context,
    const v1::ComputePathsRequest* request) {
  return PathStream::Start(engine_, log_, version_, *context, *request);
}

grpc::ServerWriteReactor<v1::ComputeIsolinesResponse>*
PathService::ComputeIsolines(grpc::CallbackServerContext* context,
                             const v1::ComputeIsolinesRequest* request) {
  return IsolineStream::Start(engine_, log_, version_, *context, *request);
}

}  // namespace geodesic::server
