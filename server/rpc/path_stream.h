// One ComputePaths call: header, progress, paths in order of target, trailer.

#ifndef GEODESIC_SERVER_RPC_PATH_STREAM_H_
#define GEODESIC_SERVER_RPC_PATH_STREAM_H_

#include <grpcpp/server_context.h>
#include <grpcpp/support/server_callback.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/path.h"
#include "geodesic/v1/path_service.pb.h"
#include "server/engine/query_engine.h"
#include "server/rpc/question_stream.h"
#include "server/rpc/request_log.h"

namespace geodesic::server {

class PathStream final : public QuestionStream<v1::ComputePathsResponse>,
                         public FieldObserver {
 public:
  // REQUIRES: `engine`, `log` and `version` outlive the call; `context` and
  // `request` live until gRPC is done with it.
  static grpc::ServerWriteReactor<v1::ComputePathsResponse>* Start(
      QueryEngine& engine, RequestLog& log, const std::string& version,
      grpc::CallbackServerContext& context,
      const v1::ComputePathsRequest& request);

  void OnProgress(const Progress& progress) override;
  void OnField(const absl::StatusOr<FieldAnswer>& answer) override;

 private:
  PathStream(QueryEngine& engine, RequestLog& log, const std::string& version,
             grpc::CallbackServerContext& context,
             const v1::ComputePathsRequest& request);

  absl::Status Ask() override;
  void Cancel() override;
  absl::StatusOr<bool> FillPart(v1::ComputePathsResponse& message) override;
  uint64_t item_count() const override;
  // Traces the path to the next target. O(edges crossed).
  absl::StatusOr<GeodesicPath> TraceNext();

  const grpc::CallbackServerContext& context_;
  const v1::ComputePathsRequest& request_;

  FieldCall call_;  // set by Ask, then constant

  // Guarded by the stream's lock:
  FieldAnswer answer_;
  uint32_t next_target_ = 0;
  // Of the field's own targets, which are those that are no vertices or all.
  uint32_t next_own_target_ = 0;
  // The path on its way, and how much of it was sent.
  GeodesicPath path_;
  uint64_t next_point_ = 0;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_PATH_STREAM_H_
