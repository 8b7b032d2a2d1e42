// The pieces of a query's sources that windows start from.

#ifndef GEODESIC_ANCHORS_H_
#define GEODESIC_ANCHORS_H_

#include <cstdint>
#include <vector>

#include "geodesic/query.h"
#include "geodesic/surface_point.h"

namespace geodesic {

// A point, or a straight segment within a face.
struct Anchor {
  SurfacePoint begin;
  SurfacePoint end;  // of a segment; begin again for a point
  bool is_segment = false;
  double offset = 0;    // in the unit of the file
  uint32_t source = 0;  // number as in query.h
};

// The query with every point canonical; sources and targets keep their order.
// REQUIRES: Validate(query, mesh).ok().
Query WithCanonicalPoints(Query query, const Mesh& mesh);

// All anchors of a query, in the order in which Arrival counts them: one a
// source, then for each curve its points and its segments.
// REQUIRES: the query's points are canonical.
std::vector<Anchor> AnchorsOf(const Query& query);

}  // namespace geodesic

#endif  // GEODESIC_ANCHORS_H_
