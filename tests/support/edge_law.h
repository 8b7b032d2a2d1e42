// The law that every complete field obeys: no vertex is farther than the way
// along an edge from any of its neighbours, and so none is unreached beside one
// that is reached.

#ifndef GEODESIC_TESTS_SUPPORT_EDGE_LAW_H_
#define GEODESIC_TESTS_SUPPORT_EDGE_LAW_H_

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "geodesic/mesh.h"

namespace geodesic::test {

inline constexpr double kFewRoundings = 0x1p-46;

// In words, the worst breach of the law by more than this fraction of the
// distances and a rounding of the mesh's coordinates.
// REQUIRES: one distance per vertex; nothing was left out by a limit.
std::optional<std::string> BreachOfEdgeLaw(const Mesh& mesh,
                                           std::span<const double> distances,
                                           double tolerance = kFewRoundings);

}  // namespace geodesic::test

#endif  // GEODESIC_TESTS_SUPPORT_EDGE_LAW_H_
