// Cuts the polygons among the triangles of a soup so that they cover their
// inside once.

#ifndef GEODESIC_POLYGONS_CUT_POLYGONS_H_
#define GEODESIC_POLYGONS_CUT_POLYGONS_H_

#include <vector>

#include "absl/status/status.h"
#include "geodesic/checkpoint.h"
#include "geodesic/triangle_soup.h"

namespace geodesic {

// The polygons of `soup` are fans from their first corners: `is_joined` says of
// a triangle that it belongs to the polygon of the one before it; what it does
// not reach is none. Fans of convex polygons stay as they are, and so do those
// of polygons whose corners lie on a line; the triangles of others are replaced
// (see triangle_soup.h), or counted as crossing.
//
// REQUIRES: the triangles name vertices of the soup. Errors: what the
// checkpoint says, which may be null and is polled every few milliseconds.
absl::Status CutPolygons(const std::vector<bool>& is_joined,
                         Checkpoint* checkpoint, TriangleSoup& soup);

}  // namespace geodesic

#endif  // GEODESIC_POLYGONS_CUT_POLYGONS_H_
