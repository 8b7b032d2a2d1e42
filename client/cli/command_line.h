// The command line of `geodesic`: what is common to all commands, and which of
// them is meant.

#ifndef GEODESIC_CLIENT_CLI_COMMAND_LINE_H_
#define GEODESIC_CLIENT_CLI_COMMAND_LINE_H_

#include <optional>
#include <ostream>
#include <string>
#include <variant>

#include "client/cli/arguments/connection.h"
#include "client/cli/commands/command.h"
#include "client/cli/terminal/exit_code.h"

namespace geodesic::client {

struct CommandLine {
  ConnectionArguments connection;
  bool json = false;
  bool quiet = false;
  // Seconds.
  std::optional<double> timeout;
  // Holds its own arguments.
  Command command;
};

// The command line, or how to end at once: after printing help or the version
// to `out`, or what is wrong to `err`.
std::variant<CommandLine, ExitCode> ParseCommandLine(int argc,
                                                     const char* const* argv,
                                                     std::ostream& out,
                                                     std::ostream& err);

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_CLI_COMMAND_LINE_H_
