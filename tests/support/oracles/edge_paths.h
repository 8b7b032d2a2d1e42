// Paths along edges: an upper bound on geodesic distances, and a law that they
// obey.

#ifndef GEODESIC_TESTS_SUPPORT_ORACLES_EDGE_PATHS_H_
#define GEODESIC_TESTS_SUPPORT_ORACLES_EDGE_PATHS_H_

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geodesic/mesh.h"
#include "geodesic/triangle_soup.h"
#include "tests/support/vec.h"

namespace geodesic::test {

// The lengths of shortest paths along edges: one per vertex; +infinity where
// none leads.
std::vector<Real> EdgeDistances(const TriangleSoup& soup, uint32_t source);

inline constexpr double kFewRoundings = 0x1p-46;

// Every complete field obeys the law that no vertex is farther than the way
// along an edge from any of its neighbours, and so none is unreached beside one
// that is reached. In words, the worst breach of it by more than this fraction
// of the distances and a rounding of the mesh's coordinates.
// REQUIRES: one distance per vertex; nothing was left out by a limit.
std::optional<std::string> BreachOfEdgeLaw(const Mesh& mesh,
                                           std::span<const double> distances,
                                           double tolerance = kFewRoundings);

}  // namespace geodesic::test

#endif  // GEODESIC_TESTS_SUPPORT_ORACLES_EDGE_PATHS_H_
