// Parses the command line of `geodesic`: the command, and the options common to
// all commands.

#ifndef GEODESIC_CLIENT_CLI_COMMAND_LINE_H_
#define GEODESIC_CLIENT_CLI_COMMAND_LINE_H_

#include <optional>
#include <ostream>
#include <string>
#include <variant>

#include "absl/status/statusor.h"
#include "client/cli/commands/command.h"
#include "client/cli/terminal/exit_code.h"
#include "geodesic_client/connection_options.h"
#include "manual/pages.h"

namespace geodesic::client {

// How the command reaches its server: address, TLS, token.
struct ConnectionArguments {
  // Empty: one that geodesic starts by itself.
  std::string server;
  bool tls = false;
  TlsPaths paths;
  std::string server_name;
  std::string token;
  std::string token_file;
  bool no_retry = false;
};

struct CommandLine {
  ConnectionArguments connection;
  bool json = false;
  bool quiet = false;
  // In seconds.
  std::optional<double> timeout;
  // The command holds its own arguments.
  Command command;
};

// The command line, or the exit code to end with at once, after printing help
// or the version to `out` or an error to `err`.
std::variant<CommandLine, ExitCode> ParseCommandLine(int argc,
                                                     const char* const* argv,
                                                     std::ostream& out,
                                                     std::ostream& err);

// All options and commands, for man pages and completions.
manual::Page ProgramPage();

// Reads the files that the arguments name.
// Errors, all marked by FileError: those of ReadTlsFiles and ReadTokenFile;
// FAILED_PRECONDITION if a token would go to another machine in clear, or for
// TLS without a server's name.
absl::StatusOr<ConnectionOptions> ReadConnection(
    const ConnectionArguments& connection);

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_CLI_COMMAND_LINE_H_
