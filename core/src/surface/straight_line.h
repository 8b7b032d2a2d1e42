// Straight lines and directions in space. No path on the surface is shorter
// than the straight line.

#ifndef GEODESIC_SURFACE_STRAIGHT_LINE_H_
#define GEODESIC_SURFACE_STRAIGHT_LINE_H_

#include <cmath>
#include <cstdint>

#include "geodesic/mesh.h"
#include "geodesic/surface_point.h"
#include "mesh/scaled_difference.h"
#include "surface/plane_point.h"

namespace geodesic {

// A point in space: a vertex, and the way from there in the scaled unit. Of the
// corners around a surface point it is the one with the largest weight, so that
// a point very near a vertex keeps the digits of its distance from there.
struct SpacePoint {
  uint32_t vertex = 0;
  Vector beyond = {};
};

SpacePoint InSpace(const Mesh& mesh, const SurfacePoint& point);

// How far two points are apart in space, in the scaled unit.
inline double StraightDistance(const Mesh& mesh, const SpacePoint& a,
                               const SpacePoint& b) {
  const ScaledDifference difference(mesh.scale_exponent());
  Vector way =
      difference(mesh.positions()[a.vertex], mesh.positions()[b.vertex]);
  for (int i = 0; i < 3; ++i) way[i] += b.beyond[i] - a.beyond[i];
  return Norm(way);
}

// A unit vector along `v`; the zero vector if `v` has no length.
Point Normalized(const Point& v);

// The unit vector from one vertex to another; the zero vector if they coincide.
Point DirectionBetween(const Mesh& mesh, uint32_t from, uint32_t to);

// The unit vector in space of a direction in the frame of h. In a face without
// area only what lies along h is left of it.
Point DirectionInSpace(const Mesh& mesh, HalfEdge h,
                       const PlanePoint& direction);

}  // namespace geodesic

#endif  // GEODESIC_SURFACE_STRAIGHT_LINE_H_
