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
// corners stand in the polygon's place, fanned from its first corner. Nothing
// is checked beyond what the reader promises (see read_mesh.h).
struct TriangleSoup {
  std::vector<Point> positions;
  std::vector<Triangle> triangles;
};

}  // namespace geodesic

#endif  // GEODESIC_TRIANGLE_SOUP_H_
