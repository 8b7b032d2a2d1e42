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
static_assert(sizeof(Point) == 24 && sizeof(Triangle) == 12 &&
              sizeof(JoinedVertex) == 8);

// The bytes that the digest covers before the arrays: a tag and the two counts.
inline std::string MeshDigestHead(uint64_t vertices, uint64_t faces) {
  const std::array<uint64_t, 2> counts = {vertices, faces};
  std::string head("geodesic.mesh.v1\n");
  head += AsBytes(counts);
  return head;
}

// The numbers that the digest covers behind the arrays, but for the joined
// vertices; none if nothing was joined or guessed.
inline std::string MeshDigestTail(const Reading& reading) {
  if (reading.is_plain()) return {};
  const std::array<uint64_t, 4> numbers = {
      reading.seam_edges, reading.crossing_polygons,
      reading.first_crossing_polygon, reading.joined.size()};
  return std::string(AsBytes(numbers));
}

// The lower-case hexadecimal sha-256 of the canonical arrays and what was
// joined, as the head of proto/geodesic/v1/mesh.proto defines it. O(V + F).
// Thread-safe.
inline std::string MeshDigest(const TriangleSoup& soup) {
  Sha256 hash;
  hash.Update(MeshDigestHead(soup.positions.size(), soup.triangles.size()));
  hash.Update(AsBytes(soup.positions));
  hash.Update(AsBytes(soup.triangles));
  hash.Update(MeshDigestTail(soup.reading));
  hash.Update(AsBytes(soup.reading.joined));
  return hash.FinishHex();
}

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_MESHES_MESH_DIGEST_H_
