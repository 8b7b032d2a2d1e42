#include "geodesic_client/mesh.h"

#include <array>
#include <bit>

#include "digest/sha256.h"

namespace geodesic::client {
namespace {

// Canonical arrays are little endian, so they are hashed as they lie in memory.
static_assert(std::endian::native == std::endian::little);
static_assert(sizeof(Point) == 24 && sizeof(Triangle) == 12);

constexpr std::string_view kDigestPreamble = "geodesic.mesh.v1\n";

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

}  // namespace geodesic::client
