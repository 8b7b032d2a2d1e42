// Cuts a polygon into triangles that lie inside it.

#ifndef GEODESIC_POLYGONS_EARS_H_
#define GEODESIC_POLYGONS_EARS_H_

#include <span>

#include "geodesic/triangle_soup.h"
#include "polygons/flat_polygon.h"
#include "polygons/pace.h"

namespace geodesic {

// Writes the triangles of a polygon that CoversOnce: they turn left, lie beside
// each other and cover it. Some have no area, where corners lie on a line or
// the polygon touches itself. Which they are does not depend on the corner that
// the polygon begins with. False, with nothing written, if `pace` stops or
// rounding leaves no way to go on.
//
// O(n log n) for usual shapes, O(n^2) at the worst, with up to 21 bytes a
// corner. REQUIRES: `triangles` has two fewer than the polygon corners.
bool CutEars(const FlatPolygon& polygon, Pace& pace,
             std::span<Triangle> triangles);

}  // namespace geodesic

#endif  // GEODESIC_POLYGONS_EARS_H_
