// Who calls, as far as the server knows.

#ifndef GEODESIC_SERVER_SECURITY_CALLER_H_
#define GEODESIC_SERVER_SECURITY_CALLER_H_

#include <cstdint>
#include <limits>
#include <string>

#include "server/security/scope.h"

namespace geodesic::server {

// What one client may take of the server. DEFAULT: whatever there is.
struct Quota {
  // Memory of resident meshes that it uploaded.
  uint64_t resident_bytes = std::numeric_limits<uint64_t>::max();
  // Streams under way: uploads, computations, meshes being read.
  uint64_t jobs = std::numeric_limits<uint64_t>::max();
  // Requests of any kind, on average and all at once.
  double requests_per_second = std::numeric_limits<double>::infinity();
  double burst = 1;

  friend bool operator==(const Quota&, const Quota&) = default;
};

struct Caller {
  // Several tokens may share a name, and then share its quota. Empty for
  // everybody, on a server without tokens.
  std::string name;
  Scopes scopes;
  Quota quota;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_SECURITY_CALLER_H_
