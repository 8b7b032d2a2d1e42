// DecimateMesh: header, faces.

#ifndef GEODESIC_SERVER_RPC_STREAMS_DECIMATE_STREAM_H_
#define GEODESIC_SERVER_RPC_STREAMS_DECIMATE_STREAM_H_

#include <cstdint>
#include <optional>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/v1/mesh_service.pb.h"
#include "server/engine/query_engine.h"
#include "server/rpc/calls/answer_stream.h"

namespace geodesic::server {

class DecimateStream final
    : public AnswerStream<v1::DecimateMeshRequest, v1::DecimateMeshResponse> {
 public:
  using AnswerStream::AnswerStream;

 private:
  absl::Status Ask() override;
  void Cancel() override { engine().decimations().Leave(ticket_); }
  absl::StatusOr<NextMessage> Fill(v1::DecimateMeshResponse& message) override;

  // Set by Ask, then constant:
  MeshHandle mesh_;
  DecimationJobs::Ticket ticket_;

  // Guarded by the stream's lock:
  std::optional<absl::StatusOr<DecimationHandle>> made_;
  bool has_header_ = false;
  uint64_t next_face_ = 0;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_STREAMS_DECIMATE_STREAM_H_
