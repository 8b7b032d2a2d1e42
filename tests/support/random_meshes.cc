#include "tests/support/random_meshes.h"

#include <vector>

#include "tests/support/curved_meshes.h"
#include "tests/support/developable_meshes.h"
#include "tests/support/mesh_edits.h"
#include "tests/support/planar_meshes.h"
#include "tests/support/polyhedra.h"
#include "tests/support/random.h"

namespace geodesic::test {

TriangleSoup EditedMesh(uint64_t seed, bool degenerate) {
  Random random(seed);
  const GridOptions grid{.columns = 3 + random.Below(4),
                         .rows = 3 + random.Below(3),
                         .diagonals = static_cast<Diagonals>(random.Below(3)),
                         .jitter = random.Below(2) == 0 ? 0 : 0.2,
                         .seed = seed};
  TriangleSoup soup;
  switch (seed % 5) {
    case 0:
      soup = MakePlate(random.Below(2) == 0 ? WithHole(grid) : UShape(grid),
                       random.Uniform(0.1, 2));
      break;
    case 1:
      soup = MakeGrid(grid);
      for (Point& p : soup.positions) p[2] = random.Below(3);
      break;
    case 2:
      soup = BoxGrid(1, 2, 3, 2, 1 + random.Below(3), 1 + random.Below(3));
      break;
    case 3:
      soup = UvSphere(3 + random.Below(8), 3 + random.Below(4));
      break;
    case 4:
      soup = Fan({.spokes = 8,
                  .rings = 1 + random.Below(3),
                  .total_angle = random.Uniform(0.2, 12),
                  .closed = random.Below(2) == 0})
                 .soup();
      break;
  }
  soup = FlipEdges(soup, random.Below(20), seed);
  if (degenerate) {
    std::vector<uint32_t> doubled;
    soup = InsertZeroAreaFaces(soup, 1 + random.Below(4), seed);
    soup = DoubleVertices(soup, random.Below(3), seed, &doubled);
  }
  return RotateAndShift(SplitFaces(soup, random.Below(8), seed), seed);
}

}  // namespace geodesic::test
