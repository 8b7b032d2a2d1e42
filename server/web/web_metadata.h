// Metadata of gRPC to and from the headers of HTTP.

#ifndef GEODESIC_SERVER_WEB_WEB_METADATA_H_
#define GEODESIC_SERVER_WEB_WEB_METADATA_H_

#include <grpcpp/client_context.h>
#include <grpcpp/support/string_ref.h>

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "absl/status/status.h"

namespace geodesic::server {

// Names, as they came or in small letters, and values.
using HttpHeaders = std::vector<std::pair<std::string, std::string>>;

// Adds to `context` what a request's headers say to gRPC: the deadline of
// "grpc-timeout", and as metadata all others but those that are HTTP's, the
// browser's or gRPC's own. Those that end in "-bin" are base64 and become
// bytes.
// Errors: INVALID_ARGUMENT naming the header that is malformed.
absl::Status AddMetadata(const HttpHeaders& headers,
                         grpc::ClientContext& context);

// A call's initial or trailing metadata as headers.
HttpHeaders ToHeaders(
    const std::multimap<grpc::string_ref, grpc::string_ref>& metadata);

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_WEB_WEB_METADATA_H_
