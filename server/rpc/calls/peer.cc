#include "server/rpc/calls/peer.h"

#include <openssl/crypto.h>

#include <random>

#include "absl/strings/str_cat.h"

namespace geodesic::server {
namespace {

constexpr char kMetadata[] = "geodesicd-door-peer";

std::string DrawSecret() {
  std::random_device random;
  std::string secret;
  for (int i = 0; i < 4; ++i) {
    absl::StrAppend(&secret, absl::Hex(random(), absl::kZeroPad8));
  }
  return secret;
}

}  // namespace

std::string PeerHost(std::string_view address) {
  // The colons of an IPv6 address are escaped or in brackets.
  const bool has_port =
      address.starts_with("ipv4:") || address.starts_with("ipv6:");
  return std::string(has_port ? address.substr(0, address.rfind(':'))
                              : address);
}

Peers::Peers() : secret_(DrawSecret()) {}

void Peers::Name(const std::string& address,
                 grpc::ClientContext& context) const {
  context.AddMetadata(kMetadata, secret_ + address);
}

Peer Peers::Of(const grpc::CallbackServerContext& context) const {
  const auto [begin, end] = context.client_metadata().equal_range(kMetadata);
  for (auto it = begin; it != end; ++it) {
    const std::string_view value(it->second.data(), it->second.size());
    if (value.size() > secret_.size() &&
        CRYPTO_memcmp(value.data(), secret_.data(), secret_.size()) == 0) {
      return {.address = std::string(value.substr(secret_.size())),
              .by_door = true};
    }
  }
  return {.address = context.peer()};
}

}  // namespace geodesic::server
