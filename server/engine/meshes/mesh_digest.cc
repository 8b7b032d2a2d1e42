#include "server/engine/meshes/mesh_digest.h"

#include <array>
#include <cstdint>

#include "digest/sha256.h"
#include "server/engine/base/binary_codec.h"

namespace geodesic::server {
namespace {

// The arrays are hashed as they lie in memory.
static_assert(sizeof(Point) == 24 && sizeof(Triangle) == 12);

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
  head += AsBytes(counts);
  return head;
}

}  // namespace geodesic::server
