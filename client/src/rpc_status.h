// Turns gRPC's statuses into those of this library, and decides which of them
// make it worth repeating a call that gRPC does not repeat.

#ifndef GEODESIC_CLIENT_RPC_STATUS_H_
#define GEODESIC_CLIENT_RPC_STATUS_H_

#include <grpcpp/support/status.h>

#include <chrono>
#include <stop_token>
#include <string>
#include <string_view>

#include "absl/status/status.h"

namespace geodesic::client {

// Keeps code and message, and appends in brackets what google.rpc.BadRequest
// and google.rpc.RetryInfo in the details say. The details themselves become
// payloads under their type URLs, which errors.h reads. If the call sent the
// file `file`, an error of the request is an error of that file: the message
// begins with its path and names no fields.
absl::Status FromRpcStatus(const grpc::Status& status,
                           std::string_view file = "");

// The same error about another part of the request: in its message and details
// `from` becomes `to`.
absl::Status RenameField(const absl::Status& status, const std::string& from,
                         const std::string& to);

// The same as in the channel's retry policy.
inline constexpr int kMaxAttempts = 4;

// How long to wait before the next attempt when so many have failed: as long as
// the server suggests, if it does, or else twice as long each time, and up to a
// third longer at random, so that clients that were refused together do not
// come back together. No server makes anybody wait for more than 10 s.
std::chrono::duration<double> DelayBeforeRetry(const absl::Status& status,
                                               int attempts);

// Waits for so long. `attempts` have failed, the last with `status`. Returns
// false at once if another attempt would not help or there have been enough,
// and as soon as `stop` asks for it.
bool WaitToRetry(const absl::Status& status, int attempts,
                 std::stop_token stop);

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_RPC_STATUS_H_
