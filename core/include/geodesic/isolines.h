// Isolines of the distance, as polylines on the surface.

#ifndef GEODESIC_ISOLINES_H_
#define GEODESIC_ISOLINES_H_

#include <vector>

#include "absl/status/statusor.h"
#include "geodesic/checkpoint.h"
#include "geodesic/mesh.h"
#include "geodesic/solve_options.h"
#include "geodesic/surface_point.h"
#include "geodesic/valid_query.h"

namespace geodesic {

struct Isoline {
  double level = 0;
  // Points where the isoline crosses edges, and vertices that it passes
  // through, in order. Each point differs from the one before and shares a face
  // with it. Each lies at exactly `level` from the sources, up to rounding of
  // distances (relative error below 1e-10) and of `t` (1e-16 of the edge); with
  // a tolerance in the query, up to that part of the level.
  // Within a face the isoline is made of circular arcs, which the polyline cuts
  // short.
  // Where faces run anticlockwise and agree, the nearer side is on the left.
  std::vector<SurfacePoint> points;  // at least two
  std::vector<Point> positions;      // in the unit of the file
  // Whether the last point leads back to the first. Open ones end at a
  // boundary, or where more than two faces meet.
  bool is_closed = false;
};

// The isolines of all levels, in order of level; a level that is given twice
// counts once. Open isolines of a level come first. Otherwise the order depends
// on the mesh and the query alone. Solves up to the largest level. The query's
// targets and trace are not used.
//
// Guarantees:
//   1. complete: if one of two points of an edge is nearer than the level and
//      the other is not, there is a crossing between them, and every crossing
//      is in one isoline. A vertex at the level (within 1e-12 of it) counts as
//      beyond. With a tolerance, distances here and in 2 are some that are
//      within it;
//   2. they separate: points of the mesh's edges that no isoline of the level
//      keeps apart within a face are on the same side of the level. Where more
//      than two crossings lie around a face, they are joined such that parts of
//      the perimeter that are connected inside the face below the level stay
//      connected between the polylines;
//   3. loops that stay inside one face, and single points, are not found.
//
// Time: as Solve with that radius, and O(windows near an isoline * levels
// there). Memory beside it: 16 bytes a face, and 56 a window within about a
// face of an isoline until the wavefront has passed.
// Errors: INVALID_ARGUMENT for no level, or one that is not finite and > 0;
// whatever `checkpoint` returns. Thread-safe.
absl::StatusOr<std::vector<Isoline>> ComputeIsolines(
    const Mesh& mesh, const ValidQuery& query, std::vector<double> levels,
    const SolveOptions& options, Checkpoint& checkpoint);

}  // namespace geodesic

#endif  // GEODESIC_ISOLINES_H_
