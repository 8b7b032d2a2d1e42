#include "client/cli/command_line.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <numeric>
#include <sstream>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"
#include "client/cli/arguments/options.h"
#include "client/cli/terminal/text.h"

namespace geodesic::client {
namespace {

constexpr size_t kNameColumns = 30;
constexpr size_t kDescriptionColumns = 50;

// Breaks `text` into lines, which CLI11 indents.
std::string Wrapped(const std::string& text) {
  std::istringstream words(text);
  std::string lines;
  size_t column = 0;
  for (std::string word; words >> word;) {
    if (column > 0 && column + 1 + word.size() > kDescriptionColumns) {
      lines.push_back('\n');
      column = 0;
    } else if (column > 0) {
      lines.push_back(' ');
      ++column;
    }
    lines.append(word);
    column += word.size();
  }
  return lines;
}

// Shows the types of options' values, and wraps descriptions.
class HelpFormatter : public CLI::Formatter {
 public:
  HelpFormatter() { column_width(kNameColumns); }

  std::string make_option_name(const CLI::Option* option,
                               bool is_positional) const override {
    std::string name = CLI::Formatter::make_option_name(option, is_positional);
    // The name of a flag with a count ends in braces (AddFlagOrCount).
    const size_t brace = name.find('{');
    return brace == std::string::npos
               ? name
               : absl::StrCat(name.substr(0, brace), "[=N]");
  }

  std::string make_option_opts(const CLI::Option* option) const override {
    const bool has_value = option->get_type_size() != 0;
    return has_value && !option->get_type_name().empty()
               ? absl::StrCat(" ", option->get_type_name())
               : std::string();
  }

  std::string make_option_desc(const CLI::Option* option) const override {
    std::string text = option->get_description();
    if (option->get_required() && !option->get_positional()) {
      absl::StrAppend(&text, " (required)");
    }
    if (!option->get_default_str().empty()) {
      absl::StrAppend(&text, " (default ", option->get_default_str(), ")");
    }
    if (!option->get_envname().empty()) {
      absl::StrAppend(&text, " (or set ", option->get_envname(), ")");
    }
    return Wrapped(text);
  }
};

// The edit distance of Levenshtein, one row of its table at a time.
size_t EditDistance(std::string_view a, std::string_view b) {
  std::vector<size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (size_t i = 0; i < a.size(); ++i) {
    size_t diagonal = row[0]++;
    for (size_t j = 0; j < b.size(); ++j) {
      const size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, diagonal + 1, row[j] + 1});
    }
  }
  return row.back();
}

// The candidate nearest to `typed` by edit distance. Empty if the distance is
// more than one, plus one for every three letters typed.
std::string Suggestion(std::string_view typed,
                       const std::vector<std::string>& candidates) {
  std::string nearest;
  size_t least = typed.size() / 3 + 2;
  for (const std::string& candidate : candidates) {
    const size_t distance = EditDistance(typed, candidate);
    if (distance < least) {
      least = distance;
      nearest = candidate;
    }
  }
  return nearest;
}

// The names of options, or of commands, that the user may have meant.
std::vector<std::string> Candidates(const CLI::App& app, const CLI::App* given,
                                    const std::string& typed) {
  std::vector<std::string> names;
  if (!typed.starts_with('-')) {
    for (const CLI::App* command : app.get_subcommands({})) {
      names.push_back(command->get_name());
    }
    return names;
  }
  for (const CLI::App* place : {&app, given}) {
    if (place == nullptr) continue;
    for (const CLI::Option* option : place->get_options()) {
      for (const std::string& name : option->get_lnames()) {
        names.push_back("--" + name);
      }
    }
  }
  return names;
}

// What `error` says, with a suggestion for a mistyped word. `given` is the
// command, or null if there is none.
std::string MessageOf(const CLI::App& app, const CLI::App* given,
                      const CLI::Error& error) {
  // CLI11 lists the remaining words from the last to the first.
  const std::vector<std::string> rest = app.remaining(true);
  const bool is_extra =
      dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr;
  if (rest.empty() || (given != nullptr && !is_extra)) return error.what();
  const std::string typed = rest[0].substr(0, rest[0].find('='));
  const std::string suggestion =
      Suggestion(typed, Candidates(app, given, typed));
  return absl::StrCat(given == nullptr && !typed.starts_with('-')
                          ? "there is no command " + typed
                          : "not expected here: " + absl::StrJoin(rest, " "),
                      suggestion.empty() ? "" : "; did you mean ", suggestion,
                      suggestion.empty() ? "" : "?");
}

