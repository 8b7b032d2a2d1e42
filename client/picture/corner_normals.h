// Normals for smooth shading that leaves sharp edges sharp.

#ifndef GEODESIC_CLIENT_PICTURE_CORNER_NORMALS_H_
#define GEODESIC_CLIENT_PICTURE_CORNER_NORMALS_H_

#include <array>
#include <vector>

#include "geodesic_client/mesh.h"

namespace geodesic::client {

using Normal = std::array<float, 3>;

// The unit normals at each triangle's three corners: the average over those
// triangles at the vertex that are less than 40 degrees off the triangle
// itself, weighted by area. Zero where there is no area. The triangles'
// orientation need not be consistent. Linear, but for vertices of up to 64
// triangles quadratic in that number; beyond, all triangles are averaged.
std::vector<std::array<Normal, 3>> CornerNormals(const MeshArrays& mesh);

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_PICTURE_CORNER_NORMALS_H_
