// The files of TLS, looked at before gRPC gets them.
//
// gRPC serves on without a word when a file is missing or malformed, and every
// handshake fails. So what is wrong is said here, at the start.

#ifndef GEODESIC_SERVER_SECURITY_TLS_FILES_H_
#define GEODESIC_SERVER_SECURITY_TLS_FILES_H_

#include <chrono>
#include <string>
#include <string_view>

#include "absl/status/status.h"
#include "absl/status/statusor.h"

namespace geodesic::server {

// Paths of PEM files; empty: none.
struct TlsFiles {
  // The server's certificate, then those that lead to its authority.
  std::string certificate;
  std::string key;
  // Authorities whose clients are let in; when given, a client without a
  // certificate of theirs is refused.
  std::string client_authorities;

  bool enabled() const { return !certificate.empty(); }
};

// Whether the server can work with these files. REQUIRES: files.enabled().
// Errors: NOT_FOUND or PERMISSION_DENIED: a file cannot be read;
// INVALID_ARGUMENT: a file is no PEM of its kind, or the key is not the
// certificate's. Messages name the file, never what is in it.
absl::Status CheckTlsFiles(const TlsFiles& files);

// When the certificate ends, as the file is now. REQUIRES: files.enabled().
// Errors: as CheckTlsFiles.
absl::StatusOr<std::chrono::system_clock::time_point> CertificateEnd(
    const TlsFiles& files);

// Whether the host of "HOST:PORT" is this machine's alone: 127.0.0.0/8, [::1]
// or localhost. False for what it does not know, such as other names.
bool IsLoopback(std::string_view address);

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_SECURITY_TLS_FILES_H_
