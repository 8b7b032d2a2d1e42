// Oracle: geodesic distances by CGAL's Surface_mesh_shortest_path (Kiazyk,
// Loriot, de Verdiere), a program of others, in its recommended kernel of
// exact predicates and inexact constructions.

#ifndef GEODESIC_TESTS_CORE_EXACTNESS_CGAL_ORACLE_H_
#define GEODESIC_TESTS_CORE_EXACTNESS_CGAL_ORACLE_H_

#include <cstdint>
#include <vector>

#include "geodesic/triangle_soup.h"

namespace geodesic::test {

// One distance per vertex, +infinity where no path leads or no face is.
// REQUIRES: an edge-manifold soup whose faces agree in orientation.
std::vector<double> CgalDistances(const TriangleSoup& soup, uint32_t source);

}  // namespace geodesic::test

#endif  // GEODESIC_TESTS_CORE_EXACTNESS_CGAL_ORACLE_H_
