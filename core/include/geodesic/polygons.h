// Polygons that a program holds in memory, as the triangles that readers of
// files make of them.

#ifndef GEODESIC_POLYGONS_H_
#define GEODESIC_POLYGONS_H_

#include <cstdint>
#include <span>
#include <vector>

#include "absl/status/statusor.h"
#include "geodesic/triangle_soup.h"

namespace geodesic {

class Checkpoint;

// Polygon i has sizes[i] corners, the next of `corners`, which number positions
// from 0. What becomes of it says triangle_soup.h. The checkpoint may be null,
// and is polled every few milliseconds.
//
// Thread-safe; O(n log n) in the corners of a polygon that is not convex, and
// O(n^2) for contrived ones. Errors: INVALID_ARGUMENT naming the first polygon
// with fewer than 3 corners, with more than are left of `corners`, or that
// names no position; what the checkpoint returns.
absl::StatusOr<TriangleSoup> TriangulatePolygons(
    std::vector<Point> positions, std::span<const int64_t> corners,
    std::span<const int64_t> sizes, Checkpoint* checkpoint = nullptr);

}  // namespace geodesic

#endif  // GEODESIC_POLYGONS_H_
