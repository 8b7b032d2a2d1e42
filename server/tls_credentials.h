// TLS as gRPC wants it.

#ifndef GEODESIC_SERVER_TLS_CREDENTIALS_H_
#define GEODESIC_SERVER_TLS_CREDENTIALS_H_

#include <grpcpp/security/server_credentials.h>

#include <memory>

#include "absl/status/statusor.h"
#include "server/security/tls_files.h"

namespace geodesic::server {

// Credentials that follow the files: connections made after a file has changed
// get the new certificate, those that are open go on with the old one. Without
// files: none, in clear.
// Errors: as CheckTlsFiles.
absl::StatusOr<std::shared_ptr<grpc::ServerCredentials>> MakeServerCredentials(
    const TlsFiles& files);

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_TLS_CREDENTIALS_H_
