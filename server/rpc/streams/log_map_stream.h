// One ComputeLogMap call: header, progress, frame, chunks, trailer.

#ifndef GEODESIC_SERVER_RPC_STREAMS_LOG_MAP_STREAM_H_
#define GEODESIC_SERVER_RPC_STREAMS_LOG_MAP_STREAM_H_

#include <cstdint>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/v1/field_service.pb.h"
#include "server/rpc/streams/question_stream.h"

namespace geodesic::server {

class LogMapStream final
    : public FieldQuestionStream<v1::ComputeLogMapRequest,
                                 v1::ComputeLogMapResponse> {
 public:
  using FieldQuestionStream::FieldQuestionStream;

 private:
  absl::Status Translate(FieldRequest& question) override;
  absl::StatusOr<bool> FillPart(v1::ComputeLogMapResponse& message) override;
  uint64_t item_count() const override { return next_vertex_; }

  // Set by Translate, then constant:
  v1::ValueType value_type_ = v1::VALUE_TYPE_FLOAT64;

  // Guarded by the stream's lock:
  bool has_frame_ = false;
  uint64_t next_vertex_ = 0;
  std::vector<double> values_;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_STREAMS_LOG_MAP_STREAM_H_
