#include "server/rpc/calls/call_metadata.h"

#include <algorithm>
#include <random>
#include <string_view>

#include "absl/strings/ascii.h"
#include "absl/strings/str_cat.h"
#include "server/engine/base/error_reasons.h"
#include "server/engine/base/status_details.h"

namespace geodesic::server {
namespace {

constexpr size_t kMaxRequestIdBytes = 64;

// The first value of the header; empty if there is none.
std::string_view Header(const grpc::CallbackServerContext& context,
                        const char* name) {
  const auto& metadata = context.client_metadata();
  const auto it = metadata.find(name);
  if (it == metadata.end()) return {};
  return {it->second.data(), it->second.size()};
}

bool IsLoggable(char c) {
  return absl::ascii_isalnum(static_cast<unsigned char>(c)) || c == '-' ||
         c == '_' || c == '.';
}

}  // namespace

absl::StatusOr<std::string> Authorization(
    const grpc::CallbackServerContext& context) {
  switch (context.client_metadata().count("authorization")) {
    case 0:
      return absl::NotFoundError("there is no authorization");
    case 1:
      return std::string(Header(context, "authorization"));
    default:
      return WithReason(
          absl::UnauthenticatedError("there are several authorizations"),
          reason::kTokenMissing);
  }
}

std::string PeerHost(std::string_view peer) {
  // The colons of an IPv6 address are written otherwise or in brackets.
  const bool has_port = peer.starts_with("ipv4:") || peer.starts_with("ipv6:");
  return std::string(has_port ? peer.substr(0, peer.rfind(':')) : peer);
}

std::string RequestId(const grpc::CallbackServerContext& context) {
  const std::string_view given = Header(context, "x-request-id");
  if (!given.empty() && given.size() <= kMaxRequestIdBytes &&
      std::ranges::all_of(given, IsLoggable)) {
    return std::string(given);
  }
  // Unique enough to find a line in a log.
  thread_local std::mt19937_64 random{std::random_device{}()};
  const uint64_t number = random();
  return absl::StrCat(absl::Hex(number, absl::kZeroPad16));
}

std::string TraceParent(const grpc::CallbackServerContext& context) {
  // version "-" trace id "-" parent id "-" flags
  constexpr size_t kBytes = 2 + 1 + 32 + 1 + 16 + 1 + 2;
  const std::string_view given = Header(context, "traceparent");
  const auto is_dash = [](size_t i) { return i == 2 || i == 35 || i == 52; };
  if (given.size() != kBytes) return "";
  for (size_t i = 0; i < kBytes; ++i) {
    const auto c = static_cast<unsigned char>(given[i]);
    if (is_dash(i) ? c != '-' : !absl::ascii_isxdigit(c)) return "";
  }
  return std::string(given);
}

void AddTrailers(const std::string& request_id, const absl::Status& status,
                 grpc::CallbackServerContext& context) {
  context.AddTrailingMetadata("x-request-id", request_id);
  if (!absl::IsResourceExhausted(status)) return;
  const auto delay = RetryAfter(status);
  context.AddTrailingMetadata(
      "grpc-retry-pushback-ms",
      delay ? absl::StrCat(delay->count()) : std::string("-1"));
}

}  // namespace geodesic::server
