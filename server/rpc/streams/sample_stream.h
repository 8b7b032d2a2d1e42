// One SampleFarthestPoints call: header, progress, samples, trailer.

#ifndef GEODESIC_SERVER_RPC_STREAMS_SAMPLE_STREAM_H_
#define GEODESIC_SERVER_RPC_STREAMS_SAMPLE_STREAM_H_

#include <cstdint>
#include <vector>

#include "absl/status/statusor.h"
#include "geodesic/sampling.h"
#include "geodesic/v1/field_service.pb.h"
#include "server/rpc/streams/question_stream.h"

namespace geodesic::server {

class SampleStream final
    : public JobQuestionStream<v1::SampleFarthestPointsRequest,
                               v1::SampleFarthestPointsResponse,
                               std::vector<FarthestSample>> {
 public:
  using JobQuestionStream::JobQuestionStream;

 private:
  absl::StatusOr<Work> MakeWork() override;
  absl::StatusOr<bool> FillPart(
      v1::SampleFarthestPointsResponse& message) override;
  uint64_t item_count() const override { return next_sample_; }

  // Guarded by the stream's lock:
  uint64_t next_sample_ = 0;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_STREAMS_SAMPLE_STREAM_H_
