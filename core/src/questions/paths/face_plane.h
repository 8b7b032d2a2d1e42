// From the frame of a half-edge into space.

#ifndef GEODESIC_QUESTIONS_PATHS_FACE_PLANE_H_
#define GEODESIC_QUESTIONS_PATHS_FACE_PLANE_H_

#include "geodesic/mesh.h"
#include "geodesic/triangle_soup.h"
#include "surface/surface_location.h"

namespace geodesic {

// A unit vector along `v`; the zero vector if `v` has no length.
Point Normalized(const Point& v);

// The unit vector in space along the edge or face diagonal from one vertex to
// another; the zero vector if they coincide.
Point DirectionBetween(const Mesh& mesh, uint32_t from, uint32_t to);

// The unit vector in space of a direction in the frame of h. In a face without
// area only what lies along h is left of it.
Point DirectionInSpace(const Mesh& mesh, HalfEdge h,
                       const PlanePoint& direction);

}  // namespace geodesic

#endif  // GEODESIC_QUESTIONS_PATHS_FACE_PLANE_H_
