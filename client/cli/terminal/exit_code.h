// The exit codes of the command, for scripts, and its error messages.

#ifndef GEODESIC_CLIENT_CLI_TERMINAL_EXIT_CODE_H_
#define GEODESIC_CLIENT_CLI_TERMINAL_EXIT_CODE_H_

#include <string>
#include <string_view>

#include "absl/status/status.h"

namespace geodesic::client {

enum class ExitCode {
  kOk = 0,
  kNoneRuns = 1,
  kUsage = 2,
  kFile = 3,
  kNoPath = 4,
  kRefused = 5,
  kTimeout = 6,
  kNoServer = 7,
  kInterrupted = 130,
};

// The codes and their meaning, as --help prints them.
std::string_view ExitCodeHelp();

// Marks an error of a file of this machine, which the server never saw.
// NOT_FOUND becomes INVALID_ARGUMENT, since a missing file is a wrong argument.
absl::Status FileError(absl::Status status);

// The status of a command that was asked to stop. It differs from that of a
// call which the server cancelled by itself.
absl::Status Interrupted();

// Marks an error of starting a server: there is none to reach, and the message
// says why.
absl::Status NoServer(absl::Status status);

// The status of a command whose answer is that no path leads to what it was
// asked for: `message` says to what, and why.
absl::Status NoPath(std::string_view message);

// What `geodesic server status` says when no server runs.
absl::Status NoneRuns(std::string_view message);

// REQUIRES: not OK.
ExitCode ExitCodeOf(const absl::Status& status);

// Says what went wrong and what to do next, in a sentence or two. `server` is
// the server's address.
// REQUIRES: not OK.
std::string Explain(const absl::Status& status, std::string_view server);

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_CLI_TERMINAL_EXIT_CODE_H_
