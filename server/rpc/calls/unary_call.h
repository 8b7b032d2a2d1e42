// What the unary RPCs share.

#ifndef GEODESIC_SERVER_RPC_CALLS_UNARY_CALL_H_
#define GEODESIC_SERVER_RPC_CALLS_UNARY_CALL_H_

#include <optional>
#include <utility>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "server/rpc/calls/answer_stream.h"
#include "server/rpc/calls/request_log.h"

namespace geodesic::server {

// A derived class says what Ask does, which must be short, and that it is done
// by Answer.
template <typename Request, typename Response>
class UnaryCall : public AnswerStream<Request, Response> {
 public:
  using AnswerStream<Request, Response>::AnswerStream;

 protected:
  // Call once at most: not when Ask fails.
  void Answer(absl::StatusOr<Response> response) {
    this->Update([&] { response_ = std::move(response); });
  }

  void Cancel() override {}

 private:
  // Not a stream, of which there may not be too many.
  absl::Status Admit(RequestLog::Entry& entry) final { return entry.Admit(); }

  absl::StatusOr<NextMessage> Fill(Response& message) final {
    if (!response_.has_value()) return NextMessage::kWait;
    if (!response_->ok()) return response_->status();
    message = **std::move(response_);
    return NextMessage::kSendLast;
  }

  std::optional<absl::StatusOr<Response>> response_;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_CALLS_UNARY_CALL_H_
