// Distances in the plane: from polylines, and around obstacles.

#ifndef GEODESIC_TESTS_SUPPORT_ORACLES_PLANAR_ORACLES_H_
#define GEODESIC_TESTS_SUPPORT_ORACLES_PLANAR_ORACLES_H_

#include <array>
#include <span>
#include <vector>

#include "geodesic/query.h"
#include "geodesic/triangle_soup.h"
#include "tests/support/planar_meshes.h"
#include "tests/support/vec.h"

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

// Shortest paths in a rectangle with rectangular obstacles, by the visibility
// graph of the obstacles' corners. A shortest path among polygonal obstacles is
// a polyline that bends at their corners only.
class PlanarDomain {
 public:
  // The domain that MakeGrid(options) triangulates.
  // REQUIRES: the removed rectangles do not touch each other.
  explicit PlanarDomain(const GridOptions& options);

  // Shortest distances in the domain from `source` to each of `targets`.
  // O((corners + targets) * corners * obstacles).
  std::vector<double> Distances(const Point& source,
                                std::span<const Point> targets) const;

 private:
  struct Rect {
    Real x0, y0, x1, y1;
  };

  bool Visible(Vec2 a, Vec2 b) const;

  std::vector<Rect> obstacles_;
  std::vector<Vec2> corners_;
};

}  // namespace geodesic::test

#endif  // GEODESIC_TESTS_SUPPORT_ORACLES_PLANAR_ORACLES_H_
