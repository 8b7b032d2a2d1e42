#include "server/engine/status_details.h"

#include <algorithm>
#include <cstdint>

#include "absl/strings/ascii.h"
#include "absl/strings/cord.h"
#include "absl/strings/escaping.h"
#include "absl/strings/numbers.h"
#include "absl/strings/str_cat.h"

namespace geodesic::server {
namespace {

constexpr char kFieldUrl[] = "geodesic/field-at-fault";
constexpr char kRetryUrl[] = "geodesic/retry-after-ms";

absl::string_view ToAbsl(std::string_view text) {
  return {text.data(), text.size()};
}

}  // namespace

absl::Status WithField(absl::Status status, std::string_view field) {
  status.SetPayload(kFieldUrl, absl::Cord(ToAbsl(field)));
  return status;
}

absl::Status InvalidField(std::string_view field, std::string_view message) {
  return WithField(absl::InvalidArgumentError(ToAbsl(message)), field);
}

std::optional<std::string> FieldAtFault(const absl::Status& status) {
  const auto payload = status.GetPayload(kFieldUrl);
  if (!payload) return std::nullopt;
  return std::string(*payload);
}

absl::Status WithRetryAfter(absl::Status status,
                            std::chrono::milliseconds delay) {
  status.SetPayload(kRetryUrl, absl::Cord(absl::StrCat(delay.count())));
  return status;
}

std::optional<std::chrono::milliseconds> RetryAfter(
    const absl::Status& status) {
  const auto payload = status.GetPayload(kRetryUrl);
  int64_t count = 0;
  if (!payload || !absl::SimpleAtoi(std::string(*payload), &count)) {
    return std::nullopt;
  }
  return std::chrono::milliseconds(count);
}

std::string PrintableMessage(const absl::Status& status) {
  const absl::string_view message = status.message();
  const bool printable =
      std::all_of(message.begin(), message.end(),
                  [](char c) { return absl::ascii_isprint(c); });
  return printable ? std::string(message) : absl::CHexEscape(message);
}

}  // namespace geodesic::server
