#include "client/cli/arguments.h"

#include <CLI/CLI.hpp>
#include <map>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"
#include "client/cli/help_formatter.h"

namespace geodesic::client {
namespace {

constexpr char kDefaultServer[] = "127.0.0.1:50051";

constexpr char kMeshHelp[] =
    "A mesh file, uploaded if the server lacks it; or the digest of a resident "
    "mesh, of which the first 8 digits do if they are unique";

const std::map<std::string, MeshFormat>& FormatNames() {
  static const auto& names =
      *new std::map<std::string, MeshFormat>{{"obj", MeshFormat::kObj},
                                             {"ply", MeshFormat::kPly},
                                             {"off", MeshFormat::kOff},
                                             {"stl", MeshFormat::kStl}};
  return names;
}

// An option whose text goes through `parse`, which may say what is wrong.
template <typename Parse, typename Accept>
CLI::Option* AddParsed(CLI::App* app, const std::string& name,
                       const std::string& help, Parse parse, Accept accept) {
  return app
      ->add_option_function<std::vector<std::string>>(
          name,
          [name, parse, accept](const std::vector<std::string>& texts) {
            for (const std::string& text : texts) {
              auto value = parse(text);
              if (!value.ok()) {
                throw CLI::ValidationError(
                    name, std::string(value.status().message()));
              }
              accept(text, *std::move(value));
            }
          },
          help)
      // One value after each mention: what follows may be MESH.
      ->allow_extra_args(false);
}

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
    app_.failure_message([](const CLI::App*, const CLI::Error& error) {
      return absl::StrCat("geodesic: ", error.what(),
                          "\nRun it with --help for more information.\n");
    });
    app_.option_defaults()->always_capture_default();
    arguments_->server = kDefaultServer;
    app_.add_option("--server", arguments_->server, "Where the server listens")
        ->type_name("HOST:PORT")
        ->envname("GEODESIC_SERVER");
    app_.add_flag("--json", arguments_->json,
                  "Print one JSON object instead of text");
    app_.add_flag("-q,--quiet", arguments_->quiet, "Show no progress");
    app_.add_option("--timeout", arguments_->timeout,
                    "Give up a call to the server after this time")
        ->type_name("SECONDS")
        ->check(CLI::Validator(CLI::PositiveNumber).description(""));
    AddUpload();
    AddMeshes();
    AddInfo();
    AddDelete();
    AddField();
    AddCapabilities();
    app_.footer(absl::StrCat(
        "Examples:\n"
        "  geodesic upload horse.ply\n"
        "  geodesic field horse.ply --source 0 -o horse.png -o horse.npy\n"
        "  geodesic field 3f2a91bc --source 0 --source 77:0.5 -o d.csv\n"
        "  geodesic --server meshes.example:50051 meshes --json\n\n"
        "Each command has its own --help.\n\n",
        std::string(ExitCodeHelp())));
  }

  CLI::App& app() { return app_; }

 private:
  CLI::App* Add(const std::string& name, const std::string& help,
                Command command) {
    CLI::App* added = app_.add_subcommand(name, help);
    added->callback([this, command] { arguments_->command = command; });
    added->footer(
        "--server, --json, --quiet and --timeout may follow too: see "
        "geodesic --help.");
    return added;
  }

  void AddFormat(CLI::App* command) {
    command
        ->add_option_function<std::string>(
            "--format",
            [this](const std::string& name) {
              arguments_->format = FormatNames().at(name);
            },
            "How to read the file, if its ending does not tell")
        ->type_name("obj|ply|off|stl")
        ->check(CLI::IsMember(FormatNames()).description(""));
  }

  void AddMesh(CLI::App* command, const std::string& help) {
    command->add_option("MESH", arguments_->mesh, help)
        ->required()
        ->type_name("");
    AddFormat(command);
  }

  void AddUpload() {
    CLI::App* command = Add("upload", "Make a mesh file resident on the server",
                            Command::kUpload);
    command
        ->add_option("FILE", arguments_->mesh,
                     "A mesh in OBJ, PLY, OFF or STL; sent only if the server "
                     "does not know it")
        ->required()
        ->type_name("");
    AddFormat(command);
  }

  void AddMeshes() {
    Add("meshes", "List the resident meshes", Command::kMeshes);
  }

  void AddInfo() {
    AddMesh(Add("info", "Describe a mesh", Command::kInfo), kMeshHelp);
  }

  void AddDelete() {
    AddMesh(Add("delete", "Drop a mesh from the server", Command::kDelete),
            "The digest of a resident mesh, of which the first 8 digits do if "
            "they are unique; or the file it came from");
  }

  void AddField() {
    CLI::App* command =
        Add("field", "Compute the geodesic distance to every vertex",
            Command::kField);
    AddMesh(command, kMeshHelp);
    AddParsed(command, "-s,--source",
              "Measure from this vertex (0-based), which starts with OFFSET "
              "(default 0); may be repeated",
              ParseSource,
              [this](const std::string&, Source source) {
                arguments_->sources.push_back(source);
              })
        ->required()
        ->type_name("VERTEX[:OFFSET]");
    command
        ->add_option("-a,--algorithm", arguments_->algorithm,
                     "How windows are propagated; all give the same distances. "
                     "Default: the server's choice")
        ->type_name(absl::StrJoin(AlgorithmNames(), "|"))
        ->check(CLI::IsMember(AlgorithmNames()).description(""));
    AddParsed(command, "-o,--output",
              absl::StrCat("Write the field here; may be repeated. The ending "
                           "says what: ",
                           OutputEndings(), " (a picture)"),
              OutputFormatFromPath,
              [this](const std::string& path, OutputFormat format) {
                arguments_->outputs.push_back({path, format});
              })
        ->type_name("FILE");
    AddPicture(command);
  }

  void AddPicture(CLI::App* command) {
    AddParsed(command, "--view",
              "Direction the picture is seen from, in degrees; default: one "
              "that shows much of the mesh and the first source",
              ParseView,
              [this](const std::string&, ViewDirection view) {
                arguments_->picture.direction = view;
              })
        ->type_name("AZIMUTH,ELEVATION")
        ->group("Picture");
    command
        ->add_option_function<std::string>(
            "--up",
            [this](const std::string& axis) {
              arguments_->picture.up = axis == "z" ? UpAxis::kZ : UpAxis::kY;
            },
            "Axis that points up in the picture; default: guessed")
        ->type_name("y|z")
        ->check(CLI::IsMember({"y", "z"}).description(""))
        ->group("Picture");
    AddParsed(command, "--size", "Size of the picture; default: 1600x1200",
              ParseSize,
              [this](const std::string&, PictureSize size) {
                arguments_->picture.width = size.width;
                arguments_->picture.height = size.height;
              })
        ->type_name("WIDTHxHEIGHT")
        ->group("Picture");
  }

  void AddCapabilities() {
    Add("capabilities", "Show the server's version, algorithms and limits",
        Command::kCapabilities);
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
  } catch (const CLI::ParseError& error) {
    return parser.app().exit(error, out, err) == 0 ? ExitCode::kOk
                                                   : ExitCode::kUsage;
  }
  return arguments;
}

}  // namespace geodesic::client
