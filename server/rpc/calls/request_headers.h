// What a request says of itself beside its message.

#ifndef GEODESIC_SERVER_RPC_CALLS_REQUEST_HEADERS_H_
#define GEODESIC_SERVER_RPC_CALLS_REQUEST_HEADERS_H_

#include <grpcpp/server_context.h>

#include <string>
#include <string_view>

namespace geodesic::server {

// The first value of the header; empty if there is none. Valid as long as the
// context.
std::string_view Header(const grpc::CallbackServerContext& context,
                        const char* name);

// The client's "x-request-id" if it can be logged: up to 64 letters, digits and
// "-_."; else one of the server's.
std::string RequestId(const grpc::CallbackServerContext& context);

// The "traceparent" of W3C's Trace Context if it has that form, else nothing.
std::string TraceParent(const grpc::CallbackServerContext& context);

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_CALLS_REQUEST_HEADERS_H_
