// A command of `geodesic`, and the session that it runs in.

#ifndef GEODESIC_CLIENT_CLI_COMMANDS_COMMAND_H_
#define GEODESIC_CLIENT_CLI_COMMANDS_COMMAND_H_

#include <functional>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "client/cli/own_server/page_files.h"
#include "client/cli/terminal/progress_display.h"
#include "client/cli/terminal/text.h"
#include "geodesic_client/client.h"

namespace CLI {
class App;
}  // namespace CLI

namespace geodesic::client {

struct Session {
  Client& client;
  // Address of the server.
  const std::string& server;
  // Brings the timeout and Ctrl-C to every call.
  CallOptions call;
  // With --json, the object to print at the end instead of text; otherwise
  // null.
  Json* json = nullptr;
  // Whether to print only what was asked for.
  bool quiet = false;
  // `out` takes results as text, `err` everything else.
  std::ostream& out;
  std::ostream& err;
  ProgressDisplay::Style progress_style = ProgressDisplay::Style::kNone;
  int terminal_width = 80;
  // The page of the server that geodesic started, if the command needs it.
  std::optional<PageFiles> page;
};

struct Command {
  std::string name;
  std::string help;
  // Examples for the help, one a line.
  std::string examples;
  // Adds the options, and checks of their combinations.
  std::function<void(CLI::App* app)> add_options;
  // Does the work and prints the result, or puts it into Session::json. If it
  // fails, what was already printed or put there stays.
  std::function<absl::Status(const Session&)> run;
  // Whether it deals with the server that geodesic starts by itself, and so
  // neither starts one nor reaches another.
  bool is_about_own_server = false;
  // Whether the server that geodesic starts by itself must serve its page.
  bool needs_page = false;
};

// A command whose options write into an `Arguments` that `run` gets.
template <typename Arguments>
Command MakeCommand(
    std::string name, std::string help, std::string examples,
    void (*add_options)(CLI::App*, Arguments*),
    std::function<absl::Status(const Arguments&, const Session&)> run) {
  const auto arguments = std::make_shared<Arguments>();
  return {
      .name = std::move(name),
      .help = std::move(help),
      .examples = std::move(examples),
      .add_options = [=](CLI::App* app) { add_options(app, arguments.get()); },
      .run = [=](const Session& session) { return run(*arguments, session); },
      .is_about_own_server = false};
}

// For commands without options.
struct NoArguments {};
inline void AddNoOptions(CLI::App*, NoArguments*) {}

// All commands.
Command CapabilitiesCommand();
Command DeleteCommand();
Command DistanceCommand();
Command FieldCommand();
Command InfoCommand();
Command IsolinesCommand();
Command LogMapCommand();
Command MatrixCommand();
Command MeshesCommand();
Command NearestCommand();
Command PathCommand();
Command SampleCommand();
Command ServerCommand();
Command TraceCommand();
Command UploadCommand();
Command ViewCommand();

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_CLI_COMMANDS_COMMAND_H_
