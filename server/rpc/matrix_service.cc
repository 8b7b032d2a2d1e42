#include "server/rpc/matrix_service.h"

#include <utility>

#include "server/rpc/matrix_stream.h"
#include "server/rpc/nearest_stream.h"

namespace geodesic::server {

MatrixService::MatrixService(QueryEngine& engine, std::string version,
                             RequestLog& log)
    : engine_(engine), version_(std::move(version)), log_(log) {}

grpc::ServerWriteReactor<v1::ComputeMatrixResponse>*
MatrixService::ComputeMatrix(grpc::CallbackServerContext* context,
                             const v1::ComputeMatrixRequest* request) {
  return MatrixStream::Start(engine_, log_, version_, *context, *request);
}

grpc::ServerWriteReactor<v1::FindNearestResponse>* MatrixService::FindNearest(
    grpc::CallbackServerContext* context,
    const v1::FindNearestRequest* request) {
  return NearestStream::Start(engine_, log_, version_, *context, *request);
}

}  // namespace geodesic::server
