// The one place where the engine's errors become gRPC's.

#ifndef GEODESIC_SERVER_RPC_CALLS_STATUS_TRANSLATION_H_
#define GEODESIC_SERVER_RPC_CALLS_STATUS_TRANSLATION_H_

#include <grpcpp/support/status.h>

#include "absl/status/status.h"

namespace geodesic::server {

// Code and message stay (see PrintableMessage). Details follow as google.rpc
// messages: ErrorInfo with the reason always, BadRequest for a field at fault,
// ResourceInfo for a mesh that is not there, QuotaFailure, and RetryInfo when
// waiting helps.
grpc::Status ToGrpcStatus(const absl::Status& status);

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_CALLS_STATUS_TRANSLATION_H_
