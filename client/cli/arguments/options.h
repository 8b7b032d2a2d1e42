// Options, and what several commands share of them. Each function adds to `app`
// what writes into its last argument, both of which outlive the parsing.

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
#include "client/output/output_format.h"
#include "client/picture/picture.h"
#include "geodesic_client/answer.h"
#include "geodesic_client/mesh.h"
#include "geodesic_client/surface_point.h"

// Of CLI11, whose header takes seconds to compile.
namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace geodesic::client {

struct MeshArgument {
  // A file or a digest.
  std::string text;
  // DEFAULT: what the file's ending says.
  std::optional<MeshFormat> format;
};

// Whether a question must be given places.
enum class Need { kRequired, kOptional };

// Numbered in this order: points, curves, then those of files.
struct SourceArguments {
  std::vector<Source> points;
  std::vector<Source> curves;
  std::vector<std::string> files;
  Need need = Need::kOptional;
};

// Likewise.
struct TargetArguments {
  std::vector<SurfacePoint> points;
  std::vector<std::string> files;
  Need need = Need::kOptional;
};

struct OutputArgument {
  std::string path;
  OutputFormat format = OutputFormat::kNpy;
};

// What questions are given; each has options for some of it.
struct QuestionArguments {
  MeshArgument mesh;
  SourceArguments sources;
  TargetArguments targets;
  std::optional<double> radius;
  bool float32 = false;
  std::string algorithm;
  Priority priority = Priority::kInteractive;
  std::vector<OutputArgument> outputs;
  PictureOptions picture;
};

// How an option is written and shown.
struct OptionText {
  // "-s,--source", or a word in capitals for what has no name.
  std::string name;
  std::string help;
  // What its value is; flags have none.
  std::string type;
  std::string group = "Options";
  bool required = false;
};

// An option that may be repeated; `take` may say what is wrong with a value.
CLI::Option* AddText(CLI::App* app, const OptionText& text,
                     std::function<absl::Status(const std::string&)> take);

// The same for a value that goes through `parse`: the last mention decides, or
// all values are kept if `value` is a vector of them.
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

// What single options may say, for AddValue.
// Errors: INVALID_ARGUMENT naming the text.
//
// A distance: finite, above 0.
absl::StatusOr<double> ParseLevel(std::string_view text);
// Seconds above 0; "inf" is fine.
absl::StatusOr<double> ParseTimeout(std::string_view text);
// "HOST:PORT", or "[IPV6]:PORT".
absl::StatusOr<std::string> ParseServer(std::string_view text);
// At least 1.
absl::StatusOr<uint64_t> ParseCount(std::string_view text);

// An option that is there or not.
void AddFlag(CLI::App* app, const OptionText& text, bool* flag);
// A flag that may have a count from 1; without one it is `all`.
void AddFlagOrCount(CLI::App* app, const OptionText& text, int64_t all,
                    std::optional<uint64_t>* count);

// Refuses the command line, in a check.
[[noreturn]] void Refuse(const std::string& option, const std::string& why);
// Whether --json is given. For checks.
bool WantsJson(const CLI::App& app);

// FILE...
void AddFiles(CLI::App* app, const std::string& help,
              std::vector<std::string>* files);
// MESH, as `help` explains it, and --format.
inline constexpr char kMeshHelp[] =
    "A mesh file, uploaded if the server lacks it; or the digest of a resident "
    "mesh, of which the first 8 digits do if they are unique";
void AddMesh(CLI::App* app, const std::string& help, MeshArgument* mesh);
void AddFormat(CLI::App* app, std::optional<MeshFormat>* format);

// --source, --curve, --sources.
void AddSources(CLI::App* app, Need need, SourceArguments* sources);
// --target, --targets; `help` says what targets are for.
void AddTargets(CLI::App* app, Need need, const std::string& help,
                TargetArguments* targets);

// --algorithm, --priority and -o, whose `output_help` begins the sentence that
// the endings end. When all of the command line has been taken, refuses a
// question without the places it needs or that reads standard input twice, then
// calls `check` if there is one.
void AddQuestion(CLI::App* app, const std::string& output_help,
                 std::span<const OutputFormat> formats,
                 QuestionArguments* question,
                 std::function<void()> check = nullptr);

void AddRadius(CLI::App* app, const std::string& help,
               std::optional<double>* radius);
void AddFloat32(CLI::App* app, bool* float32);
// --view, --up, --size.
void AddPicture(CLI::App* app, PictureOptions* picture);

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_CLI_ARGUMENTS_OPTIONS_H_
