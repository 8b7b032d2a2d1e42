// The command line of `geodesic`.

#ifndef GEODESIC_CLIENT_CLI_ARGUMENTS_H_
#define GEODESIC_CLIENT_CLI_ARGUMENTS_H_

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
#include "geodesic_client/field.h"
#include "geodesic_client/mesh.h"

namespace geodesic::client {

enum class Command { kUpload, kMeshes, kInfo, kDelete, kField, kCapabilities };

struct OutputArgument {
  std::string path;
  OutputFormat format = OutputFormat::kNpy;
};

struct Arguments {
  Command command = Command::kCapabilities;
  std::string server;
  bool json = false;
  bool quiet = false;
  // upload's FILE, or the MESH of info, delete and field.
  std::string mesh;
  // DEFAULT: what the file's ending says.
  std::optional<MeshFormat> format;
  std::vector<Source> sources;
  std::string algorithm;
  std::vector<OutputArgument> outputs;
  // Seconds.
  std::optional<double> timeout;
  PictureOptions picture;
};

// "V" or "V:OFFSET".
// Errors: INVALID_ARGUMENT naming the text, likewise for the next two.
absl::StatusOr<Source> ParseSource(std::string_view text);

// "AZIMUTH,ELEVATION" in degrees.
absl::StatusOr<ViewDirection> ParseView(std::string_view text);

// "WIDTHxHEIGHT" in pixels.
struct PictureSize {
  int width = 0;
  int height = 0;
};
absl::StatusOr<PictureSize> ParseSize(std::string_view text);

// The arguments, or how to end at once: after printing help or the version to
// `out`, or what is wrong to `err`.
std::variant<Arguments, ExitCode> ParseArguments(int argc,
                                                 const char* const* argv,
                                                 std::ostream& out,
                                                 std::ostream& err);

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_CLI_ARGUMENTS_H_
