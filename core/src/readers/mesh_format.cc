#include <array>
#include <string>
#include <string_view>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "absl/strings/ascii.h"
#include "absl/strings/str_cat.h"
#include "geodesic/read_mesh.h"
#include "readers/messages.h"

namespace geodesic {
namespace {

struct FormatName {
  MeshFormat format;
  std::string_view name;
};

constexpr std::array<FormatName, 4> kFormats = {{
    {MeshFormat::kObj, "obj"},
    {MeshFormat::kPly, "ply"},
    {MeshFormat::kOff, "off"},
    {MeshFormat::kStl, "stl"},
}};

}  // namespace

std::string_view MeshFormatName(MeshFormat format) {
  for (const FormatName& known : kFormats) {
    if (known.format == format) return known.name;
  }
  return "unknown";
}

absl::StatusOr<MeshFormat> MeshFormatFromPath(std::string_view path) {
  const size_t slash = path.find_last_of('/');
  const std::string_view file =
      slash == std::string_view::npos ? path : path.substr(slash + 1);
  const size_t dot = file.find_last_of('.');
  if (dot != std::string_view::npos) {
    std::string ending(file.substr(dot + 1));
    absl::AsciiStrToLower(&ending);
    for (const FormatName& known : kFormats) {
      if (ending == known.name) return known.format;
    }
  }
  return absl::InvalidArgumentError(
      absl::StrCat("the ending of '", Printable(path, 200),
                   "' names no mesh format: .obj, .ply, .off and .stl are "
                   "known"));
}

}  // namespace geodesic
