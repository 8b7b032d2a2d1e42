#include "server/engine/meshes/mesh_digest.h"

#include <array>
#include <bit>
#include <cstdint>
#include <string_view>

#include "digest/sha256.h"

namespace geodesic::server {
namespace {

// The arrays are hashed as they lie in memory.
static_assert(std::endian::native == std::endian::little);
static_assert(sizeof(Point) == 24 && sizeof(Triangle) == 12);

template <typename T>
std::string_view AsBytes(std::span<const T> values) {
  return {reinterpret_cast<const char*>(values.data()), values.size_bytes()};
}

}  // namespace

std::string MeshDigest(std::span<const Point> positions,
                       std::span<const Triangle> triangles) {
  Sha256 hash;
  hash.Update(MeshDigestHead(positions.size(), triangles.size()));
  hash.Update(AsBytes(positions));
  hash.Update(AsBytes(triangles));
  return hash.FinishHex();
}

std::string MeshDigestHead(uint64_t vertices, uint64_t faces) {
  const std::array<uint64_t, 2> counts = {vertices, faces};
  std::string head("geodesic.mesh.v1\n");
  head += AsBytes(std::span<const uint64_t>(counts));
  return head;
}

}  // namespace geodesic::server
