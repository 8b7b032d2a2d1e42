// Small meshes at random: each is one number.

#ifndef GEODESIC_TESTS_SUPPORT_RANDOM_MESHES_H_
#define GEODESIC_TESTS_SUPPORT_RANDOM_MESHES_H_

#include <cstdint>

#include "geodesic/triangle_soup.h"

namespace geodesic::test {

// Solids and sheets of every kind, edited at random; up to some hundred faces.
// Turned edges of flat parts give faces folded over. `degenerate` ones have
// faces without area and coincident vertices too.
TriangleSoup EditedMesh(uint64_t seed, bool degenerate);

}  // namespace geodesic::test

#endif  // GEODESIC_TESTS_SUPPORT_RANDOM_MESHES_H_
