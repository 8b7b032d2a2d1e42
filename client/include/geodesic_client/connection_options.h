// How a Client speaks with its server.
//
//   auto tls = ReadTlsFiles({.authorities = "ca.pem"});
//   if (!tls.ok()) return tls.status();
//   Client client("meshes.example:50051", {.tls = *tls, .token = token});

#ifndef GEODESIC_CLIENT_CONNECTION_OPTIONS_H_
#define GEODESIC_CLIENT_CONNECTION_OPTIONS_H_

#include <optional>
#include <string>
#include <string_view>

#include "absl/status/statusor.h"

namespace geodesic::client {

// Certificates and keys, as texts in PEM form.
struct TlsOptions {
  // Authorities that vouch for the server. DEFAULT: those that the system
  // trusts.
  std::string authorities;
  // The certificate that the client shows a server that asks for one, and its
  // key. DEFAULT: nothing.
  std::string certificate;
  std::string key;
  // The name in the server's certificate. DEFAULT: the host of its address.
  std::string server_name;
};

// How to reach a server.
struct ConnectionOptions {
  // DEFAULT: in clear.
  std::optional<TlsOptions> tls;
  // Sent with each call as "authorization: Bearer ...". Without TLS it travels
  // in clear. What is no token (IsToken) is sent with its characters escaped,
  // and refused. DEFAULT: none.
  std::string token;
  // Whether calls are repeated, and broken reads resumed, as client.h says.
  // Without it every error is reported at once.
  bool retry = true;
};

// Paths of files that hold the members of TlsOptions. An empty path names no
// file.
struct TlsPaths {
  std::string authorities;
  std::string certificate;
  std::string key;
};

// Errors: NOT_FOUND or PERMISSION_DENIED naming a file that cannot be read;
// INVALID_ARGUMENT if it holds no PEM, or for a certificate without its key.
absl::StatusOr<TlsOptions> ReadTlsFiles(const TlsPaths& paths);

// Whether a header can carry the text as a token: visible characters of ASCII.
bool IsToken(std::string_view text);

// Reads the token, which is the file's first line.
// Errors: NOT_FOUND or PERMISSION_DENIED if the file cannot be read;
// INVALID_ARGUMENT if the line is no token.
absl::StatusOr<std::string> ReadTokenFile(const std::string& path);

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_CONNECTION_OPTIONS_H_
