#include "rpc_status.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "absl/strings/cord.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"
#include "absl/strings/str_replace.h"
#include "geodesic_client/errors.h"
#include "google/rpc/error_details.pb.h"
#include "google/rpc/status.pb.h"

namespace geodesic::client {
namespace {

using Seconds = std::chrono::duration<double>;

// Whether a stream ended without a status: so balancers pass on that the server
// behind them is gone. HAProxy ends the connection, nginx resets the stream.
bool IsBroken(const grpc::Status& status) {
  switch (status.error_code()) {
    case grpc::StatusCode::UNKNOWN:
      return status.error_message() == "Stream removed";
    case grpc::StatusCode::INTERNAL:
      return status.error_message() == "Received RST_STREAM with error code 2";
    default:
      return false;
  }
}

Seconds ToSeconds(const google::protobuf::Duration& duration) {
  return Seconds(static_cast<double>(duration.seconds()) +
                 1e-9 * duration.nanos());
}

// Reads the detail of this type. Returns false if there is none.
template <typename Detail>
bool ReadDetail(const absl::Status& status, Detail* detail) {
  const auto payload = status.GetPayload(
      absl::StrCat("type.googleapis.com/", detail->GetTypeName()));
  return payload.has_value() && detail->ParseFromString(std::string(*payload));
}

// Adds to `notes`, in words, what `detail` says beyond `message`.
void Describe(const google::protobuf::Any& detail, std::string_view message,
              bool name_fields, std::vector<std::string>* notes) {
  google::rpc::BadRequest bad_request;
  google::rpc::RetryInfo retry;
  if (name_fields && detail.UnpackTo(&bad_request)) {
    for (const auto& violation : bad_request.field_violations()) {
      notes->push_back(absl::StrCat("field ", violation.field()));
      // The message often holds the description already.
      if (message.find(violation.description()) == std::string_view::npos) {
        absl::StrAppend(&notes->back(), ": ", violation.description());
      }
    }
  } else if (detail.UnpackTo(&retry)) {
    notes->push_back(absl::StrCat(
        "try again in ", ToSeconds(retry.retry_delay()).count(), " s"));
  }
}

}  // namespace

absl::Status FromRpcStatus(const grpc::Status& status, std::string_view file) {
  if (status.ok()) return absl::OkStatus();
  std::vector<std::string> notes;
  google::rpc::Status rich;
  // A failed parse may leave half of the details.
  if (!rich.ParseFromString(status.error_details())) rich.Clear();
  for (const google::protobuf::Any& detail : rich.details()) {
    Describe(detail, status.error_message(), file.empty(), &notes);
  }
  std::string message = status.error_message();
  if (!notes.empty()) {
    absl::StrAppend(&message, " [", absl::StrJoin(notes, "; "), "]");
  }
  // gRPC's codes and Abseil's are the same numbers.
  auto code = static_cast<absl::StatusCode>(status.error_code());
  if (IsBroken(status)) {
    code = absl::StatusCode::kUnavailable;
    message = "the connection broke within the answer";
  }
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

std::string ErrorField(const absl::Status& status) {
  google::rpc::BadRequest bad_request;
  return ReadDetail(status, &bad_request) &&
                 bad_request.field_violations_size() > 0
             ? bad_request.field_violations(0).field()
             : "";
}

absl::Status RenameField(const absl::Status& status, const std::string& from,
                         const std::string& to) {
  const auto renamed = [&](const std::string& text) {
    return absl::StrReplaceAll(text, {{from, to}});
  };
  absl::Status result(status.code(), renamed(std::string(status.message())));
  status.ForEachPayload([&](absl::string_view name, const absl::Cord& payload) {
    result.SetPayload(name, payload);
  });
  google::rpc::BadRequest bad_request;
  if (!ReadDetail(status, &bad_request)) return result;
  for (auto& violation : *bad_request.mutable_field_violations()) {
    violation.set_field(renamed(violation.field()));
    violation.set_description(renamed(violation.description()));
  }
  result.SetPayload(
      absl::StrCat("type.googleapis.com/", bad_request.GetTypeName()),
      absl::Cord(bad_request.SerializeAsString()));
  return result;
}

std::optional<Seconds> RetryDelay(const absl::Status& status) {
  google::rpc::RetryInfo retry;
  if (!ReadDetail(status, &retry)) return std::nullopt;
  return ToSeconds(retry.retry_delay());
}

std::chrono::duration<double> DelayBeforeRetry(const absl::Status& status,
                                               int attempts) {
  constexpr Seconds kFirstDelay(0.2);
  constexpr Seconds kLongestDelay(10);
  const Seconds delay =
      RetryDelay(status).value_or(kFirstDelay * (1 << (attempts - 1)));
  thread_local std::minstd_rand random{std::random_device{}()};
  return std::min(delay * std::uniform_real_distribution<>(1, 1.3)(random),
                  kLongestDelay);
}

bool WaitToRetry(const absl::Status& status, int attempts,
                 std::stop_token stop) {
  if (attempts >= kMaxAttempts) return false;
  if (!absl::IsUnavailable(status) && !RetryDelay(status).has_value()) {
    return false;
  }
  const Seconds delay = DelayBeforeRetry(status, attempts);
  std::mutex mutex;
  std::condition_variable_any stopped;
  std::unique_lock lock(mutex);
  stopped.wait_for(lock, stop, delay, [] { return false; });
  return !stop.stop_requested();
}

}  // namespace geodesic::client
