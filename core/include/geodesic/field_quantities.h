// What else a traced field knows about every vertex: the nearest source, and
// the direction in which distance grows.

#ifndef GEODESIC_FIELD_QUANTITIES_H_
#define GEODESIC_FIELD_QUANTITIES_H_

#include <cstdint>
#include <vector>

#include "absl/status/statusor.h"
#include "geodesic/checkpoint.h"
#include "geodesic/distance_field.h"
#include "geodesic/mesh.h"
#include "geodesic/valid_query.h"
#include "geodesic_types/places.h"

namespace geodesic {

// The number of the source whose path arrives at each vertex, which is the
// vertex's Voronoi cell. kNoSource where no path arrives. At a tie, one of the
// nearest. O(V).
// REQUIRES: the field is the query's, on this mesh.
// Errors: INVALID_ARGUMENT: a field without trace, or of another size;
// INTERNAL: the trace leads in circles (a defect); the checkpoint's.
// Thread-safe.
absl::StatusOr<std::vector<uint32_t>> NearestSources(const Mesh& mesh,
                                                     const ValidQuery& query,
                                                     const DistanceField& field,
                                                     Checkpoint& checkpoint);
absl::StatusOr<std::vector<uint32_t>> NearestSources(
    const Mesh& mesh, const ValidQuery& query, const DistanceField& field);

// The unit vector in space along which the shortest path arrives at each
// vertex. It is the gradient of the distance there, in the plane of the path's
// last face. The zero vector at sources and where no path arrives. O(V).
// Errors: as NearestSources. Thread-safe.
absl::StatusOr<std::vector<Point>> Gradients(const Mesh& mesh,
                                             const ValidQuery& query,
                                             const DistanceField& field,
                                             Checkpoint& checkpoint);
absl::StatusOr<std::vector<Point>> Gradients(const Mesh& mesh,
                                             const ValidQuery& query,
                                             const DistanceField& field);

}  // namespace geodesic

#endif  // GEODESIC_FIELD_QUANTITIES_H_
