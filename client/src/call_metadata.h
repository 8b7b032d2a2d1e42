// What every call says of itself: the token, and a request id by which the
// server's log can be searched.

#ifndef GEODESIC_CLIENT_CALL_METADATA_H_
#define GEODESIC_CLIENT_CALL_METADATA_H_

#include <grpcpp/support/client_interceptor.h>

#include <memory>
#include <string>

namespace geodesic::client {

// Adds "x-request-id" and, unless `token` is empty, "authorization" to each
// call of a channel. Calls without TLS get the token too, which gRPC's own
// call credentials refuse.
std::unique_ptr<grpc::experimental::ClientInterceptorFactoryInterface>
MakeCallMetadata(const std::string& token);

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_CALL_METADATA_H_
