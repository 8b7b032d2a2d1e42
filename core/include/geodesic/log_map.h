// The log map: the surface around a source laid into the plane by direction and
// distance.

#ifndef GEODESIC_LOG_MAP_H_
#define GEODESIC_LOG_MAP_H_

#include <array>
#include <vector>

#include "absl/status/statusor.h"
#include "geodesic/distance_field.h"
#include "geodesic/mesh.h"
#include "geodesic/query.h"

namespace geodesic {

struct LogMap {
  // Per vertex, in the unit of the file: distance times (cos, sin) of the angle
  // at which the shortest path leaves the source. NaN where no path arrives.
  // Angles are measured around the source from `zero_direction`,
  // counterclockwise seen from outside; at a vertex they are scaled so that the
  // cone around an interior vertex measures 2 pi.
  std::vector<std::array<double, 2>> coordinates;
  // Unit vector in space of angle 0: along the first half-edge of
  // Mesh::Outgoing at a vertex, along the edge at an edge point, along corner 0
  // -> corner 1 in a face.
  Point zero_direction{};
};

// O(V + edges crossed by the paths).
// Errors: INVALID_ARGUMENT: a field without trace; not exactly one source
// point, or one at a vertex that is not a manifold disk or half-disk.
absl::StatusOr<LogMap> ComputeLogMap(const Mesh& mesh, const Query& query,
                                     const DistanceField& field);

}  // namespace geodesic

#endif  // GEODESIC_LOG_MAP_H_
