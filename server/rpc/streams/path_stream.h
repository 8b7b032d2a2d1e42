// One ComputePaths call: header, progress, paths in order of target, trailer.

#ifndef GEODESIC_SERVER_RPC_STREAMS_PATH_STREAM_H_
#define GEODESIC_SERVER_RPC_STREAMS_PATH_STREAM_H_

#include <cstdint>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/path.h"
#include "geodesic/v1/path_service.pb.h"
#include "server/rpc/streams/question_stream.h"

namespace geodesic::server {

class PathStream final : public FieldQuestionStream<v1::ComputePathsRequest,
                                                    v1::ComputePathsResponse> {
 public:
  using FieldQuestionStream::FieldQuestionStream;

 private:
  absl::Status Translate(FieldRequest& question) override;
  absl::StatusOr<bool> FillPart(v1::ComputePathsResponse& message) override;
  uint64_t item_count() const override { return next_target_; }
  // Traces the path to the next target. O(edges crossed).
  absl::StatusOr<GeodesicPath> TraceNext();

  // Guarded by the stream's lock:
  uint32_t next_target_ = 0;
  // Of the field's own targets, which are those that are no vertices or all.
  uint32_t next_own_target_ = 0;
  // The path on its way, and how much of it was sent.
  GeodesicPath path_;
  uint64_t next_point_ = 0;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_STREAMS_PATH_STREAM_H_
