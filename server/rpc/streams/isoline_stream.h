// One ComputeIsolines call: header, progress, isolines, trailer.

#ifndef GEODESIC_SERVER_RPC_STREAMS_ISOLINE_STREAM_H_
#define GEODESIC_SERVER_RPC_STREAMS_ISOLINE_STREAM_H_

#include <cstdint>
#include <vector>

#include "absl/status/statusor.h"
#include "geodesic/isolines.h"
#include "geodesic/v1/path_service.pb.h"
#include "server/rpc/streams/question_stream.h"

namespace geodesic::server {

class IsolineStream final
    : public JobQuestionStream<v1::ComputeIsolinesRequest,
                               v1::ComputeIsolinesResponse,
                               std::vector<Isoline>> {
 public:
  using JobQuestionStream::JobQuestionStream;

 private:
  absl::StatusOr<Work> MakeWork() override;
  absl::StatusOr<bool> FillPart(v1::ComputeIsolinesResponse& message) override;
  uint64_t item_count() const override { return next_isoline_; }

  // Guarded by the stream's lock:
  uint64_t next_isoline_ = 0;
  uint64_t next_point_ = 0;  // of that isoline
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_STREAMS_ISOLINE_STREAM_H_
