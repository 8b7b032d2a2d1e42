// Smooth and rough surfaces.

#ifndef GEODESIC_TESTS_SUPPORT_MESHES_CURVED_MESHES_H_
#define GEODESIC_TESTS_SUPPORT_MESHES_CURVED_MESHES_H_

#include <cstdint>

#include "geodesic/triangle_soup.h"

namespace geodesic::test {

// A unit icosahedron, its faces cut in four `levels` times and its vertices
// pushed onto the unit sphere: 20 * 4^levels faces, full of ties.
TriangleSoup Icosphere(uint32_t levels);

// The unit sphere by meridians and parallels; vertex 0 is the north pole, the
// last the south pole. REQUIRES: meridians >= 3, bands >= 2.
TriangleSoup UvSphere(uint32_t meridians, uint32_t bands);

struct TorusOptions {
  // Steps around the axis and around the tube; unequal ones make long faces.
  uint32_t around = 12, across = 8;
  double major_radius = 2, minor_radius = 0.8;
  // Each coordinate moves by up to this much.
  double noise = 0;
  uint64_t seed = 1;
};

TriangleSoup Torus(const TorusOptions& options);

// A height field over a grid of unit cells with heights in [0, roughness) and
// diagonals at random.
TriangleSoup Terrain(uint32_t columns, uint32_t rows, double roughness,
                     uint64_t seed);

// Squares in a row, cut by diagonals at random, with heights in [-height,
// height): a strip one square wide, which has no inner vertex. Triangles are in
// order along it.
TriangleSoup Strip(uint32_t columns, double height, uint64_t seed);

// Surfaces whose vertices exceed a full turn by very little. Their rows are
// straight lines in space, so distances along them are those of Euclid.

// z = twist * x * y over a grid of unit cells around x = y = 0, row by row: its
// inner vertices exceed a full turn by about twist^2. Columns are straight too.
TriangleSoup HyperbolicGrid(uint32_t columns, uint32_t rows, double twist);

// Three rows, y = -1, 0 and 1, vertex 1 at the origin: `saddles` unit columns
// of z = sqrt(excess) * x * y, then `tail` columns in one plane, each longer
// than the one before. Vertex 3 * i + 1 lies on the middle row.
TriangleSoup SaddleRow(uint32_t saddles, double excess, uint32_t tail);

// Behind one saddle, vertex 0, as seen from vertex 1, lie `rings` squares
// inside each other around vertex 9 + 4 * rings, each smaller than the one
// around it by `ratio`.
TriangleSoup SaddleCluster(double excess, uint32_t rings, double ratio);

}  // namespace geodesic::test

#endif  // GEODESIC_TESTS_SUPPORT_MESHES_CURVED_MESHES_H_
