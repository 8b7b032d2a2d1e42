// Surfaces whose vertices exceed a full turn by very little. Their rows are
// straight lines in space, so distances along them are those of Euclid.

#ifndef GEODESIC_TESTS_SUPPORT_GENTLE_SADDLES_H_
#define GEODESIC_TESTS_SUPPORT_GENTLE_SADDLES_H_

#include <cstdint>

#include "geodesic/triangle_soup.h"

namespace geodesic::test {

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

#endif  // GEODESIC_TESTS_SUPPORT_GENTLE_SADDLES_H_
