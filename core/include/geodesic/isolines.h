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

// What is drawn.
struct IsolineOptions {
  // Distances in any order; at least one, each finite and above 0. One that is
  // given twice counts once.
  std::vector<double> levels;
  // No chord between two points of an isoline is farther from it than this, in
  // the unit of the file. +infinity: points inside faces are on closed isolines
  // that cross no edge alone. DEFAULT: 0, kChordErrorOfLevel of each level.
  double chord_error = 0;
};

// The chord error, as a part of the level, if none is named.
inline constexpr double kChordErrorOfLevel = 1e-3;

// A line on which the distance is the same everywhere.
struct Isoline {
  double level = 0;
  // Points where the isoline crosses edges, vertices that it passes through,
  // and between them points inside faces, as many as `chord_error` asks for:
  // there it is made of circular arcs and straight pieces. In order; each point
  // differs from the one before and shares a face with it. Each lies at exactly
  // `level` from the sources, up to rounding of distances (relative error below
  // 1e-10) and of its weights (1e-16 of the face); with a tolerance in the
  // query, up to that part of the level.
  // Where faces run anticlockwise and agree, the nearer side is on the left.
  std::vector<SurfacePoint> points;  // at least two
  std::vector<Point> positions;      // in the unit of the file
  // Whether the last point leads back to the first. Open ones end at a
  // boundary, or where more than two faces meet.
  bool is_closed = false;
};

// The isolines of all levels, in order of level. Open isolines of a level come
// first, those inside a face last. Otherwise the order depends on the mesh and
// the query alone. Solves up to the largest level. The query's
// targets and trace are not used.
//
// Guarantees:
//   1. complete: if one of two points of an edge is nearer than the level and
//      the other is not, there is a crossing between them, and every crossing
//      is in one isoline. A vertex at the level (within 1e-12 of it) counts as
//      beyond. With a tolerance, distances here and in 2 are some that are
//      within it;
//   2. they separate: crossings are joined inside a face as the isoline joins
//      them there, and isolines that stay inside a face are found, but those no
//      longer than rounding (1e-10 of the level) and single points. Where
//      rounding hides the way through a face, or the face has no area,
//      neighbouring crossings are joined.
//
// Time: as Solve with that radius, and for each face that an isoline crosses
// O(ways into it that are no farther * arcs in it), the square of that where
// isolines may stay inside. Memory beside it: 16 bytes a face, 56 a window
// within about a face of an isoline until the wavefront has passed, and 32 a
// point inside a face.
// Errors: INVALID_ARGUMENT for no level, or one that is not finite and > 0, a
// chord error that is negative or NaN, or one that asks for more than 10
// million points inside faces; whatever `checkpoint` returns. Thread-safe.
absl::StatusOr<std::vector<Isoline>> ComputeIsolines(
    const Mesh& mesh, const ValidQuery& query, const IsolineOptions& isolines,
    const SolveOptions& options, Checkpoint& checkpoint);

}  // namespace geodesic

#endif  // GEODESIC_ISOLINES_H_
