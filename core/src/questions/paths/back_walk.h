// One walk back along the last straight piece of a path, in one of the ways
// there are where rounding leaves several.

#ifndef GEODESIC_QUESTIONS_PATHS_BACK_WALK_H_
#define GEODESIC_QUESTIONS_PATHS_BACK_WALK_H_

#include <cstdint>
#include <optional>

#include "geodesic/mesh.h"
#include "geodesic/surface_point.h"
#include "questions/paths/straight_piece.h"
#include "questions/paths/traced_field.h"
#include "tolerances.h"

namespace geodesic {

struct BackWalk {
  // If the walk arrives. It need not be as long as the distances of its ends
  // say, if this is not the way that the path came.
  std::optional<StraightPiece> piece;
  // In how many ways together it might have gone.
  double ways = 1;
};

// Walks from `end` towards its pseudo-source. Where the line runs into a vertex
// that it may not pass through, and where an edge has several faces beyond,
// `turns` says which way to take: 0 and up to `ways` name them all. It is led
// through vertices that it passes no farther than `nearness`, a fraction of its
// reach, if that makes it no longer. O(edges crossed).
BackWalk WalkBack(const TracedField& field, const PathEnd& end, uint32_t turns,
                  double nearness = kPassedVertex);

// Whether a point is a vertex at the place of another.
bool Coincide(const Mesh& mesh, const SurfacePoint& point, uint32_t vertex);

}  // namespace geodesic

#endif  // GEODESIC_QUESTIONS_PATHS_BACK_WALK_H_
