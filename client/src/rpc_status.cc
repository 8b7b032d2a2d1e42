#include "rpc_status.h"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "absl/strings/cord.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"
#include "geodesic_client/errors.h"
#include "google/rpc/error_details.pb.h"
#include "google/rpc/status.pb.h"

namespace geodesic::client {
namespace {

std::chrono::duration<double> Seconds(
    const google::protobuf::Duration& duration) {
  return std::chrono::duration<double>(static_cast<double>(duration.seconds()) +
                                       1e-9 * duration.nanos());
}

// The detail of this type, if there is one.
template <typename Detail>
bool ReadDetail(const absl::Status& status, Detail* detail) {
  const auto payload = status.GetPayload(
      absl::StrCat("type.googleapis.com/", detail->GetTypeName()));
  return payload.has_value() && detail->ParseFromString(std::string(*payload));
}

// What one detail adds to `status_message`, in words.
std::vector<std::string> Describe(const google::protobuf::Any& detail,
                                  std::string_view status_message,
                                  bool name_fields) {
  std::vector<std::string> notes;
  google::rpc::BadRequest bad_request;
  google::rpc::RetryInfo retry;
  if (name_fields && detail.UnpackTo(&bad_request)) {
    for (const auto& violation : bad_request.field_violations()) {
      std::string note = absl::StrCat("field ", violation.field());
      // Servers tend to say the same twice.
      if (status_message.find(violation.description()) ==
          std::string_view::npos) {
        absl::StrAppend(&note, ": ", violation.description());
      }
      notes.push_back(std::move(note));
    }
  } else if (detail.UnpackTo(&retry)) {
    notes.push_back(absl::StrCat("try again in ",
                                 Seconds(retry.retry_delay()).count(), " s"));
  }
  return notes;
}

}  // namespace

absl::Status FromRpcStatus(const grpc::Status& status, std::string_view file) {
  if (status.ok()) return absl::OkStatus();
  std::vector<std::string> notes;
  google::rpc::Status rich;
  // What cannot be read is nothing, not half of it.
  if (!rich.ParseFromString(status.error_details())) rich.Clear();
  for (const google::protobuf::Any& detail : rich.details()) {
    for (std::string& note :
         Describe(detail, status.error_message(), file.empty())) {
      notes.push_back(std::move(note));
    }
  }
  std::string message = status.error_message();
  if (!notes.empty()) {
    absl::StrAppend(&message, " [", absl::StrJoin(notes, "; "), "]");
  }
  // gRPC's codes and Abseil's are the same numbers.
  const auto code = static_cast<absl::StatusCode>(status.error_code());
  if (!file.empty() && (code == absl::StatusCode::kInvalidArgument ||
                        code == absl::StatusCode::kResourceExhausted)) {
    message = absl::StrCat(std::string(file), ": ", message);
  }
  absl::Status result(code, message);
  for (const google::protobuf::Any& detail : rich.details()) {
    result.SetPayload(detail.type_url(), absl::Cord(detail.value()));
  }
  return result;
}

std::string ErrorReason(const absl::Status& status) {
  google::rpc::ErrorInfo info;
  return ReadDetail(status, &info) ? info.reason() : "";
}

std::optional<std::chrono::duration<double>> RetryDelay(
    const absl::Status& status) {
  google::rpc::RetryInfo retry;
  if (!ReadDetail(status, &retry)) return std::nullopt;
  return Seconds(retry.retry_delay());
}

}  // namespace geodesic::client
