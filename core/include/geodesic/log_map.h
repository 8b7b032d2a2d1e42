// The log map: the surface around a source laid into the plane by direction and
// distance.

#ifndef GEODESIC_LOG_MAP_H_
#define GEODESIC_LOG_MAP_H_

#include <array>
#include <limits>
#include <vector>

#include "absl/status/statusor.h"
#include "geodesic/distance_field.h"
#include "geodesic/mesh.h"
#include "geodesic/valid_query.h"

namespace geodesic {

struct LogMap {
  // Per vertex, in the unit of the file: distance (less the source's offset)
  // times (cos, sin) of the angle at which the shortest path leaves the source.
  // NaN where no path arrives, beyond `radius`, or where the path leaves a
  // source vertex by way of edges without length. Angles are measured around
  // the source from `zero_direction`, counterclockwise seen from outside; at an
  // interior vertex they are scaled so that the cone around it measures 2 pi.
  std::vector<std::array<double, 2>> coordinates;
  // Unit vector in space of angle 0: along the first half-edge of
  // Mesh::Outgoing at a vertex, along the edge from its lower vertex number to
  // the higher at an edge point, along corner 0 -> corner 1 in a face.
  Point zero_direction{};
};

// `field` may reach further than `radius`, up to which the map is drawn.
// O(V + edges crossed by the paths up to there).
// Errors: INVALID_ARGUMENT: a field without trace, or of another mesh or query;
// not exactly one source point, or one around which the surface is not an
// oriented disk or half-disk; INTERNAL: the trace does not lead back to the
// source (a defect).
absl::StatusOr<LogMap> ComputeLogMap(
    const Mesh& mesh, const ValidQuery& query, const DistanceField& field,
    double radius = std::numeric_limits<double>::infinity());

}  // namespace geodesic

#endif  // GEODESIC_LOG_MAP_H_
