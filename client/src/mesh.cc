#include "geodesic_client/mesh.h"

#include <algorithm>
#include <array>
#include <bit>

#include "absl/status/status.h"
#include "absl/strings/ascii.h"
#include "absl/strings/match.h"
#include "absl/strings/str_cat.h"
#include "digest/sha256.h"

namespace geodesic::client {
namespace {

// Canonical arrays are little endian, so they are hashed as they lie in memory.
static_assert(std::endian::native == std::endian::little);
static_assert(sizeof(Point) == 24 && sizeof(Triangle) == 12);

constexpr std::string_view kDigestPreamble = "geodesic.mesh.v1\n";

// Indexed by MeshFormat.
constexpr std::array<std::string_view, 7> kFormatNames = {
    "obj", "ply", "off", "stl", "vtk", "gltf", "vtp"};

template <typename Items>
std::string_view BytesOf(const Items& items) {
  return {reinterpret_cast<const char*>(items.data()),
          items.size() * sizeof(items[0])};
}

}  // namespace

std::string MeshDigest(const MeshArrays& mesh) {
  const std::array<uint64_t, 2> counts = {mesh.positions.size(),
                                          mesh.triangles.size()};
  Sha256 hash;
  hash.Update(kDigestPreamble);
  hash.Update(BytesOf(counts));
  hash.Update(BytesOf(mesh.positions));
  hash.Update(BytesOf(mesh.triangles));
  return hash.FinishHex();
}

bool IsMeshDigest(std::string_view text) { return IsSha256Hex(text); }

std::string_view MeshFormatName(MeshFormat format) {
  return kFormatNames.at(static_cast<size_t>(format));
}

absl::StatusOr<MeshFormat> MeshFormatFromPath(std::string_view whole_path) {
  std::string_view path = whole_path;
  if (absl::EndsWithIgnoreCase({path.data(), path.size()}, ".gz")) {
    path.remove_suffix(3);
  }
  const size_t dot = path.find_last_of("./");
  if (dot != std::string_view::npos && path[dot] == '.') {
    const std::string ending =
        absl::AsciiStrToLower(std::string(path.substr(dot + 1)));
    if (ending == "glb") return MeshFormat::kGltf;
    const auto* name = std::ranges::find(kFormatNames, ending);
    if (name != kFormatNames.end()) {
      return static_cast<MeshFormat>(name - kFormatNames.begin());
    }
  }
  return absl::InvalidArgumentError(absl::StrCat(
      "cannot tell the format of ", std::string(whole_path),
      " by its ending; known are .obj, .ply, .off, .stl, .vtk, .vtp, "
      ".glb and .gltf, and the same with .gz behind"));
}

}  // namespace geodesic::client
