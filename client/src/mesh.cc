#include "geodesic_client/mesh.h"

#include <algorithm>
#include <bit>
#include <cctype>

#include "absl/status/status.h"
#include "absl/strings/str_cat.h"
#include "sha256.h"

namespace geodesic::client {
namespace {

// Canonical arrays are little endian; they are hashed as they lie in memory.
static_assert(std::endian::native == std::endian::little);
static_assert(sizeof(Point) == 24 && sizeof(Triangle) == 12);

constexpr std::string_view kDigestPreamble = "geodesic.mesh.v1\n";

constexpr std::array kFormats = {MeshFormat::kObj, MeshFormat::kPly,
                                 MeshFormat::kOff, MeshFormat::kStl};

}  // namespace

std::string MeshDigest(const MeshArrays& mesh) {
  const std::array<uint64_t, 2> counts = {mesh.positions.size(),
                                          mesh.triangles.size()};
  Sha256 hash;
  hash.Update(kDigestPreamble.data(), kDigestPreamble.size());
  hash.Update(counts.data(), sizeof(counts));
  hash.Update(mesh.positions.data(), mesh.positions.size() * sizeof(Point));
  hash.Update(mesh.triangles.data(), mesh.triangles.size() * sizeof(Triangle));
  return hash.FinishHex();
}

bool IsMeshDigest(std::string_view text) {
  return text.size() == 64 && std::ranges::all_of(text, [](char c) {
           return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f');
         });
}

std::string_view MeshFormatName(MeshFormat format) {
  switch (format) {
    case MeshFormat::kObj:
      return "obj";
    case MeshFormat::kPly:
      return "ply";
    case MeshFormat::kOff:
      return "off";
    case MeshFormat::kStl:
      return "stl";
  }
  return "unknown";
}

absl::StatusOr<MeshFormat> MeshFormatFromPath(std::string_view path) {
  const size_t dot = path.find_last_of("./");
  if (dot != std::string_view::npos && path[dot] == '.') {
    std::string ending(path.substr(dot + 1));
    std::ranges::transform(ending, ending.begin(), [](unsigned char c) {
      return static_cast<char>(std::tolower(c));
    });
    for (MeshFormat format : kFormats) {
      if (ending == MeshFormatName(format)) return format;
    }
  }
  return absl::InvalidArgumentError(
      absl::StrCat("cannot tell the format of ", std::string(path),
                   " by its ending; known are .obj, .ply, .off and .stl"));
}

}  // namespace geodesic::client
