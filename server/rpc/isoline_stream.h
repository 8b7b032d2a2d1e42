// One ComputeIsolines call: header, progress, isolines, trailer.

#ifndef GEODESIC_SERVER_RPC_ISOLINE_STREAM_H_
#define GEODESIC_SERVER_RPC_ISOLINE_STREAM_H_

#include <grpcpp/server_context.h>
#include <grpcpp/support/server_callback.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/isolines.h"
#include "geodesic/v1/path_service.pb.h"
#include "server/engine/query_engine.h"
#include "server/rpc/question_stream.h"
#include "server/rpc/request_log.h"

namespace geodesic::server {

class IsolineStream final : public QuestionStream<v1::ComputeIsolinesResponse>,
                            public JobObserver {
 public:
  // REQUIRES: `engine`, `log` and `version` outlive the call; `context` and
  // `request` live until gRPC is done with it.
  static grpc::ServerWriteReactor<v1::ComputeIsolinesResponse>* Start(
      QueryEngine& engine, RequestLog& log, const std::string& version,
      grpc::CallbackServerContext& context,
      const v1::ComputeIsolinesRequest& request);

  void OnProgress(const Progress& progress) override;
  void OnDone(const JobReport& report) override;

 private:
  IsolineStream(QueryEngine& engine, RequestLog& log,
                const std::string& version,
                grpc::CallbackServerContext& context,
                const v1::ComputeIsolinesRequest& request);

  absl::Status Ask() override;
  void Cancel() override;
  absl::StatusOr<bool> FillPart(v1::ComputeIsolinesResponse& message) override;
  uint64_t item_count() const override;

  const grpc::CallbackServerContext& context_;
  const v1::ComputeIsolinesRequest& request_;

  QuestionCall call_;  // set by Ask, then constant
  // The job's until it is done, then guarded by the stream's lock:
  const std::shared_ptr<std::vector<Isoline>> isolines_ =
      std::make_shared<std::vector<Isoline>>();

  // Guarded by the stream's lock:
  uint64_t next_isoline_ = 0;
  uint64_t next_point_ = 0;  // of that isoline
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_ISOLINE_STREAM_H_
