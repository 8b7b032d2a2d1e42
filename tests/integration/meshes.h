// Meshes the integration tests make, and files of them.

#ifndef GEODESIC_TESTS_INTEGRATION_MESHES_H_
#define GEODESIC_TESTS_INTEGRATION_MESHES_H_

#include <string>

#include "geodesic_client/mesh.h"

namespace geodesic::client {

// (n + 1) x (n + 1) vertices on the unit square, row by row: vertex
// i + j (n + 1) is at (i / n, j / n, height). In the plane distances are
// Euclid's.
MeshArrays PlanarGrid(uint32_t n);

// The same with hills, so that a solver has work to do.
MeshArrays HillyGrid(uint32_t n);

// OFF text with digits enough for the same doubles.
std::string OffText(const MeshArrays& mesh);

}  // namespace geodesic::client

#endif  // GEODESIC_TESTS_INTEGRATION_MESHES_H_
