#include "server/rpc/messages/grpc_status.h"

#include <google/rpc/error_details.pb.h>
#include <google/rpc/status.pb.h>

#include <string>

#include "geodesic_types/field_path.h"
#include "server/engine/base/status_details.h"

namespace geodesic::server {

grpc::Status ToGrpcStatus(const absl::Status& status) {
  if (status.ok()) return grpc::Status::OK;
  // absl and gRPC number the codes alike.
  const auto code = static_cast<grpc::StatusCode>(status.code());
  const std::string message = PrintableMessage(status);

  google::rpc::Status details;
  google::rpc::ErrorInfo info;
  info.set_reason(ReasonOf(status));
  info.set_domain("geodesic.v1");
  details.add_details()->PackFrom(info);
  if (const auto field = FieldPathOf(status)) {
    google::rpc::BadRequest bad_request;
    auto& violation = *bad_request.add_field_violations();
    violation.set_field(*field);
    violation.set_description(message);
    details.add_details()->PackFrom(bad_request);
  }
  if (const auto digest = MeshAtFault(status)) {
    google::rpc::ResourceInfo resource;
    resource.set_resource_type("geodesic.v1.Mesh");
    resource.set_resource_name(*digest);
    resource.set_description(message);
    details.add_details()->PackFrom(resource);
  }
  if (const auto subject = QuotaSubject(status)) {
    google::rpc::QuotaFailure quota;
    quota.add_violations()->set_subject(*subject);
    quota.mutable_violations(0)->set_description(message);
    details.add_details()->PackFrom(quota);
  }
  if (const auto delay = RetryAfter(status)) {
    google::rpc::RetryInfo retry;
    retry.mutable_retry_delay()->set_seconds(delay->count() / 1000);
    retry.mutable_retry_delay()->set_nanos(
        static_cast<int32_t>(delay->count() % 1000 * 1'000'000));
    details.add_details()->PackFrom(retry);
  }
  details.set_code(code);
  details.set_message(message);
  return grpc::Status(code, message, details.SerializeAsString());
}

}  // namespace geodesic::server
