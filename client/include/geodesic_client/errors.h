// What a server's error says beyond code and message.

#ifndef GEODESIC_CLIENT_ERRORS_H_
#define GEODESIC_CLIENT_ERRORS_H_

#include <chrono>
#include <optional>
#include <string>

#include "absl/status/status.h"

namespace geodesic::client {

// The stable reason the server gave, e.g. "MESH_NOT_RESIDENT": the list is in
// docs/protocol.md. Empty if there is none, as for errors of this machine.
std::string ErrorReason(const absl::Status& status);

// After what time the server suggests to try again; nothing if it does not.
std::optional<std::chrono::duration<double>> RetryDelay(
    const absl::Status& status);

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_ERRORS_H_
