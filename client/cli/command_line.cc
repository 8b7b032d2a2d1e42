#include "client/cli/command_line.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "client/cli/arguments/help.h"
#include "client/cli/arguments/options.h"
#include "client/cli/terminal/text.h"

namespace geodesic::client {
namespace {

// As --help lists them.
std::vector<Command> AllCommands() {
  return {UploadCommand(),   MeshesCommand(), InfoCommand(),
          DeleteCommand(),   FieldCommand(),  PathCommand(),
          IsolinesCommand(), MatrixCommand(), NearestCommand(),
          SampleCommand(),   LogMapCommand(), CapabilitiesCommand()};
}

void AddCommonOptions(CLI::App* app, CommandLine* line) {
  AddConnection(app, &line->connection);
  app->add_flag("--json", line->json, "Print one JSON object instead of text");
  app->add_flag("-q,--quiet", line->quiet,
                "Show no progress, and print no summary: only the rows asked "
                "for, and nothing if they go to a file");
  AddValue(
      app,
      {"--timeout", "Give up a call to the server after this time", "SECONDS"},
      ParseTimeout, &line->timeout);
}

// The words after the program's name, the last one first, as CLI11 takes them;
// `help [COMMAND]` becomes `[COMMAND] --help`.
std::vector<std::string> Words(const CLI::App& app, int argc,
                               const char* const* argv) {
  std::vector<std::string> words(argv + 1, argv + argc);
  if (!words.empty() && words[0] == "help") {
    words.erase(words.begin());
    // Of a command that there is not, nothing but that can be said.
    const auto is_it = [&words](const CLI::App* command) {
      return command->get_name() == words[0];
    };
    if (words.empty() || !app.get_subcommands(is_it).empty()) {
      words.push_back("--help");
    }
  }
  std::ranges::reverse(words);
  return words;
}

}  // namespace

std::variant<CommandLine, ExitCode> ParseCommandLine(int argc,
                                                     const char* const* argv,
                                                     std::ostream& out,
                                                     std::ostream& err) {
  CommandLine line;
  CLI::App app(
      "Exact geodesic distances on triangle meshes, from a geodesicd server.",
      "geodesic");
  app.require_subcommand(1);
  app.fallthrough();
  app.set_version_flag("--version", "geodesic " GEODESIC_VERSION);
  app.formatter(MakeHelpFormatter());
  app.failure_message([&app](const CLI::App*, const CLI::Error& error) {
    const std::vector<CLI::App*> commands = app.get_subcommands();
    const CLI::App* given = commands.empty() ? nullptr : commands[0];
    return absl::StrCat("geodesic: ", Printable(MessageOf(app, given, error)),
                        "\nRun geodesic ",
                        given == nullptr ? "" : given->get_name() + " ",
                        "--help for more information.\n");
  });
  app.option_defaults()->always_capture_default();
  AddCommonOptions(&app, &line);
  std::vector<Command> commands = AllCommands();
  for (const Command& command : commands) {
    CLI::App* added = app.add_subcommand(command.name, command.help);
    added->footer(absl::StrCat(
        "Examples:\n", command.examples,
        "\n\n--server with its TLS and token, --json, --quiet and --timeout "
        "may follow\ntoo: see geodesic --help."));
    command.add_options(added);
  }
  app.footer(absl::StrCat(
      "Examples:\n"
      "  geodesic upload horse.ply\n"
      "  geodesic field horse.ply --source 0 -o horse.png -o horse.npy\n"
      "  geodesic path 3f2a91bc --source 0 --target 77 -o path.obj\n"
      "  geodesic --server meshes.example:50051 meshes --json\n\n"
      "geodesic help COMMAND explains one.\n\n",
      std::string(ExitCodeHelp())));
  try {
    app.parse(Words(app, argc, argv));
  } catch (const CLI::ParseError& error) {
    return app.exit(error, out, err) == 0 ? ExitCode::kOk : ExitCode::kUsage;
  }
  line.command = *std::ranges::find(
      commands, app.get_subcommands()[0]->get_name(), &Command::name);
  return line;
}

}  // namespace geodesic::client
