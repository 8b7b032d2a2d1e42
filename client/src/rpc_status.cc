#include "rpc_status.h"

#include <google/protobuf/unknown_field_set.h>

#include <string>
#include <string_view>
#include <vector>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"

namespace geodesic::client {
namespace {

using google::protobuf::UnknownField;
using google::protobuf::UnknownFieldSet;

// google/rpc/*.proto have no C++ package here. The four messages are small and
// frozen, so their fields are picked by number instead of compiling them into
// every program that links this library.
constexpr int kStatusDetails = 3;         // google.rpc.Status.details
constexpr int kAnyTypeUrl = 1;            // google.protobuf.Any.type_url
constexpr int kAnyValue = 2;              // google.protobuf.Any.value
constexpr int kFieldViolations = 1;       // google.rpc.BadRequest
constexpr int kViolationField = 1;        // ... FieldViolation.field
constexpr int kViolationDescription = 2;  // ... FieldViolation.description
constexpr int kRetryDelay = 1;            // google.rpc.RetryInfo.retry_delay
constexpr int kDurationSeconds = 1;       // google.protobuf.Duration
constexpr int kDurationNanos = 2;

std::vector<std::string> Texts(const UnknownFieldSet& message, int number) {
  std::vector<std::string> texts;
  for (int i = 0; i < message.field_count(); ++i) {
    const UnknownField& field = message.field(i);
    if (field.number() == number &&
        field.type() == UnknownField::TYPE_LENGTH_DELIMITED) {
      texts.push_back(field.length_delimited());
    }
  }
  return texts;
}

std::string Text(const UnknownFieldSet& message, int number) {
  std::vector<std::string> texts = Texts(message, number);
  return texts.empty() ? std::string() : texts.back();
}

double Number(const UnknownFieldSet& message, int number) {
  for (int i = 0; i < message.field_count(); ++i) {
    const UnknownField& field = message.field(i);
    if (field.number() == number && field.type() == UnknownField::TYPE_VARINT) {
      return static_cast<double>(static_cast<int64_t>(field.varint()));
    }
  }
  return 0;
}

// What one detail adds to `status_message`, in words.
std::vector<std::string> Describe(const std::string& any_bytes,
                                  std::string_view status_message) {
  std::vector<std::string> notes;
  UnknownFieldSet any, value;
  if (!any.ParseFromString(any_bytes) ||
      !value.ParseFromString(Text(any, kAnyValue))) {
    return notes;
  }
  const std::string type = Text(any, kAnyTypeUrl);
  if (type.ends_with("/google.rpc.BadRequest")) {
    for (const std::string& bytes : Texts(value, kFieldViolations)) {
      UnknownFieldSet violation;
      if (!violation.ParseFromString(bytes)) continue;
      std::string note =
          absl::StrCat("field ", Text(violation, kViolationField));
      const std::string description = Text(violation, kViolationDescription);
      // Servers tend to say the same twice.
      if (status_message.find(description) == std::string_view::npos) {
        absl::StrAppend(&note, ": ", description);
      }
      notes.push_back(std::move(note));
    }
  } else if (type.ends_with("/google.rpc.RetryInfo")) {
    UnknownFieldSet delay;
    if (delay.ParseFromString(Text(value, kRetryDelay))) {
      const double seconds = Number(delay, kDurationSeconds) +
                             1e-9 * Number(delay, kDurationNanos);
      notes.push_back(absl::StrCat("try again in ", seconds, " s"));
    }
  }
  return notes;
}

}  // namespace

absl::Status FromRpcStatus(const grpc::Status& status) {
  if (status.ok()) return absl::OkStatus();
  std::vector<std::string> notes;
  UnknownFieldSet rich;
  if (rich.ParseFromString(status.error_details())) {
    for (const std::string& any : Texts(rich, kStatusDetails)) {
      for (std::string& note : Describe(any, status.error_message())) {
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
