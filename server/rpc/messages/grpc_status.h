// Errors of the engine as gRPC sends them.

#ifndef GEODESIC_SERVER_RPC_MESSAGES_GRPC_STATUS_H_
#define GEODESIC_SERVER_RPC_MESSAGES_GRPC_STATUS_H_

#include <grpcpp/support/status.h>

#include "absl/status/status.h"

namespace geodesic::server {

// Keeps the code and the message (see PrintableMessage) and adds details as
// google.rpc messages: always ErrorInfo with the reason, BadRequest for a field
// at fault, ResourceInfo for a missing mesh, QuotaFailure, and RetryInfo when
// waiting helps.
grpc::Status ToGrpcStatus(const absl::Status& status);

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_MESSAGES_GRPC_STATUS_H_
