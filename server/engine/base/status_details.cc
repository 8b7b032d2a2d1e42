#include "server/engine/base/status_details.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "absl/strings/ascii.h"
#include "absl/strings/cord.h"
#include "absl/strings/escaping.h"
#include "absl/strings/numbers.h"
#include "absl/strings/str_cat.h"

namespace geodesic::server {
namespace {

constexpr char kRetryUrl[] = "geodesic/retry-after-ms";
constexpr char kReasonUrl[] = "geodesic/reason";
constexpr char kQuotaUrl[] = "geodesic/quota-subject";
constexpr char kMeshUrl[] = "geodesic/mesh";

absl::Status WithText(absl::Status status, const char* url,
                      std::string_view text) {
  status.SetPayload(url,
                    absl::Cord(absl::string_view(text.data(), text.size())));
  return status;
}

std::optional<std::string> TextOf(const absl::Status& status, const char* url) {
  const auto payload = status.GetPayload(url);
  if (!payload) return std::nullopt;
  return std::string(*payload);
}

}  // namespace

absl::Status WithRetryAfter(absl::Status status,
                            std::chrono::milliseconds delay) {
  status.SetPayload(kRetryUrl, absl::Cord(absl::StrCat(delay.count())));
  return status;
}

std::optional<std::chrono::milliseconds> RetryAfter(
    const absl::Status& status) {
  const auto text = TextOf(status, kRetryUrl);
  int64_t count = 0;
  if (!text || !absl::SimpleAtoi(*text, &count)) return std::nullopt;
  return std::chrono::milliseconds(count);
}

absl::Status WithReason(absl::Status status, std::string_view reason) {
  return WithText(std::move(status), kReasonUrl, reason);
}

std::string ReasonOf(const absl::Status& status) {
  if (auto given = TextOf(status, kReasonUrl)) return *std::move(given);
  switch (status.code()) {
    case absl::StatusCode::kInvalidArgument:
      return std::string(reason::kInvalidRequest);
    case absl::StatusCode::kNotFound:
      return std::string(reason::kMeshNotResident);
    case absl::StatusCode::kResourceExhausted:
      return std::string(RetryAfter(status) ? reason::kServerFull
                                            : reason::kLimitExceeded);
    default:
      return absl::StatusCodeToString(status.code());
  }
}

absl::Status WithQuotaFailure(absl::Status status, std::string_view subject) {
  return WithReason(WithText(std::move(status), kQuotaUrl, subject),
                    reason::kQuotaExceeded);
}

std::optional<std::string> QuotaSubject(const absl::Status& status) {
  return TextOf(status, kQuotaUrl);
}

absl::Status WithMesh(absl::Status status, std::string_view digest) {
  return WithText(std::move(status), kMeshUrl, digest);
}

std::optional<std::string> MeshAtFault(const absl::Status& status) {
  return TextOf(status, kMeshUrl);
}

absl::Status ShuttingDown() {
  return WithReason(absl::UnavailableError("the server is shutting down"),
                    reason::kShuttingDown);
}

std::string PrintableMessage(const absl::Status& status) {
  const absl::string_view message = status.message();
  const bool printable =
      std::all_of(message.begin(), message.end(),
                  [](char c) { return absl::ascii_isprint(c); });
  return printable ? std::string(message) : absl::CHexEscape(message);
}

}  // namespace geodesic::server
