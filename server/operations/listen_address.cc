#include "server/operations/listen_address.h"

namespace geodesic::server {

std::unique_ptr<addrinfo, decltype(&freeaddrinfo)> ResolveListenAddress(
    const std::string& address) {
  const size_t colon = address.rfind(':');
  addrinfo* found = nullptr;
  if (colon != std::string::npos) {
    std::string host = address.substr(0, colon);
    if (host.starts_with('[') && host.ends_with(']')) {
      host = host.substr(1, host.size() - 2);
    }
    const addrinfo hints = {.ai_flags = AI_PASSIVE | AI_NUMERICSERV,
                            .ai_socktype = SOCK_STREAM};
    if (getaddrinfo(host.empty() ? nullptr : host.c_str(),
                    address.c_str() + colon + 1, &hints, &found) != 0) {
      found = nullptr;
    }
  }
  return {found, &freeaddrinfo};
}

}  // namespace geodesic::server
