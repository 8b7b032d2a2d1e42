// The command line of `geodesic`.

#ifndef GEODESIC_CLIENT_CLI_ARGUMENTS_H_
#define GEODESIC_CLIENT_CLI_ARGUMENTS_H_

#include <cstdint>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "absl/status/statusor.h"
#include "client/cli/exit_code.h"
#include "client/output/output_format.h"
#include "client/picture/picture.h"
#include "geodesic_client/answer.h"
#include "geodesic_client/connection_options.h"
#include "geodesic_client/mesh.h"
#include "geodesic_client/surface_point.h"

namespace geodesic::client {

enum class Command {
  kUpload,
  kMeshes,
  kInfo,
  kDelete,
  kField,
  kPath,
  kIsolines,
  kMatrix,
  kNearest,
  kSample,
  kLogMap,
  kCapabilities
};

// What --stop-at-targets means without a count.
inline constexpr uint64_t kAllTargets = 0x7fffffffffffffff;

struct OutputArgument {
  std::string path;
  OutputFormat format = OutputFormat::kNpy;
};

struct ConnectionArguments {
  bool tls = false;
  TlsPaths paths;
  std::string server_name;
  std::string token;
  std::string token_file;
  bool no_retry = false;
};

struct Arguments {
  Command command = Command::kCapabilities;
  std::string server;
  ConnectionArguments connection;
  bool json = false;
  bool quiet = false;
  // upload's FILE, or the MESH of the other commands.
  std::string mesh;
  // DEFAULT: what the file's ending says.
  std::optional<MeshFormat> format;

  // Sources are numbered in this order: points, curves, then those of files.
  std::vector<Source> sources;
  std::vector<Source> curves;
  std::vector<std::string> source_files;
  // Likewise.
  std::vector<SurfacePoint> targets;
  std::vector<std::string> target_files;
  std::string algorithm;
  Priority priority = Priority::kInteractive;
  std::optional<double> radius;
  // kAllTargets, or how many.
  std::optional<uint64_t> stop_at_targets;

  bool labels = false;
  bool gradients = false;
  bool float32 = false;
  bool progressive = false;
  std::vector<double> levels;
  // Of levels, members or samples.
  std::optional<uint64_t> count;

  std::vector<OutputArgument> outputs;
  // Seconds.
  std::optional<double> timeout;
  PictureOptions picture;
};

// "AZIMUTH,ELEVATION" in degrees.
// Errors: INVALID_ARGUMENT naming the text, likewise for the next ones.
absl::StatusOr<ViewDirection> ParseView(std::string_view text);

// "WIDTHxHEIGHT" in pixels.
struct PictureSize {
  int width = 0;
  int height = 0;
};
absl::StatusOr<PictureSize> ParseSize(std::string_view text);

// At least 0; "inf" is fine.
absl::StatusOr<double> ParseRadius(std::string_view text);

// Finite, above 0.
absl::StatusOr<double> ParseLevel(std::string_view text);

// At least 1.
absl::StatusOr<uint64_t> ParseCount(std::string_view text);

// The arguments, or how to end at once: after printing help or the version to
// `out`, or what is wrong to `err`.
std::variant<Arguments, ExitCode> ParseArguments(int argc,
                                                 const char* const* argv,
                                                 std::ostream& out,
                                                 std::ostream& err);

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_CLI_ARGUMENTS_H_
