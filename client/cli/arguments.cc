#include "client/cli/arguments.h"

#include <CLI/CLI.hpp>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"
#include "client/cli/connection.h"
#include "client/cli/help_formatter.h"
#include "client/cli/options.h"
#include "client/cli/question_options.h"

namespace geodesic::client {
namespace {

// The command line under construction; options write into `arguments`.
class Parser {
 public:
  explicit Parser(Arguments* arguments)
      : arguments_(arguments),
        app_(
            "Exact geodesic distances on triangle meshes, from a geodesicd "
            "server.",
            "geodesic") {
    app_.require_subcommand(1);
    app_.fallthrough();
    app_.set_version_flag("--version", "geodesic " GEODESIC_VERSION);
    app_.formatter(std::make_shared<HelpFormatter>());
    app_.failure_message([this](const CLI::App*, const CLI::Error& error) {
      const std::vector<CLI::App*> given = app_.get_subcommands();
      return absl::StrCat("geodesic: ", MessageOf(error), "\nRun geodesic ",
                          given.empty() ? "" : given[0]->get_name() + " ",
                          "--help for more information.\n");
    });
    app_.option_defaults()->always_capture_default();
    AddConnection(&app_, arguments_);
    app_.add_flag("--json", arguments_->json,
                  "Print one JSON object instead of text");
    app_.add_flag("-q,--quiet", arguments_->quiet, "Show no progress");
    app_.add_option("--timeout", arguments_->timeout,
                    "Give up a call to the server after this time")
        ->type_name("SECONDS")
        ->check(CLI::Validator(CLI::PositiveNumber).description(""));
    AddMeshCommands();
    AddQuestions(
        [this](const std::string& name, const std::string& help,
               const std::string& example,
               Command command) { return Add(name, help, example, command); },
        arguments_);
    Add("capabilities", "Show the server's version, algorithms and limits",
        "  geodesic capabilities --json", Command::kCapabilities);
    app_.footer(absl::StrCat(
        "Examples:\n"
        "  geodesic upload horse.ply\n"
        "  geodesic field horse.ply --source 0 -o horse.png -o horse.npy\n"
        "  geodesic path 3f2a91bc --source 0 --target 77 -o path.obj\n"
        "  geodesic --server meshes.example:50051 meshes --json\n\n"
        "Each command has its own --help.\n\n",
        std::string(ExitCodeHelp())));
  }

  CLI::App& app() { return app_; }

 private:
  CLI::App* Add(const std::string& name, const std::string& help,
                const std::string& example, Command command) {
    CLI::App* added = app_.add_subcommand(name, help);
    added->callback([this, command] { arguments_->command = command; });
    added->footer(absl::StrCat(
        "Examples:\n", example,
        "\n\n--server with its TLS and token, --json, --quiet and --timeout "
        "may follow\ntoo: see geodesic --help."));
    return added;
  }

  std::string MessageOf(const CLI::Error& error) const {
    // CLI11 lists these from the last to the first.
    if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr) {
      return absl::StrCat("not expected here: ",
                          absl::StrJoin(app_.remaining(true), " "));
    }
    return error.what();
  }

  void AddMeshCommands() {
    CLI::App* upload = Add("upload", "Make a mesh file resident on the server",
                           "  geodesic upload horse.ply", Command::kUpload);
    upload
        ->add_option("FILE", arguments_->mesh,
                     "A mesh in OBJ, PLY, OFF or STL; sent only if the server "
                     "does not know it")
        ->required()
        ->type_name("");
    AddFormat(upload, arguments_);
    Add("meshes", "List the resident meshes", "  geodesic meshes",
        Command::kMeshes);
    AddMesh(Add("info", "Describe a mesh: counts, topology, size",
                "  geodesic info horse.ply", Command::kInfo),
            arguments_);
    AddMesh(Add("delete", "Drop a mesh from the server",
                "  geodesic delete horse.ply", Command::kDelete),
            "The digest of a resident mesh, of which the first 8 digits do if "
            "they are unique; or the file it came from",
            arguments_);
  }

  Arguments* arguments_;
  CLI::App app_;
};

}  // namespace

std::variant<Arguments, ExitCode> ParseArguments(int argc,
                                                 const char* const* argv,
                                                 std::ostream& out,
                                                 std::ostream& err) {
  Arguments arguments;
  Parser parser(&arguments);
  try {
    parser.app().parse(argc, argv);
    CheckArguments(arguments);
  } catch (const CLI::ParseError& error) {
    return parser.app().exit(error, out, err) == 0 ? ExitCode::kOk
                                                   : ExitCode::kUsage;
  }
  return arguments;
}

}  // namespace geodesic::client
