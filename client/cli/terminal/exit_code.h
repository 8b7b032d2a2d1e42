// How the command ends, for scripts, and what it says when it fails.

#ifndef GEODESIC_CLIENT_CLI_TERMINAL_EXIT_CODE_H_
#define GEODESIC_CLIENT_CLI_TERMINAL_EXIT_CODE_H_

#include <string>
#include <string_view>

#include "absl/status/status.h"

namespace geodesic::client {

enum class ExitCode {
  kOk = 0,
  kUsage = 2,
  kFile = 3,
  kUnreachable = 4,
  kRefused = 5,
  kTimeout = 6,
  kInterrupted = 130,
};

// The codes and their meaning, as --help prints them.
std::string_view ExitCodeHelp();

// Marks an error as one of this machine's files: the server never saw it. A
// file that is not there is a wrong argument: INVALID_ARGUMENT.
absl::Status FileError(absl::Status status);

// What a command ends with because it was asked to stop. A server that cancels
// a call by itself is another matter.
absl::Status Interrupted();

// REQUIRES: not OK.
ExitCode ExitCodeOf(const absl::Status& status);

// What went wrong and what to do next, in a sentence or two. `server` is the
// address the command spoke to. REQUIRES: not OK.
std::string Explain(const absl::Status& status, std::string_view server);

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_CLI_TERMINAL_EXIT_CODE_H_
