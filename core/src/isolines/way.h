// Straight ways to the points of an edge, and what lies on the near side of a
// level by them.

#ifndef GEODESIC_ISOLINES_WAY_H_
#define GEODESIC_ISOLINES_WAY_H_

#include <optional>

#include "geodesic/mesh.h"
#include "windows/window.h"

namespace geodesic {

// The ways from one pseudo-source straight to an interval of a half-edge, in
// the frame of that half-edge or (distances along an edge do not tell the two
// sides apart) of its twin, reversed.
struct Way {
  Interval interval;
  Origin origin;
};

// Whether a distance is on the near side of a level. What is at the level, up
// to rounding, is not: vertices and ways are told apart by this one rule, so
// that the two sides of every crossing agree.
inline bool IsNearer(double distance, double level) {
  return distance < level * (1 - kAtLevel);
}

// The same ways as seen along the edge the other way round.
Way Reversed(const Way& way, double length);

// The part of the edge's line that is nearer than `level` by these ways, or by
// them and then along the edge from an end of the interval. The latter closes
// the gaps that rounding leaves between windows. Its ends are at the level.
std::optional<Interval> NearerPart(const Way& way, double level);

// What of a way into the face of h goes on to `side`, another half-edge of that
// face, in the frame of `side` reversed; none if it misses.
std::optional<Way> GoOnTo(HalfEdge side, const Mesh& mesh, HalfEdge h,
                          const Way& way);

}  // namespace geodesic

#endif  // GEODESIC_ISOLINES_WAY_H_
