// Polylines in the plane as sources, and the distances from them.

#ifndef GEODESIC_TESTS_SUPPORT_ORACLES_PLANAR_ORACLES_H_
#define GEODESIC_TESTS_SUPPORT_ORACLES_PLANAR_ORACLES_H_

#include <array>
#include <vector>

#include "geodesic/query.h"
#include "geodesic/triangle_soup.h"

namespace geodesic::test {

// A polyline in the plane z = 0, as a source.
struct PlanarCurve {
  std::vector<std::array<double, 2>> corners;
  double offset = 0;
};

// The place in the plane as a point of the mesh: on a vertex or an edge if it
// is there to a rounding, else in a face. REQUIRES: as OnMesh.
SurfacePoint Locate(const TriangleSoup& soup, const std::array<double, 2>& p);

// Euclid's distance from p, plus the offset.
double DistanceTo(const PlanarCurve& curve, const Point& p);

// The curve as points of the mesh: its corners, and where it crosses edges.
// REQUIRES: the mesh lies in the plane z = 0 and covers the curve.
Source OnMesh(const TriangleSoup& soup, const PlanarCurve& curve);

}  // namespace geodesic::test

#endif  // GEODESIC_TESTS_SUPPORT_ORACLES_PLANAR_ORACLES_H_
