// Distances in the plane, around obstacles.

#ifndef GEODESIC_TESTS_SUPPORT_ORACLES_PLANAR_DOMAIN_H_
#define GEODESIC_TESTS_SUPPORT_ORACLES_PLANAR_DOMAIN_H_

#include <span>
#include <vector>

#include "geodesic/triangle_soup.h"
#include "tests/support/meshes/planar_meshes.h"
#include "tests/support/vec.h"

namespace geodesic::test {

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

#endif  // GEODESIC_TESTS_SUPPORT_ORACLES_PLANAR_DOMAIN_H_
