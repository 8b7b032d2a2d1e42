// Where on an anchor the shortest path to a place of its face starts.

#ifndef GEODESIC_QUESTIONS_PATHS_ANCHOR_FOOT_H_
#define GEODESIC_QUESTIONS_PATHS_ANCHOR_FOOT_H_

#include <optional>

#include "geodesic/mesh.h"
#include "geodesic/surface_point.h"
#include "surface/anchors.h"
#include "surface/plane_point.h"

namespace geodesic {

// The point itself, or the foot of the perpendicular on a segment, as a point
// of the face of h; nothing if the anchor does not lie in that face. `place` is
// in the frame of h.
std::optional<FacePoint> FootOf(const Mesh& mesh, const Anchor& anchor,
                                HalfEdge h, const PlanePoint& place);

}  // namespace geodesic

#endif  // GEODESIC_QUESTIONS_PATHS_ANCHOR_FOOT_H_
