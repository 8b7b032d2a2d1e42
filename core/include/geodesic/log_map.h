// The log map: the surface around a source laid into the plane by direction and
// distance.

#ifndef GEODESIC_LOG_MAP_H_
#define GEODESIC_LOG_MAP_H_

#include <array>
#include <limits>
#include <vector>

#include "absl/status/statusor.h"
#include "geodesic/checkpoint.h"
#include "geodesic/distance_field.h"
#include "geodesic/mesh.h"
#include "geodesic/valid_query.h"

namespace geodesic {

// The surface around a point, laid into the plane.
struct LogMap {
  // One per vertex, in the unit of the file: the distance without the source's
  // offset, times (cos, sin) of the angle at which the shortest path leaves the
  // source. NaN where no path arrives, beyond `radius`, or where the path
  // leaves a source vertex by way of edges without length. Angles are measured
  // around the source from `zero_direction`, counterclockwise seen from
  // outside; at an interior vertex they are scaled so that the cone around it
  // measures 2 pi.
  std::vector<std::array<double, 2>> coordinates;
  // The unit vector in space that has angle 0. At a vertex it runs along the
  // first half-edge of Mesh::Outgoing, at an edge point along the edge from the
  // lower vertex number to the higher, and in a face from corner 0 to corner 1.
  Point zero_direction{};
};

// Maps the vertices up to `radius`; `field` may reach further. O(V + edges
// crossed by the paths up to `radius` + faces around the source). Polls the
// checkpoint at least every few thousand of these.
// REQUIRES: the field is the query's, on this mesh.
// Errors: INVALID_ARGUMENT: a field without trace, or of another size;
// a radius that is negative or NaN; not exactly one source point, or one around
// which the surface is not an oriented disk or half-disk; INTERNAL: the trace
// does not lead back to the source (a defect); the checkpoint's. Thread-safe.
absl::StatusOr<LogMap> ComputeLogMap(const Mesh& mesh, const ValidQuery& query,
                                     const DistanceField& field, double radius,
                                     Checkpoint& checkpoint);
absl::StatusOr<LogMap> ComputeLogMap(
    const Mesh& mesh, const ValidQuery& query, const DistanceField& field,
    double radius = std::numeric_limits<double>::infinity());

}  // namespace geodesic

#endif  // GEODESIC_LOG_MAP_H_
