// ComputePairs: header, progress, chunks in order of pair, trailer.

#ifndef GEODESIC_SERVER_RPC_STREAMS_PAIR_STREAM_H_
#define GEODESIC_SERVER_RPC_STREAMS_PAIR_STREAM_H_

#include <cstdint>
#include <optional>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/v1/pair_service.pb.h"
#include "server/engine/pairs/pair_order.h"
#include "server/engine/query_engine.h"
#include "server/rpc/calls/answer_stream.h"
#include "server/rpc/messages/translation.h"

namespace geodesic::server {

// Rows are taken when a distance is due that is in none of those before.
class PairStream final
    : public AnswerStream<v1::ComputePairsRequest, v1::ComputePairsResponse> {
 public:
  using AnswerStream::AnswerStream;

 private:
  static constexpr uint64_t kPairsPerChunk = 32768;

  absl::Status Ask() override;
  void Cancel() override { call_.rows->Cancel(); }
  absl::StatusOr<NextMessage> Fill(v1::ComputePairsResponse& message) override;

  void FillHeader(v1::PairsHeader& header);
  void FillChunk(v1::PairsChunk& chunk);
  // A piece of the next path of row_.
  void FillPath(v1::PairPath& path);
  void FillTrailer(v1::PairsTrailer& trailer);

  // Set by Ask, then constant:
  PairCall call_;
  v1::ValueType value_type_ = v1::VALUE_TYPE_FLOAT64;
  double tolerance_ = 0;

  // Guarded by the stream's lock:
  bool has_news_ = false;  // rows may have ended since the last progress
  std::optional<PairOrder> order_;  // once the header was sent
  MatrixRow row_;                   // whose paths are being sent
  uint64_t next_path_ = 0;          // of row_
  uint64_t next_point_ = 0;         // of the path
  double certified_error_ = 0;      // of the rows that were taken
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_STREAMS_PAIR_STREAM_H_
