// What a server's error says besides its code and message.

#ifndef GEODESIC_CLIENT_ERRORS_H_
#define GEODESIC_CLIENT_ERRORS_H_

#include <chrono>
#include <optional>
#include <string>

#include "absl/status/status.h"

namespace geodesic::client {

// The stable reason that the server gave, e.g. "MESH_NOT_RESIDENT";
// docs/protocol.md lists them. Empty if there is none, as for errors of this
// machine.
std::string ErrorReason(const absl::Status& status);

// The path of the part of the request that the server points at, e.g.
// "pairs[17].source.vertex". Empty if there is none.
std::string ErrorField(const absl::Status& status);

// How long the server suggests to wait before trying again; nothing if it
// suggests no time.
std::optional<std::chrono::duration<double>> RetryDelay(
    const absl::Status& status);

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_ERRORS_H_
