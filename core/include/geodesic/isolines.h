// Isolines of the exact distance, as polylines on the surface.

#ifndef GEODESIC_ISOLINES_H_
#define GEODESIC_ISOLINES_H_

#include <vector>

#include "absl/status/statusor.h"
#include "geodesic/checkpoint.h"
#include "geodesic/mesh.h"
#include "geodesic/query.h"
#include "geodesic/solve_options.h"
#include "geodesic/surface_point.h"

namespace geodesic {

struct Isoline {
  double level = 0;
  // Points where the isoline crosses edges, in order; each lies at exactly
  // `level` from the sources (relative error below 1e-10). Within a face the
  // isoline is made of circular arcs, which the polyline cuts short.
  std::vector<SurfacePoint> points;
  std::vector<Point> positions;  // in the unit of the file
  // Whether the last point leads back to the first. Open ones end at a
  // boundary.
  bool is_closed = false;
};

// The isolines of all levels, level by level, in an order that depends on the
// mesh and the query alone. Solves up to the largest level. Loops that stay
// inside one face are not found.
// Errors: INVALID_ARGUMENT as Validate; no level, or one that is not finite and
// > 0; whatever `checkpoint` returns.
absl::StatusOr<std::vector<Isoline>> ComputeIsolines(
    const Mesh& mesh, const Query& query, std::vector<double> levels,
    const SolveOptions& options, Checkpoint& checkpoint);

}  // namespace geodesic

#endif  // GEODESIC_ISOLINES_H_
