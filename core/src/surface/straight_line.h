// Straight lines through space: no path on the surface is shorter.

#ifndef GEODESIC_SURFACE_STRAIGHT_LINE_H_
#define GEODESIC_SURFACE_STRAIGHT_LINE_H_

#include <cmath>
#include <cstdint>

#include "geodesic/mesh.h"
#include "geodesic/surface_point.h"
#include "mesh/scaled_difference.h"

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

}  // namespace geodesic

#endif  // GEODESIC_SURFACE_STRAIGHT_LINE_H_
