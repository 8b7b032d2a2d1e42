// Options that several commands share, and ways to add options. A function that
// takes `app` adds options to it that write into its last argument. Both must
// outlive the parsing.

#ifndef GEODESIC_CLIENT_CLI_ARGUMENTS_OPTIONS_H_
#define GEODESIC_CLIENT_CLI_ARGUMENTS_OPTIONS_H_

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "client/output/approximation_mark.h"
#include "client/output/output_format.h"
#include "client/picture/picture.h"
#include "client/places/written_place.h"
#include "geodesic_client/answer.h"
#include "geodesic_client/mesh.h"
#include "geodesic_types/mesh_format.h"

// Declared here because CLI11's header takes seconds to compile.
namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace geodesic::client {

struct MeshArgument {
  // A file or a digest.
  std::string text;
  // DEFAULT: the format that the file's ending names.
  std::optional<MeshFormat> format;
  Welding welding;
};

// Whether a question needs places.
enum class Need { kRequired, kOptional };

// Sources are numbered in this order: points, curves, then those listed in
// files.
struct SourceArguments {
  std::vector<WrittenSource> points;
  std::vector<WrittenSource> curves;
  std::vector<std::string> files;
  Need need = Need::kOptional;
};

// Targets are numbered in the same way.
struct TargetArguments {
  std::vector<WrittenPoint> points;
  std::vector<std::string> files;
  Need need = Need::kOptional;
};

struct OutputArgument {
  std::string path;  // kStandardOutput, or that of a file
  OutputFormat format = OutputFormat::kNpy;
};

// The arguments of questions. Each question has options for some of them.
struct QuestionArguments {
  MeshArgument mesh;
  SourceArguments sources;
  TargetArguments targets;
  std::optional<double> radius;
  bool float32 = false;
  // Whether an algorithm may be named.
  bool has_algorithm = true;
  std::string algorithm;
  // Whether the algorithm may be an approximate one. DEFAULT: exact ones alone.
  bool may_be_approximate = false;
  Approximation approximation;
  // Whether a tolerance may be named. DEFAULT: exact answers alone.
  bool may_have_tolerance = false;
  double tolerance = 0;
  // Whether .ply of a .ply is that mesh with the answer added.
  bool adds_to_ply = false;
  // Whether that may take the mesh's place. DEFAULT: outputs replace no file
  // that is read.
  bool in_place = false;
  Priority priority = Priority::kInteractive;
  std::vector<OutputArgument> outputs;
  std::vector<std::string> other_inputs;  // OtherInputs
  PictureOptions picture;

  // How outputs say that they are not exact; empty if they are.
  std::string mark() const {
    return tolerance == 0 ? ApproximationMark(algorithm, approximation)
                          : ToleranceMark(tolerance);
  }
};

// How an option is written and shown.
struct OptionText {
  // "-s,--source", or a word in capitals for a positional argument.
  std::string name;
  std::string help;
  // The kind of its value, as the help shows it; empty for flags.
  std::string type;
  std::string group = "Options";
  bool required = false;
};

// Adds an option that may be repeated. `take` gets each value; if it returns an
// error, the command line is refused.
CLI::Option* AddText(CLI::App* app, const OptionText& text,
                     std::function<absl::Status(const std::string&)> take);

// The same for values that `parse` reads. If `value` is a vector, it keeps all
// of them; otherwise the last mention decides.
template <typename Parse, typename Value>
CLI::Option* AddValue(CLI::App* app, const OptionText& text, Parse parse,
                      Value* value) {
  return AddText(app, text, [=](const std::string& word) {
    auto parsed = parse(word);
    if (!parsed.ok()) return parsed.status();
    if constexpr (requires { value->push_back(*parsed); }) {
      value->push_back(*std::move(parsed));
    } else {
      *value = *std::move(parsed);
    }
    return absl::OkStatus();
  });
}

// Parsers of single values, for AddValue. Errors: INVALID_ARGUMENT naming the
// text.
//
// A distance that is finite and above 0.
absl::StatusOr<double> ParseLevel(std::string_view text);
// A length above 0; "inf" is allowed.
absl::StatusOr<double> ParseChordError(std::string_view text);
// Seconds, above 0; "inf" is allowed.
absl::StatusOr<double> ParseTimeout(std::string_view text);
// "HOST:PORT", "[IPV6]:PORT", or "unix:/PATH".
absl::StatusOr<std::string> ParseServer(std::string_view text);
// A count of at least 1.
absl::StatusOr<uint64_t> ParseCount(std::string_view text);

// Adds an option without a value; `flag` is whether it is given.
void AddFlag(CLI::App* app, const OptionText& text, bool* flag);
// Adds a flag that may have a count from 1. Without a count it means `all`.
void AddFlagOrCount(CLI::App* app, const OptionText& text, int64_t all,
                    std::optional<uint64_t>* count);

// Refuses the command line. To be called while it is parsed or checked.
[[noreturn]] void Refuse(const std::string& option, const std::string& why);
// Whether --json is given. To be called in checks.
bool WantsJson(const CLI::App& app);

// Adds FILE...
void AddFiles(CLI::App* app, const std::string& help,
              std::vector<std::string>* files);
// Adds MESH, as `help` explains it, and how it is read: --format, --weld and
// --no-weld.
inline constexpr char kMeshHelp[] =
    "A mesh file, uploaded if the server lacks it; or the digest of a resident "
    "mesh, of which the first 8 digits do if they are unique";
void AddMesh(CLI::App* app, const std::string& help, MeshArgument* mesh);
void AddReading(CLI::App* app, MeshArgument* mesh);

// How a POINT is written, for help texts.
inline constexpr char kPointHelp[] =
    "VERTEX, edge:A-B@T, face:F@W0,W1,W2, nearest:X,Y,Z (the point of the "
    "surface nearest to this one), min:x, max:z and the like (the vertex with "
    "the least or greatest coordinate) or name:NAME@FILE (what the file lists, "
    "NAME POINT a line)";

// Adds --source for one place without an offset, which `what` names.
void AddSource(CLI::App* app, const std::string& what,
               SourceArguments* sources);
// Adds --source, --curve and --sources.
void AddSources(CLI::App* app, Need need, SourceArguments* sources);
// Adds --target and --targets. `help` says what targets are for.
void AddTargets(CLI::App* app, Need need, const std::string& help,
                TargetArguments* targets);

// Adds --algorithm, --tolerance where the question may have one, --priority and
// -o, whose help is `output_help` followed by
// the endings of `formats`; and --in-place where an answer can be added to
// MESH. After parsing it refuses a question that lacks
// places, reads standard input twice or writes two answers to standard output,
// and then calls `check` if there is one.
void AddQuestion(CLI::App* app, const std::string& output_help,
                 std::span<const OutputFormat> formats,
                 QuestionArguments* question,
                 std::function<void()> check = nullptr);

// Parts of AddQuestion.
//
// Adds --algorithm with these names, which `help` explains.
void AddAlgorithm(CLI::App* app, const std::string& help,
                  const std::vector<std::string>& names,
                  std::string* algorithm);
// Adds --neighbours, --lambda and --samples.
void AddApproximation(CLI::App* app, Approximation* approximation);
// Adds --tolerance.
void AddTolerance(CLI::App* app, double* tolerance);
// Refuses a tolerance beside an approximate algorithm.
void CheckTolerance(double tolerance, const std::string& algorithm);
void AddPriority(CLI::App* app, Priority* priority);
void AddOutputs(CLI::App* app, const std::string& help,
                std::span<const OutputFormat> formats,
                std::vector<OutputArgument>* outputs);
// What the arguments have the command read beside its mesh and lists: files in
// which names of places are looked up, the token's and those of TLS.
std::vector<std::string> OtherInputs(const CLI::App& app);

// Refuses two answers for one file or for standard output. To be called in
// checks.
void CheckOutputs(const CLI::App& app,
                  const std::vector<OutputArgument>& outputs);

void AddRadius(CLI::App* app, const std::string& help,
               std::optional<double>* radius);
void AddFloat32(CLI::App* app, bool* float32);
// Adds --view, --up and --size.
void AddPicture(CLI::App* app, PictureOptions* picture);

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_CLI_ARGUMENTS_OPTIONS_H_
