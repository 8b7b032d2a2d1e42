// Statuses as gRPC gives them -> statuses as this library gives them.

#ifndef GEODESIC_CLIENT_RPC_STATUS_H_
#define GEODESIC_CLIENT_RPC_STATUS_H_

#include <grpcpp/support/status.h>

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

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_RPC_STATUS_H_
