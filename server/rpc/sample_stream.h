// One SampleFarthestPoints call: header, progress, samples, trailer.

#ifndef GEODESIC_SERVER_RPC_SAMPLE_STREAM_H_
#define GEODESIC_SERVER_RPC_SAMPLE_STREAM_H_

#include <grpcpp/server_context.h>
#include <grpcpp/support/server_callback.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/sampling.h"
#include "geodesic/v1/field_service.pb.h"
#include "server/engine/query_engine.h"
#include "server/rpc/question_stream.h"
#include "server/rpc/request_log.h"

namespace geodesic::server {

class SampleStream final
    : public QuestionStream<v1::SampleFarthestPointsResponse>,
      public JobObserver {
 public:
  // REQUIRES: `engine`, `log` and `version` outlive the call; `context` and
  // `request` live until gRPC is done with it.
  static grpc::ServerWriteReactor<v1::SampleFarthestPointsResponse>* Start(
      QueryEngine& engine, RequestLog& log, const std::string& version,
      grpc::CallbackServerContext& context,
      const v1::SampleFarthestPointsRequest& request);

  void OnProgress(const Progress& progress) override;
  void OnDone(const JobReport& report) override;

 private:
  SampleStream(QueryEngine& engine, RequestLog& log, const std::string& version,
               grpc::CallbackServerContext& context,
               const v1::SampleFarthestPointsRequest& request);

  absl::Status Ask() override;
  void Cancel() override;
  absl::StatusOr<bool> FillPart(
      v1::SampleFarthestPointsResponse& message) override;
  uint64_t item_count() const override;

  const grpc::CallbackServerContext& context_;
  const v1::SampleFarthestPointsRequest& request_;

  QuestionCall call_;  // set by Ask, then constant
  // The job's until it is done, then guarded by the stream's lock:
  const std::shared_ptr<std::vector<FarthestSample>> samples_ =
      std::make_shared<std::vector<FarthestSample>>();

  // Guarded by the stream's lock:
  uint64_t next_sample_ = 0;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_SAMPLE_STREAM_H_
