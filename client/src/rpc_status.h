// Statuses as gRPC gives them -> statuses as this library gives them, and which
// of them make a call that gRPC does not repeat worth repeating.

#ifndef GEODESIC_CLIENT_RPC_STATUS_H_
#define GEODESIC_CLIENT_RPC_STATUS_H_

#include <grpcpp/support/status.h>

#include <stop_token>
#include <string_view>

#include "absl/status/status.h"

namespace geodesic::client {

// Keeps code and message; what google.rpc.BadRequest and google.rpc.RetryInfo
// in the details say is appended to the message in brackets. The details
// themselves become payloads under their type URLs; errors.h reads them.
// For a call that sent the file `file` what is wrong with the request is wrong
// with the file: the message then begins with its path and names no fields.
absl::Status FromRpcStatus(const grpc::Status& status,
                           std::string_view file = "");

// As the channel's own policy has it.
inline constexpr int kMaxAttempts = 4;

// Waits before the next attempt, as long as the server suggests or twice as
// long each time; `attempts` have failed, the last with `status`. False, at
// once or when `stop` asks for it, if there is to be none: the error would come
// again, or it was tried often enough.
bool WaitToRetry(const absl::Status& status, int attempts,
                 std::stop_token stop);

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_RPC_STATUS_H_
