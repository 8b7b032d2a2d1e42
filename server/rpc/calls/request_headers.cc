#include "server/rpc/calls/request_headers.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <random>

#include "absl/strings/ascii.h"
#include "absl/strings/str_cat.h"

namespace geodesic::server {
namespace {

constexpr size_t kMaxRequestIdBytes = 64;

bool IsLoggable(char c) {
  return absl::ascii_isalnum(static_cast<unsigned char>(c)) || c == '-' ||
         c == '_' || c == '.';
}

}  // namespace

std::string_view Header(const grpc::CallbackServerContext& context,
                        const char* name) {
  const auto& metadata = context.client_metadata();
  const auto it = metadata.find(name);
  if (it == metadata.end()) return {};
  return {it->second.data(), it->second.size()};
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

}  // namespace geodesic::server
