#include "server/web/origin_policy.h"

#include <arpa/inet.h>

#include <algorithm>
#include <array>
#include <utility>

#include "absl/strings/ascii.h"

namespace geodesic::server {
namespace {

constexpr std::string_view kSchemes[] = {"http://", "https://"};

// HOST of "HOST:PORT", "HOST" or "[HOST]:PORT", in small letters and without
// brackets; empty if it is none of these.
std::string HostName(std::string_view authority) {
  std::string_view host = authority, port;
  if (host.starts_with('[')) {
    const size_t end = host.find(']');
    if (end == host.npos) return "";
    port = host.substr(end + 1);
    host = host.substr(1, end - 1);
  } else if (const size_t end = host.find(':'); end != host.npos) {
    port = host.substr(end);
    host = host.substr(0, end);
  }
  const bool has_port =
      port.starts_with(':') &&
      std::ranges::all_of(port.substr(1), absl::ascii_isdigit);
  if (!port.empty() && !has_port) return "";
  return absl::AsciiStrToLower(std::string(host));
}

bool IsAddress(const std::string& host) {
  std::array<unsigned char, sizeof(in6_addr)> bytes = {};
  return inet_pton(AF_INET, host.c_str(), bytes.data()) == 1 ||
         inet_pton(AF_INET6, host.c_str(), bytes.data()) == 1;
}

// What follows the scheme of an origin; empty if it has none.
std::string_view Authority(std::string_view origin) {
  for (const std::string_view scheme : kSchemes) {
    if (origin.starts_with(scheme)) return origin.substr(scheme.size());
  }
  return {};
}

}  // namespace

OriginPolicy::OriginPolicy(std::string_view listen, bool over_tls,
                           std::vector<std::string> origins)
    : name_(HostName(listen)),
      scheme_(over_tls ? "https://" : "http://"),
      origins_(std::move(origins)) {}

bool OriginPolicy::IsHost(std::string_view host) const {
  const std::string name = HostName(host);
  if (name.empty()) return false;
  return IsAddress(name) || name == "localhost" || name == name_ ||
         std::ranges::any_of(origins_, [&](const std::string& origin) {
           return HostName(Authority(origin)) == name;
         });
}

bool OriginPolicy::IsOwn(std::string_view origin, std::string_view host) const {
  return !host.empty() && origin.starts_with(scheme_) &&
         origin.substr(scheme_.size()) == host;
}

bool OriginPolicy::IsAllowed(std::string_view origin) const {
  return std::ranges::find(origins_, origin) != origins_.end();
}

bool IsOrigin(std::string_view text) {
  const std::string_view authority = Authority(text);
  return !authority.empty() &&
         authority.find_first_of("/?#@ ") == std::string_view::npos;
}

}  // namespace geodesic::server
