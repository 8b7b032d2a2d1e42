// The pieces of a query's sources that windows start from.

#ifndef GEODESIC_SURFACE_ANCHORS_H_
#define GEODESIC_SURFACE_ANCHORS_H_

#include <cstdint>
#include <optional>
#include <vector>

#include "geodesic/mesh.h"
#include "geodesic/surface_point.h"
#include "geodesic/valid_query.h"
#include "surface/plane_point.h"

namespace geodesic {

// A point, or a straight segment within a face.
struct Anchor {
  SurfacePoint begin;
  SurfacePoint end;  // of a segment; begin again for a point
  bool is_segment = false;
  double offset = 0;    // in the unit of the file
  uint32_t source = 0;  // its number
};

// All anchors of a query, in the order in which Arrival counts them: source
// after source, a point as one, a curve as its points and then its segments.
std::vector<Anchor> AnchorsOf(const ValidQuery& query);

// Where on an anchor the shortest path to a place in the face of h starts, as a
// point of that face: the point itself, or the foot of the perpendicular on a
// segment; nothing if the anchor does not lie in the face. `place` is in the
// frame of h.
std::optional<FacePoint> FootOf(const Mesh& mesh, const Anchor& anchor,
                                HalfEdge h, const PlanePoint& place);

}  // namespace geodesic

#endif  // GEODESIC_SURFACE_ANCHORS_H_
