// Oracle: distances along a strip of triangles without inner vertices.
//
// Laid into the plane it is a polygon, and a path to a vertex is a string that
// is pulled taut through the edges between. Lee, Preparata: Euclidean shortest
// paths in the presence of rectilinear barriers. Networks 14(3), 1984.

#ifndef GEODESIC_TESTS_SUPPORT_ORACLES_STRIP_PATHS_H_
#define GEODESIC_TESTS_SUPPORT_ORACLES_STRIP_PATHS_H_

#include <cstdint>
#include <vector>

#include "geodesic/triangle_soup.h"

namespace geodesic::test {

// One distance per vertex. REQUIRES: each triangle but the last shares one edge
// with the next one, whose third corner has not been met before; all triangles
// are oriented alike. O(triangles^2), in long double.
std::vector<double> StripDistances(const TriangleSoup& soup, uint32_t source);

}  // namespace geodesic::test

#endif  // GEODESIC_TESTS_SUPPORT_ORACLES_STRIP_PATHS_H_
