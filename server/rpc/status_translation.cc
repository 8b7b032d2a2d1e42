#include "server/rpc/status_translation.h"

#include <google/rpc/error_details.pb.h>
#include <google/rpc/status.pb.h>

#include <string>

#include "server/engine/status_details.h"

namespace geodesic::server {

grpc::Status ToGrpcStatus(const absl::Status& status) {
  if (status.ok()) return grpc::Status::OK;
  // absl and gRPC number the codes alike.
  const auto code = static_cast<grpc::StatusCode>(status.code());
  const std::string message = PrintableMessage(status);

  google::rpc::Status details;
  if (const auto field = FieldAtFault(status)) {
    google::rpc::BadRequest bad_request;
    auto& violation = *bad_request.add_field_violations();
    violation.set_field(*field);
    violation.set_description(message);
    details.add_details()->PackFrom(bad_request);
  }
  if (const auto delay = RetryAfter(status)) {
    google::rpc::RetryInfo retry;
    retry.mutable_retry_delay()->set_seconds(delay->count() / 1000);
    retry.mutable_retry_delay()->set_nanos(
        static_cast<int32_t>(delay->count() % 1000 * 1'000'000));
    details.add_details()->PackFrom(retry);
  }
  if (details.details().empty()) return grpc::Status(code, message);
  details.set_code(code);
  details.set_message(message);
  return grpc::Status(code, message, details.SerializeAsString());
}

}  // namespace geodesic::server
