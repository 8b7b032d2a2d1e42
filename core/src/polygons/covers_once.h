// Whether a polygon covers what is inside it once.

#ifndef GEODESIC_POLYGONS_COVERS_ONCE_H_
#define GEODESIC_POLYGONS_COVERS_ONCE_H_

#include "polygons/flat_polygon.h"
#include "polygons/pace.h"

namespace geodesic {

// Whether the polygon winds around each point of the plane once, to the left,
// or not at all. It may touch itself at corners and along sides, such as a
// bridge to a hole, but not cross itself, nor go round twice. What rounding may
// have moved (kStraightCorner) touches. False also if `pace` stops.
//
// O(n log n), with up to 18 bytes a corner.
bool CoversOnce(const FlatPolygon& polygon, Pace& pace);

}  // namespace geodesic

#endif  // GEODESIC_POLYGONS_COVERS_ONCE_H_