// Whether data sent to `server` stays on this machine.
bool IsLoopback(std::string_view server) {
  // A socket, or the server that geodesic starts by itself.
  if (server.empty() || server.starts_with("unix:")) return true;
  const std::string_view host = server.substr(0, server.rfind(':'));
  // A name may begin with 127., too.
  const bool is_number =
      host.find_first_not_of("0123456789.") == std::string_view::npos;
  return host == "localhost" || host == "[::1]" ||
         (host.starts_with("127.") && is_number);
}

absl::StatusOr<std::string> ReadToken(const ConnectionArguments& connection) {
  if (!connection.token.empty()) {
    if (IsToken(connection.token)) return connection.token;
    return absl::InvalidArgumentError(
        "--token (or GEODESIC_TOKEN) holds a blank or another character that "
        "no token has");
  }
  if (connection.token_file.empty()) return std::string();
  return ReadTokenFile(connection.token_file);
}

// Adds --server and the options that belong to it.
void AddConnection(CLI::App* app, ConnectionArguments* arguments) {
  ConnectionArguments& connection = *arguments;
  AddValue(app,
           {"--server",
            "Where the server listens, or unix:/PATH; without it, geodesic "
            "starts one of its own, which ends after ten idle minutes",
            "HOST:PORT"},
           ParseServer, &connection.server)
      ->envname("GEODESIC_SERVER");
  app->add_flag("--tls", connection.tls,
                "Speak TLS and trust the authorities this system trusts; the "
                "other --tls options imply it")
      ->envname("GEODESIC_TLS");
  const auto add = [app](const std::string& name, std::string& value,
                         const std::string& help, const std::string& type,
                         const std::string& variable) {
    return app->add_option(name, value, help)
        ->type_name(type)
        ->envname(variable);
  };
  add("--tls-ca", connection.paths.authorities,
      "Trust the authorities in this PEM file instead", "FILE",
      "GEODESIC_TLS_CA");
  CLI::Option* certificate =
      add("--tls-cert", connection.paths.certificate,
          "Show this certificate to a server that asks for one", "FILE",
          "GEODESIC_TLS_CERT");
  CLI::Option* key =
      add("--tls-key", connection.paths.key, "The private key of --tls-cert",
          "FILE", "GEODESIC_TLS_KEY");
  certificate->needs(key);
  key->needs(certificate);
  add("--tls-server-name", connection.server_name,
      "The name the server's certificate must have, if it is not the host of "
      "--server",
      "NAME", "GEODESIC_TLS_SERVER_NAME");
  add("--token", connection.token,
      "Say who you are with this token; others on this machine can read "
      "command lines, so better the variable or --token-file",
      "TOKEN", "GEODESIC_TOKEN");
  add("--token-file", connection.token_file,
      "Read the token from the first line of this file", "FILE",
      "GEODESIC_TOKEN_FILE");
  app->add_flag("--no-retry", connection.no_retry,
                "Report at once that the server is full, away, or was cut off, "
                "instead of trying again a few times")
      ->envname("GEODESIC_NO_RETRY");
}

