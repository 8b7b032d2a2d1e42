#include "rpc_status.h"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"
#include "google/rpc/error_details.pb.h"
#include "google/rpc/status.pb.h"

namespace geodesic::client {
namespace {

// What one detail adds to `status_message`, in words.
std::vector<std::string> Describe(const google::protobuf::Any& detail,
                                  std::string_view status_message) {
  std::vector<std::string> notes;
  google::rpc::BadRequest bad_request;
  google::rpc::RetryInfo retry;
  if (detail.UnpackTo(&bad_request)) {
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
    const double seconds = static_cast<double>(retry.retry_delay().seconds()) +
                           1e-9 * retry.retry_delay().nanos();
    notes.push_back(absl::StrCat("try again in ", seconds, " s"));
  }
  return notes;
}

}  // namespace

absl::Status FromRpcStatus(const grpc::Status& status) {
  if (status.ok()) return absl::OkStatus();
  std::vector<std::string> notes;
  google::rpc::Status rich;
  if (rich.ParseFromString(status.error_details())) {
    for (const google::protobuf::Any& detail : rich.details()) {
      for (std::string& note : Describe(detail, status.error_message())) {
        notes.push_back(std::move(note));
      }
    }
  }
  std::string message = status.error_message();
  if (!notes.empty()) {
    absl::StrAppend(&message, " [", absl::StrJoin(notes, "; "), "]");
  }
  // gRPC's codes and Abseil's are the same numbers.
  return absl::Status(static_cast<absl::StatusCode>(status.error_code()),
                      message);
}

}  // namespace geodesic::client
