// One ComputeLogMap call: header, progress, frame, chunks, trailer.

#ifndef GEODESIC_SERVER_RPC_LOG_MAP_STREAM_H_
#define GEODESIC_SERVER_RPC_LOG_MAP_STREAM_H_

#include <grpcpp/server_context.h>
#include <grpcpp/support/server_callback.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/v1/field_service.pb.h"
#include "server/engine/query_engine.h"
#include "server/rpc/question_stream.h"
#include "server/rpc/request_log.h"

namespace geodesic::server {

class LogMapStream final : public QuestionStream<v1::ComputeLogMapResponse>,
                           public FieldObserver {
 public:
  // REQUIRES: `engine`, `log` and `version` outlive the call; `context` and
  // `request` live until gRPC is done with it.
  static grpc::ServerWriteReactor<v1::ComputeLogMapResponse>* Start(
      QueryEngine& engine, RequestLog& log, const std::string& version,
      grpc::CallbackServerContext& context,
      const v1::ComputeLogMapRequest& request);

  void OnProgress(const Progress& progress) override;
  void OnField(const absl::StatusOr<FieldAnswer>& answer) override;

 private:
  LogMapStream(QueryEngine& engine, RequestLog& log, const std::string& version,
               grpc::CallbackServerContext& context,
               const v1::ComputeLogMapRequest& request);

  absl::Status Ask() override;
  void Cancel() override;
  absl::StatusOr<bool> FillPart(v1::ComputeLogMapResponse& message) override;
  uint64_t item_count() const override;

  const grpc::CallbackServerContext& context_;
  const v1::ComputeLogMapRequest& request_;

  // Set by Ask, then constant:
  v1::ValueType value_type_ = v1::VALUE_TYPE_FLOAT64;
  FieldCall call_;

  // Guarded by the stream's lock:
  FieldAnswer answer_;
  bool has_frame_ = false;
  uint64_t next_vertex_ = 0;
  std::vector<double> values_;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_LOG_MAP_STREAM_H_
