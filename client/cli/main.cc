// The command `geodesic`.

#include <sys/ioctl.h>
#include <unistd.h>

#include <chrono>
#include <iostream>
#include <utility>
#include <variant>

#include "client/cli/arguments.h"
#include "client/cli/commands.h"
#include "client/cli/connection.h"
#include "client/cli/interrupt_listener.h"

namespace geodesic::client {
namespace {

int TerminalWidth() {
  winsize size = {};
  return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0
             ? size.ws_col
             : 80;
}

ProgressDisplay::Style ProgressStyle(const Arguments& arguments) {
  if (arguments.quiet) return ProgressDisplay::Style::kNone;
  return isatty(STDERR_FILENO) != 0 ? ProgressDisplay::Style::kBar
                                    : ProgressDisplay::Style::kLines;
}

ExitCode Fail(const absl::Status& status, const Arguments& arguments) {
  const ExitCode exit_code = ExitCodeOf(status);
  if (arguments.json) PrintJson(ErrorToJson(status, exit_code), &std::cout);
  std::cerr << "geodesic: " << Explain(status, arguments.server) << std::endl;
  return exit_code;
}

ExitCode Run(const Arguments& arguments) {
  InterruptListener interrupt;
  absl::StatusOr<ConnectionOptions> connection = ReadConnection(arguments);
  if (!connection.ok()) return Fail(connection.status(), arguments);
  Client client(arguments.server, *std::move(connection));
  CallOptions call = {.stop = interrupt.stop()};
  if (arguments.timeout.has_value()) {
    call.timeout = std::chrono::duration<double>(*arguments.timeout);
  }
  const Session session = {.arguments = arguments,
                           .client = client,
                           .call = std::move(call),
                           .out = std::cout,
                           .err = std::cerr,
                           .progress_style = ProgressStyle(arguments),
                           // The last column makes some terminals wrap.
                           .terminal_width = TerminalWidth() - 1};
  const absl::Status status = RunCommand(session);
  std::cout.flush();
  return status.ok() ? ExitCode::kOk : Fail(status, arguments);
}

}  // namespace
}  // namespace geodesic::client

int main(int argc, char** argv) {
  using namespace geodesic::client;
  std::variant<Arguments, ExitCode> parsed =
      ParseArguments(argc, argv, std::cout, std::cerr);
  const ExitCode* ended = std::get_if<ExitCode>(&parsed);
  return static_cast<int>(ended != nullptr ? *ended
                                           : Run(std::get<Arguments>(parsed)));
}
