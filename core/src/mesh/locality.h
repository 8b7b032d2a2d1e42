// Where a mesh lies, and an order of its faces that keeps neighbours together
// in memory.

#ifndef GEODESIC_MESH_LOCALITY_H_
#define GEODESIC_MESH_LOCALITY_H_

#include <cstdint>
#include <span>
#include <vector>

#include "geodesic/triangle_soup.h"

namespace geodesic {

struct Box {
  Point low, high;
};
// The least one that holds all points. REQUIRES: there is a point.
Box BoxAround(std::span<const Point> points);

// The faces in the order in which a space-filling curve (Morton: A computer
// oriented geodetic data base, 1966) passes their centroids; those in one cell
// of its grid in order of their numbers. O(V + F) time, O(V + F log F) if faces
// crowd in few cells; 22 bytes a face and 24 a vertex.
// REQUIRES: coordinates are finite and vertex numbers in range.
std::vector<uint32_t> FacesAlongCurve(const TriangleSoup& soup);

}  // namespace geodesic

#endif  // GEODESIC_MESH_LOCALITY_H_