// In the order in which --help lists them.
std::vector<Command> AllCommands() {
  return {UploadCommand(),  MeshesCommand(),   InfoCommand(),
          DeleteCommand(),  DistanceCommand(), FieldCommand(),
          PathCommand(),    IsolinesCommand(), MatrixCommand(),
          NearestCommand(), SampleCommand(),   LogMapCommand(),
          TraceCommand(),   ViewCommand(),     CapabilitiesCommand(),
          ServerCommand()};
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

// The words after the program's name, with the last one first, as CLI11 takes
// them. `help [COMMAND]` becomes `[COMMAND] --help`.
std::vector<std::string> Words(const CLI::App& app, int argc,
                               const char* const* argv) {
  std::vector<std::string> words(argv + 1, argv + argc);
  if (!words.empty() && words[0] == "help") {
    words.erase(words.begin());
    // An unknown command gets no --help, so the parser reports it.
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

// Gives `app` the options, which write into `line`, and the commands.
void AddAll(const std::vector<Command>& commands, CLI::App* app,
            CommandLine* line) {
  app->name("geodesic");
  app->description(
      "Exact geodesic distances on triangle meshes, from a geodesicd server.");
  app->require_subcommand(1);
  app->fallthrough();
  app->set_version_flag("--version", "geodesic " GEODESIC_VERSION);
  app->formatter(std::make_shared<HelpFormatter>());
  app->option_defaults()->always_capture_default();
  AddCommonOptions(app, line);
  for (const Command& command : commands) {
    CLI::App* added = app->add_subcommand(command.name, command.help);
    added->footer(absl::StrCat(
        "Examples:\n", command.examples,
        "\n\n--server with its TLS and token, --json, --quiet and --timeout "
        "may follow\ntoo: see geodesic --help."));
    command.add_options(added);
  }
  app->footer(absl::StrCat(
      "Examples:\n"
      "  geodesic field horse.ply --source 0 -o horse.png -o horse.npy\n"
      "  geodesic path 3f2a91bc --source 0 --target 77 -o path.obj\n"
      "  geodesic --server meshes.example:50051 meshes --json\n\n"
      "geodesic help COMMAND explains one.\n\n",
      std::string(ExitCodeHelp())));
}

}  // namespace

std::variant<CommandLine, ExitCode> ParseCommandLine(int argc,
                                                     const char* const* argv,
                                                     std::ostream& out,
                                                     std::ostream& err) {
  CommandLine line;
  CLI::App app;
  const std::vector<Command> commands = AllCommands();
  AddAll(commands, &app, &line);
  app.failure_message([&app](const CLI::App*, const CLI::Error& error) {
    const std::vector<CLI::App*> chosen = app.get_subcommands();
    const CLI::App* given = chosen.empty() ? nullptr : chosen[0];
    return absl::StrCat("geodesic: ", Printable(MessageOf(app, given, error)),
                        "\nRun geodesic ",
                        given == nullptr ? "" : given->get_name() + " ",
                        "--help for more information.\n");
  });
  try {
    app.parse(Words(app, argc, argv));
  } catch (const CLI::ParseError& error) {
    return app.exit(error, out, err) == 0 ? ExitCode::kOk : ExitCode::kUsage;
  }
  line.command = *std::ranges::find(
      commands, app.get_subcommands()[0]->get_name(), &Command::name);
  return line;
}

manual::Page ProgramPage() {
  CommandLine line;
  CLI::App app;
  AddAll(AllCommands(), &app, &line);
  return manual::Describe(app);
}

absl::StatusOr<ConnectionOptions> ReadConnection(
    const ConnectionArguments& connection) {
  ConnectionOptions options;
  if (connection.tls || !connection.paths.authorities.empty() ||
      !connection.paths.certificate.empty() ||
      !connection.server_name.empty()) {
    absl::StatusOr<TlsOptions> tls = ReadTlsFiles(connection.paths);
    if (!tls.ok()) return FileError(tls.status());
    if (connection.server.empty()) {
      return FileError(absl::FailedPreconditionError(
          "TLS is for a server elsewhere: name it with --server HOST:PORT"));
    }
    options.tls = *std::move(tls);
    options.tls->server_name = connection.server_name;
  }
  absl::StatusOr<std::string> token = ReadToken(connection);
  if (!token.ok()) return FileError(token.status());
  if (!token->empty() && !options.tls.has_value() &&
      !IsLoopback(connection.server)) {
    return FileError(absl::FailedPreconditionError(
        absl::StrCat("the token would go to ", connection.server,
                     " in clear: use TLS (--tls or --tls-ca FILE)")));
  }
  options.token = *std::move(token);
  options.retry = !connection.no_retry;
  return options;
}

}  // namespace geodesic::client
