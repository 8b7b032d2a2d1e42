// Starts a geodesicd that outlives the command.

#ifndef GEODESIC_CLIENT_CLI_OWN_SERVER_LAUNCH_H_
#define GEODESIC_CLIENT_CLI_OWN_SERVER_LAUNCH_H_

#include <chrono>
#include <optional>
#include <stop_token>
#include <string>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "client/cli/own_server/page_files.h"

namespace geodesic::client {

// The geodesicd beside this program, else the first in PATH.
// Errors: NOT_FOUND.
absl::StatusOr<std::string> FindServerProgram();

struct Launch {
  std::string program;
  std::string socket_path;
  // What the server says is added to it.
  std::string log_path;
  // A descriptor that the server keeps open until it ends. It inherits no
  // other of this process.
  int kept_open = -1;
  // If set, it serves its page on a free port of this machine.
  std::optional<PageFiles> page;
};

// Starts the program in a session of its own, where Ctrl-C does not reach it,
// and returns once it serves. Settings come from its environment variables,
// but those of network, security and disk, which are a shared server's. Unless
// they are set, it ends when idle for kIdleTime, or kIdleTimeWithPage, and logs
// warnings only. Errors: UNAVAILABLE with what the server said if it ends first
// or does not serve before `until`, when it is killed; CANCELLED if stopped,
// which leaves the server alone; those of the system.
absl::Status LaunchServer(const Launch& launch,
                          std::chrono::steady_clock::time_point until,
                          const std::stop_token& stop);

inline constexpr std::chrono::seconds kIdleTime{600};
// Of a server with a page, whose user may be looking at it.
inline constexpr std::chrono::seconds kIdleTimeWithPage{3600};

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_CLI_OWN_SERVER_LAUNCH_H_
