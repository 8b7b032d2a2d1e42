// One ComputeField call: accepted, progress, chunks, targets, trailer.

#ifndef GEODESIC_SERVER_RPC_FIELD_STREAM_H_
#define GEODESIC_SERVER_RPC_FIELD_STREAM_H_

#include <grpcpp/server_context.h>
#include <grpcpp/support/server_callback.h>

#include <cstdint>
#include <optional>
#include <string>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/v1/field_service.pb.h"
#include "server/engine/query_engine.h"
#include "server/rpc/answer_stream.h"
#include "server/rpc/field_chunks.h"
#include "server/rpc/request_log.h"

namespace geodesic::server {

// Progress that nobody took is overwritten by newer.
class FieldStream final : public AnswerStream<v1::ComputeFieldResponse>,
                          public FieldObserver {
 public:
  // REQUIRES: `engine`, `log` and `version` outlive the call; `context` and
  // `request` live until gRPC is done with it.
  static grpc::ServerWriteReactor<v1::ComputeFieldResponse>* Start(
      QueryEngine& engine, RequestLog& log, const std::string& version,
      grpc::CallbackServerContext& context,
      const v1::ComputeFieldRequest& request);

  void OnProgress(const Progress& progress) override;
  void OnField(const absl::StatusOr<FieldAnswer>& answer) override;

 private:
  FieldStream(QueryEngine& engine, RequestLog& log, const std::string& version,
              grpc::CallbackServerContext& context,
              const v1::ComputeFieldRequest& request);

  absl::Status Ask() override;
  void Cancel() override;
  absl::StatusOr<NextMessage> Fill(v1::ComputeFieldResponse& message) override;

  // Once the answer is there. Errors: NOT_FOUND, INVALID_ARGUMENT: it cannot be
  // resumed as the client wants.
  absl::Status StartChunks();
  // Names what this request gets: the same name, the same bits.
  std::string MakeFieldId(const FieldAnswer& answer) const;

  // Fills the next message of its kind; false when there is none.
  bool FillSettled(v1::ComputeFieldResponse& message);
  bool FillChunk(v1::ComputeFieldResponse& message);
  bool FillTargets(v1::ComputeFieldResponse& message);

  void FillAccepted(v1::FieldAccepted& accepted) const;
  void FillTrailer(v1::FieldTrailer& trailer) const;

  const std::string& version_;
  const grpc::CallbackServerContext& context_;
  const v1::ComputeFieldRequest& request_;

  // Set by Ask, then constant:
  FieldExtras extras_;
  v1::ValueType value_type_ = v1::VALUE_TYPE_FLOAT64;
  FieldCall call_;

  // Guarded by the stream's lock:
  bool accepted_ = false;
  std::optional<Progress> progress_;  // newer than what was sent
  std::optional<absl::StatusOr<FieldAnswer>> answer_;
  std::optional<FieldChunks> chunks_;  // of *answer_
  std::string field_id_;               // until it is sent
  uint64_t settled_ = 0;               // entries of the log that were sent
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_FIELD_STREAM_H_
