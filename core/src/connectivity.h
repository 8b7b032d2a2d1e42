// Which half-edges lie on the two sides of an edge.

#ifndef GEODESIC_CONNECTIVITY_H_
#define GEODESIC_CONNECTIVITY_H_

#include <cstdint>
#include <span>
#include <vector>

#include "absl/status/statusor.h"
#include "geodesic/mesh.h"

namespace geodesic {

// The twin of each half-edge 3f + i, kNoHalfEdge at a boundary.
// REQUIRES: indices below vertex_count, no face repeats a vertex.
// Errors: INVALID_ARGUMENT naming an edge with three faces or more and those
// faces, or two faces that run along an edge in the same direction.
// O(V + F log F) time whatever the valence (OpenMesh's add_face walks around
// vertices, which is quadratic in the valence of a hostile fan).
absl::StatusOr<std::vector<HalfEdge>> FindTwins(
    std::span<const Triangle> triangles, uint32_t vertex_count);

}  // namespace geodesic

#endif  // GEODESIC_CONNECTIVITY_H_
