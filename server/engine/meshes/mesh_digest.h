// The name of a mesh: the digest of its canonical arrays.

#ifndef GEODESIC_SERVER_ENGINE_MESHES_MESH_DIGEST_H_
#define GEODESIC_SERVER_ENGINE_MESHES_MESH_DIGEST_H_

#include <cstdint>
#include <span>
#include <string>

#include "geodesic/triangle_soup.h"

namespace geodesic::server {

// The lower-case hexadecimal sha-256 of the canonical arrays, as the head of
// proto/geodesic/v1/mesh.proto defines it. O(V + F). Thread-safe.
std::string MeshDigest(std::span<const Point> positions,
                       std::span<const Triangle> triangles);

// What the digest covers before the arrays: a tag and the two counts.
std::string MeshDigestHead(uint64_t vertices, uint64_t faces);

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_MESHES_MESH_DIGEST_H_
