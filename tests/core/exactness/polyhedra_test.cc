// Finely divided convex polyhedra against unfolding of their undivided faces.

#include "tests/support/polyhedra.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/core/exactness/every_algorithm.h"
#include "tests/support/mesh_edits.h"

namespace geodesic::test {
namespace {

class ConvexPolyhedra : public EveryAlgorithm {
 protected:
  void ExpectUnfolding(const Polyhedron& polyhedron, const TriangleSoup& soup,
                       uint32_t sources) const {
    ExpectDistances({polyhedron.name, soup}, SpreadVertices(soup, sources),
                    [&](uint32_t s, uint32_t v) {
                      return DistanceOnConvex(polyhedron, soup.positions[s],
                                              soup.positions[v]);
                    });
  }
};

TEST_P(ConvexPolyhedra, RegularSolids) {
  for (const Polyhedron& solid : {Tetrahedron(), Octahedron(), Icosahedron()}) {
    TriangleSoup fine = Triangulate(solid);
    ExpectUnfolding(solid, fine, 4);
    for (int level = 0; level < 3; ++level) fine = SubdivideAtMidpoints(fine);
    ExpectUnfolding(solid, fine, 3);
    ExpectUnfolding(solid, SplitFaces(Triangulate(solid), 60, 1), 4);
  }
}

TEST_P(ConvexPolyhedra, Boxes) {
  ExpectUnfolding(Box(1, 1, 1), BoxGrid(1, 1, 1, 6, 6, 6), 5);
  ExpectUnfolding(Box(3, 1.1, 0.7), BoxGrid(3, 1.1, 0.7, 10, 5, 4), 5);
  ExpectUnfolding(Box(2, 1, 0.01), BoxGrid(2, 1, 0.01, 9, 6, 2), 5);
  ExpectUnfolding(Box(1, 2, 4), SplitFaces(Triangulate(Box(1, 2, 4)), 80, 2),
                  5);
}

GEODESIC_TEST_EVERY_ALGORITHM(ConvexPolyhedra);

}  // namespace
}  // namespace geodesic::test
