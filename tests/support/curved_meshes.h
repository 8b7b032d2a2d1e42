// Smooth and rough surfaces.

#ifndef GEODESIC_TESTS_SUPPORT_CURVED_MESHES_H_
#define GEODESIC_TESTS_SUPPORT_CURVED_MESHES_H_

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

}  // namespace geodesic::test

#endif  // GEODESIC_TESTS_SUPPORT_CURVED_MESHES_H_
