// PrepareMethod: header, progress, trailer.

#ifndef GEODESIC_SERVER_RPC_STREAMS_PREPARE_STREAM_H_
#define GEODESIC_SERVER_RPC_STREAMS_PREPARE_STREAM_H_

#include <optional>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/v1/method_service.pb.h"
#include "server/engine/query_engine.h"
#include "server/rpc/calls/answer_stream.h"

namespace geodesic::server {

class PrepareStream final
    : public AnswerStream<v1::PrepareMethodRequest, v1::PrepareMethodResponse> {
 public:
  using AnswerStream::AnswerStream;

 private:
  absl::Status Ask() override;
  void Cancel() override { engine().methods().Leave(ticket_); }
  absl::StatusOr<NextMessage> Fill(v1::PrepareMethodResponse& message) override;

  // Set by Ask, then constant:
  MeshHandle mesh_;
  AlgorithmChoice choice_ = kDefaultAlgorithm;
  bool was_prepared_ = false;
  MethodJobs::Ticket ticket_;

  // Guarded by the stream's lock:
  bool has_header_ = false;
  std::optional<v1::SolveProgress> progress_;  // newer than what was sent
  std::optional<absl::StatusOr<Prepared>> prepared_;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_STREAMS_PREPARE_STREAM_H_
