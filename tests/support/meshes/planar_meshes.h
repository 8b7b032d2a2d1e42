// Triangulated rectangles in the plane z = 0, whole or with rectangles cut out.

#ifndef GEODESIC_TESTS_SUPPORT_MESHES_PLANAR_MESHES_H_
#define GEODESIC_TESTS_SUPPORT_MESHES_PLANAR_MESHES_H_

#include <cstdint>
#include <vector>

#include "geodesic/triangle_soup.h"

namespace geodesic::test {

enum class Diagonals { kParallel, kAlternating, kRandom };

// The cells [x0, x1) x [y0, y1) of a grid.
struct CellRect {
  uint32_t x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};

struct GridOptions {
  uint32_t columns = 8, rows = 8;  // cells, each cut into two triangles
  double cell_width = 1, cell_height = 1;
  Diagonals diagonals = Diagonals::kParallel;
  // How far a vertex off the boundary may move along each axis, as a fraction
  // of the cell; below 0.25 no face turns over.
  double jitter = 0;
  uint64_t seed = 1;
  // Cells left out, with the vertices that only they use.
  std::vector<CellRect> removed;
};

TriangleSoup MakeGrid(const GridOptions& options);

// A plate with that outline, `thickness` thick, top, bottom and walls: a closed
// surface, flat but for its edges, with saddles at reflex corners.
TriangleSoup MakePlate(const GridOptions& options, double thickness);

// Domains with reflex corners, `size` >= 3 cells a side.
GridOptions WithHole(GridOptions options);
GridOptions LShape(GridOptions options);
GridOptions UShape(GridOptions options);

}  // namespace geodesic::test

#endif  // GEODESIC_TESTS_SUPPORT_MESHES_PLANAR_MESHES_H_
