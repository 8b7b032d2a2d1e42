// One ComputeMatrix call.

#ifndef GEODESIC_SERVER_RPC_STREAMS_MATRIX_STREAM_H_
#define GEODESIC_SERVER_RPC_STREAMS_MATRIX_STREAM_H_

#include <cstdint>

#include "absl/status/status.h"
#include "geodesic/v1/matrix_service.pb.h"
#include "server/rpc/streams/row_stream.h"

namespace geodesic::server {

class MatrixStream final
    : public RowStream<v1::ComputeMatrixRequest, v1::ComputeMatrixResponse> {
 public:
  using RowStream::RowStream;

 private:
  absl::Status Translate(MatrixRequest& question) const override;
  Chunk MakeChunk(v1::ComputeMatrixResponse& message, uint64_t row,
                  uint64_t value_count, uint64_t offset) const override;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_STREAMS_MATRIX_STREAM_H_
