// Addresses of the form "unix:PATH", by which only this machine is served.

#ifndef GEODESIC_SERVER_UNIX_SOCKET_H_
#define GEODESIC_SERVER_UNIX_SOCKET_H_

#include <sys/types.h>

#include <optional>
#include <string>
#include <string_view>

#include "absl/status/status.h"

namespace geodesic::server {

// The path of "unix:PATH"; nothing for other addresses.
std::optional<std::string> SocketPath(std::string_view address);

// Whether a server can take the socket at this path. gRPC itself would take it
// away from a server that still answers.
// Errors: INVALID_ARGUMENT if the path is relative, too long for a socket, or
// has characters that gRPC's addresses escape; UNAVAILABLE if a server answers
// there, or if something else than a socket is in the way.
absl::Status CheckSocketPath(const std::string& path);

// While it lives, files and sockets that this process makes are its user's
// alone. The mask is the process's: other threads are not to make files.
class PrivateFiles {
 public:
  PrivateFiles();
  ~PrivateFiles();
  PrivateFiles(const PrivateFiles&) = delete;
  PrivateFiles& operator=(const PrivateFiles&) = delete;

 private:
  const mode_t before_;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_UNIX_SOCKET_H_
