// The unary RPCs.

#ifndef GEODESIC_SERVER_RPC_UNARY_CALLS_H_
#define GEODESIC_SERVER_RPC_UNARY_CALLS_H_

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/v1/capabilities_service.pb.h"
#include "geodesic/v1/mesh_service.pb.h"
#include "server/engine/base/limits.h"
#include "server/engine/base/status_details.h"
#include "server/rpc/calls/one_request_call.h"
#include "server/rpc/calls/request_log.h"

namespace geodesic::server {

// A derived class implements Ask, which must be short, and calls Answer at the
// end.
template <typename Request, typename Response>
class UnaryCall : public OneRequestCall<Request, Response> {
 public:
  using OneRequestCall<Request, Response>::OneRequestCall;

 protected:
  using OneRequestCall<Request, Response>::mutex_;

  // Call at most once, and not if Ask fails.
  void Answer(absl::StatusOr<Response> response) {
    MutexLock lock(mutex_);
    response_ = std::move(response);
    this->Advance();
  }

 private:
  // A unary call does not count against the bound on streams.
  absl::Status Admit(RequestLog::Entry& entry) final { return entry.Admit(); }

  absl::StatusOr<NextMessage> Fill(Response& message) final
      ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    if (!response_.has_value()) return NextMessage::kWait;
    if (!response_->ok()) return response_->status();
    message = **std::move(response_);
    return NextMessage::kSendLast;
  }

  std::optional<absl::StatusOr<Response>> response_ ABSL_GUARDED_BY(mutex_);
};

// Answers that need no job. Errors: as QueryEngine.
absl::StatusOr<v1::FindMissingMeshesResponse> AnswerOf(
    const ServiceContext& service, const v1::FindMissingMeshesRequest& request);
absl::StatusOr<v1::GetMeshResponse> AnswerOf(const ServiceContext& service,
                                             const v1::GetMeshRequest& request);
absl::StatusOr<v1::ListMeshesResponse> AnswerOf(
    const ServiceContext& service, const v1::ListMeshesRequest& request);
inline absl::StatusOr<v1::GetCapabilitiesResponse> AnswerOf(
    const ServiceContext& service, const v1::GetCapabilitiesRequest&) {
  if (service.engine.scheduler().is_draining()) return ShuttingDown();
  return service.capabilities;
}

template <typename Request, typename Response>
class ShortCall final : public UnaryCall<Request, Response> {
 public:
  using UnaryCall<Request, Response>::UnaryCall;

 private:
  absl::Status Ask() override {
    absl::StatusOr<Response> response =
        AnswerOf(this->service_, this->request());
    if (!response.ok()) return response.status();
    this->Answer(std::move(response));
    return absl::OkStatus();
  }
};

using FindMissingCall =
    ShortCall<v1::FindMissingMeshesRequest, v1::FindMissingMeshesResponse>;
using GetMeshCall = ShortCall<v1::GetMeshRequest, v1::GetMeshResponse>;
using ListMeshesCall = ShortCall<v1::ListMeshesRequest, v1::ListMeshesResponse>;
using CapabilitiesCall =
    ShortCall<v1::GetCapabilitiesRequest, v1::GetCapabilitiesResponse>;

// Answers when the mesh is gone from memory and disk.
class DeleteMeshCall final
    : public UnaryCall<v1::DeleteMeshRequest, v1::DeleteMeshResponse> {
 public:
  using UnaryCall::UnaryCall;

 private:
  absl::Status Ask() override;
};

// What GetCapabilities answers.
v1::GetCapabilitiesResponse MakeCapabilities(const Limits& limits,
                                             uint64_t max_message_bytes,
                                             const std::string& version);

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_UNARY_CALLS_H_
