// The name of a mesh: the digest of its canonical arrays.

#ifndef GEODESIC_SERVER_ENGINE_MESHES_MESH_DIGEST_H_
#define GEODESIC_SERVER_ENGINE_MESHES_MESH_DIGEST_H_

#include <array>
#include <cstdint>
#include <span>
#include <string>

#include "digest/sha256.h"
#include "geodesic/triangle_soup.h"
#include "server/engine/base/binary_codec.h"

namespace geodesic::server {

// The arrays are hashed as they lie in memory.
static_assert(sizeof(Point) == 24 && sizeof(Triangle) == 12);

// The bytes that the digest covers before the arrays: a tag and the two counts.
inline std::string MeshDigestHead(uint64_t vertices, uint64_t faces) {
  const std::array<uint64_t, 2> counts = {vertices, faces};
  std::string head("geodesic.mesh.v1\n");
  head += AsBytes(counts);
  return head;
}

// The lower-case hexadecimal sha-256 of the canonical arrays, as the head of
// proto/geodesic/v1/mesh.proto defines it. O(V + F). Thread-safe.
inline std::string MeshDigest(std::span<const Point> positions,
                              std::span<const Triangle> triangles) {
  Sha256 hash;
  hash.Update(MeshDigestHead(positions.size(), triangles.size()));
  hash.Update(AsBytes(positions));
  hash.Update(AsBytes(triangles));
  return hash.FinishHex();
}

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_MESHES_MESH_DIGEST_H_
