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
// brackets.
std::string HostName(std::string_view authority) {
  std::string_view host = authority;
  if (host.starts_with('[')) {
    host = host.substr(1, host.find(']') - 1);
  } else {
    host = host.substr(0, host.rfind(':'));
  }
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
  return IsAddress(name) || name == "localhost" ||
         (!name.empty() && name == name_) ||
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
