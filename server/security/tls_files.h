// Reads the files of TLS, and checks them before gRPC gets them.
//
// gRPC says nothing when a file is missing or malformed, and every handshake
// fails; if it finds one empty, it aborts.

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
  // The server's certificate, then the chain to its authority.
  std::string certificate;
  std::string key;
  // Authorities of clients; if set, a client without their certificate is
  // refused.
  std::string client_authorities;

  bool enabled() const { return !certificate.empty(); }
};

// What is in the files, in PEM.
struct TlsTexts {
  std::string certificate;
  std::string key;
  std::string client_authorities;  // empty without a file

  bool operator==(const TlsTexts&) const = default;
};

// REQUIRES: files.enabled(). Errors: NOT_FOUND or PERMISSION_DENIED: a file
// cannot be read; INVALID_ARGUMENT: a file is no PEM of its kind, or the key is
// not the certificate's. Messages name the file, never what is in it.
absl::StatusOr<TlsTexts> ReadTlsFiles(const TlsFiles& files);

// When the certificate in the file expires. REQUIRES: files.enabled().
// Errors: as ReadTlsFiles.
absl::StatusOr<std::chrono::system_clock::time_point> CertificateEnd(
    const TlsFiles& files);

// Whether "HOST:PORT" or "unix:PATH" can only be reached from this machine:
// a socket, 127.0.0.0/8, [::1] or localhost. False for all other names.
bool IsLoopback(std::string_view address);

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_SECURITY_TLS_FILES_H_
