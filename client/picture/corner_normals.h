// Normals for smooth shading that keeps sharp edges sharp.

#ifndef GEODESIC_CLIENT_PICTURE_CORNER_NORMALS_H_
#define GEODESIC_CLIENT_PICTURE_CORNER_NORMALS_H_

#include <array>
#include <vector>

#include "geodesic_client/mesh.h"

namespace geodesic::client {

using Normal = std::array<float, 3>;

// The unit normals at each triangle's three corners. A normal is the average,
// weighted by area, over the triangles at the vertex that are less than 40
// degrees off the triangle itself; zero where there is no area. The triangles'
// orientation need not be consistent. Linear, except that the cost of a vertex
// is quadratic in its triangles. At a vertex of more than 64, the average is
// over all triangles and the cost is linear.
std::vector<std::array<Normal, 3>> CornerNormals(const MeshArrays& mesh);

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_PICTURE_CORNER_NORMALS_H_
