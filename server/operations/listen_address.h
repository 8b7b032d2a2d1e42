// Addresses that HTTP is served on.

#ifndef GEODESIC_SERVER_OPERATIONS_LISTEN_ADDRESS_H_
#define GEODESIC_SERVER_OPERATIONS_LISTEN_ADDRESS_H_

#include <netdb.h>

#include <memory>
#include <string>

namespace geodesic::server {

// Resolves "HOST:PORT" or "[HOST]:PORT" by getaddrinfo; null if it cannot. No
// host stands for all addresses of this machine.
std::unique_ptr<addrinfo, decltype(&freeaddrinfo)> ResolveListenAddress(
    const std::string& address);

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_OPERATIONS_LISTEN_ADDRESS_H_
