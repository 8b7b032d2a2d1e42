// Where on an anchor the shortest path to a place of its face starts.

#ifndef GEODESIC_PATHS_ANCHOR_FOOT_H_
#define GEODESIC_PATHS_ANCHOR_FOOT_H_

#include <optional>

#include "anchors.h"
#include "geodesic/mesh.h"
#include "geodesic/surface_point.h"
#include "windows/plane_point.h"

namespace geodesic {

// The point itself, or the foot of the perpendicular on a segment, as a point
// of the face of h; nothing if the anchor does not lie in that face. `place` is
// in the frame of h.
std::optional<FacePoint> FootOf(const Mesh& mesh, const Anchor& anchor,
                                HalfEdge h, const PlanePoint& place);

}  // namespace geodesic

#endif  // GEODESIC_PATHS_ANCHOR_FOOT_H_
