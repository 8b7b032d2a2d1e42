// The name of a mesh: the digest of its canonical arrays.

#ifndef GEODESIC_SERVER_ENGINE_MESH_DIGEST_H_
#define GEODESIC_SERVER_ENGINE_MESH_DIGEST_H_

#include <span>
#include <string>

#include "geodesic/triangle_soup.h"

namespace geodesic::server {

// The lower-case hexadecimal sha-256 of the canonical arrays, as the head of
// proto/geodesic/v1/mesh.proto defines it. O(V + F). Thread-safe.
std::string MeshDigest(std::span<const Point> positions,
                       std::span<const Triangle> triangles);

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_MESH_DIGEST_H_
