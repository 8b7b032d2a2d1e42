// One ComputeMatrix call.

#ifndef GEODESIC_SERVER_RPC_MATRIX_STREAM_H_
#define GEODESIC_SERVER_RPC_MATRIX_STREAM_H_

#include <grpcpp/server_context.h>
#include <grpcpp/support/server_callback.h>

#include <cstdint>
#include <string>

#include "absl/status/statusor.h"
#include "geodesic/v1/matrix_service.pb.h"
#include "server/engine/query_engine.h"
#include "server/rpc/request_log.h"
#include "server/rpc/row_stream.h"

namespace geodesic::server {

class MatrixStream final : public RowStream<v1::ComputeMatrixResponse> {
 public:
  // REQUIRES: `engine`, `log` and `version` outlive the call; `context` and
  // `request` live until gRPC is done with it.
  static grpc::ServerWriteReactor<v1::ComputeMatrixResponse>* Start(
      QueryEngine& engine, RequestLog& log, const std::string& version,
      grpc::CallbackServerContext& context,
      const v1::ComputeMatrixRequest& request);

 private:
  MatrixStream(QueryEngine& engine, RequestLog& log, const std::string& version,
               grpc::CallbackServerContext& context,
               const v1::ComputeMatrixRequest& request);

  absl::StatusOr<Question> Translate(const Limits& limits) const override;
  Chunk MakeChunk(v1::ComputeMatrixResponse& message, uint64_t row,
                  uint64_t value_count, uint64_t offset) const override;

  const grpc::CallbackServerContext& context_;
  const v1::ComputeMatrixRequest& request_;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_MATRIX_STREAM_H_
