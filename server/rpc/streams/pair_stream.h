// ComputePairs.

#ifndef GEODESIC_SERVER_RPC_STREAMS_PAIR_STREAM_H_
#define GEODESIC_SERVER_RPC_STREAMS_PAIR_STREAM_H_

#include <cstdint>
#include <optional>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "codec/answer_writer.h"
#include "geodesic/v1/question_service.pb.h"
#include "server/engine/pairs/pair_order.h"
#include "server/engine/query_engine.h"
#include "server/rpc/calls/answer_stream.h"

namespace geodesic::server {

class PairStream final : public AnswerStream<v1::ComputePairsRequest> {
 public:
  using AnswerStream::AnswerStream;

 private:
  absl::Status AskEngine() override;
  void Cancel() override { call_.rows->Cancel(); }
  absl::StatusOr<NextMessage> FillBlocks() override;

  // Set by AskEngine, then constant:
  PairCall call_;
  uint32_t distance_ = 0;

  // Guarded by the stream's lock:
  std::optional<codec::LineWriter> lines_;  // if paths were asked for
  std::optional<PairOrder> order_;
  MatrixRow row_;               // whose paths are being put
  uint64_t next_path_ = 0;      // of row_
  double certified_error_ = 0;  // of the rows that were taken
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_STREAMS_PAIR_STREAM_H_
