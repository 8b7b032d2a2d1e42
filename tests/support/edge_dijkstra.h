// Shortest paths along edges: an upper bound on geodesic distances.

#ifndef GEODESIC_TESTS_SUPPORT_EDGE_DIJKSTRA_H_
#define GEODESIC_TESTS_SUPPORT_EDGE_DIJKSTRA_H_

#include <cstdint>
#include <vector>

#include "geodesic/triangle_soup.h"
#include "tests/support/vec.h"

namespace geodesic::test {

// One distance per vertex; +infinity where no edge path leads.
std::vector<Real> EdgeDistances(const TriangleSoup& soup, uint32_t source);

}  // namespace geodesic::test

#endif  // GEODESIC_TESTS_SUPPORT_EDGE_DIJKSTRA_H_
