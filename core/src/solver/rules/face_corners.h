// The vertices of a face, as windows that enter it see them.

#ifndef GEODESIC_SOLVER_RULES_FACE_CORNERS_H_
#define GEODESIC_SOLVER_RULES_FACE_CORNERS_H_

#include <cstdint>

#include "geodesic/mesh.h"

namespace geodesic {

// Of the face left of a half-edge from -> to. As Mesh::From, To and Apex, but
// looks at the face once.
struct FaceCorners {
  uint32_t from, to, apex;

  FaceCorners(const Mesh& mesh, HalfEdge h) {
    const Triangle& corners = mesh.TriangleOf(h);
    const uint32_t side = h % 3;
    from = corners[side];
    to = corners[side == 2 ? 0 : side + 1];
    apex = corners[side == 0 ? 2 : side - 1];
  }
};

}  // namespace geodesic

#endif  // GEODESIC_SOLVER_RULES_FACE_CORNERS_H_
