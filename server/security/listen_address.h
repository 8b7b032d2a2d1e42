// Whether an address can be reached from other machines.

#ifndef GEODESIC_SERVER_SECURITY_LISTEN_ADDRESS_H_
#define GEODESIC_SERVER_SECURITY_LISTEN_ADDRESS_H_

#include <string_view>

namespace geodesic::server {

// Whether the host of "HOST:PORT" is this machine's alone: 127.0.0.0/8, [::1]
// or localhost. False for what it does not know, such as other names.
bool IsLoopback(std::string_view address);

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_SECURITY_LISTEN_ADDRESS_H_
