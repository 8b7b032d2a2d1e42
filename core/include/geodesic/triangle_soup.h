// Triangles as they come from a file or a client, before anything about their
// topology is known.

#ifndef GEODESIC_TRIANGLE_SOUP_H_
#define GEODESIC_TRIANGLE_SOUP_H_

#include <array>
#include <cstdint>
#include <vector>

namespace geodesic {

// A point in space, in the unit of the mesh's file.
using Point = std::array<double, 3>;

// Three vertex indices, 0-based.
using Triangle = std::array<uint32_t, 3>;

// Vertices keep the order of the file. The k - 2 triangles of a polygon with k
// corners stand in the polygon's place and cover it once, turned as it is: if
// it is convex fanned from its first corner, else cut along short diagonals,
// the same whichever corner comes first. What bends in space is looked at along
// the sum of its triangles' normals. A corner that a polygon names twice in a
// row makes a triangle that names it twice. Nothing is checked beyond what the
// reader promises (see read_mesh.h).
struct TriangleSoup {
  std::vector<Point> positions;
  std::vector<Triangle> triangles;
  // Polygons that cross themselves, or turn back so that they have no inside:
  // these are fans from their first corners, which cover other places or some
  // of them twice.
  uint64_t crossing_polygons = 0;
  // The number of the first of them among the polygons of the file, triangles
  // included, from 0. Meaningful if there is one.
  uint64_t first_crossing_polygon = 0;
};

}  // namespace geodesic

#endif  // GEODESIC_TRIANGLE_SOUP_H_
