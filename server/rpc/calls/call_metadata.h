// What a call says beside its messages, both ways.

#ifndef GEODESIC_SERVER_RPC_CALLS_CALL_METADATA_H_
#define GEODESIC_SERVER_RPC_CALLS_CALL_METADATA_H_

#include <grpcpp/server_context.h>

#include <string>
#include <string_view>

#include "absl/status/status.h"
#include "absl/status/statusor.h"

namespace geodesic::server {

// The value of "authorization".
// Errors: NOT_FOUND if there is none; UNAUTHENTICATED if there are several.
absl::StatusOr<std::string> Authorization(
    const grpc::CallbackServerContext& context);

// A peer's address as gRPC tells it, without the port, which changes from one
// connection to the next: "ipv4:10.1.2.3" of "ipv4:10.1.2.3:53412".
std::string PeerHost(std::string_view peer);

// The client's "x-request-id" if it can be logged: up to 64 letters, digits and
// "-_."; else one of the server's.
std::string RequestId(const grpc::CallbackServerContext& context);

// The "traceparent" of W3C's Trace Context if it has that form, else nothing.
std::string TraceParent(const grpc::CallbackServerContext& context);

// Adds to the trailers the request id and, when the server is full, when gRPC's
// own retries may come again, or that they may not.
void AddTrailers(const std::string& request_id, const absl::Status& status,
                 grpc::CallbackServerContext& context);

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_CALLS_CALL_METADATA_H_
