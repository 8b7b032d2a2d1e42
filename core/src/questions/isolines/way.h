// Straight ways to the points of an edge, and what lies on the near side of a
// level by them.

#ifndef GEODESIC_QUESTIONS_ISOLINES_WAY_H_
#define GEODESIC_QUESTIONS_ISOLINES_WAY_H_

#include <optional>

#include "geodesic/mesh.h"
#include "solver/curve_segment.h"
#include "solver/windows/mixed_origin.h"
#include "solver/windows/window.h"

namespace geodesic {

// The ways from one pseudo-source straight to an interval of a half-edge, in
// the frame of that half-edge or (distances along an edge do not tell the two
// sides apart) of its twin, mirrored.
struct Way {
  Interval interval;
  MixedOrigin origin;

  double Label() const { return MixedWindow::Over(interval, origin).Label(); }
};

// Whether a distance is on the near side of a level. What is at the level, up
// to rounding, is not: vertices and ways are told apart by this one rule, so
// that the two sides of every crossing agree.
inline bool IsNearer(double distance, double level) {
  return distance < level * (1 - kAtLevel);
}

// The same ways as seen along the edge the other way round.
inline Way Mirror(const Way& way, double length) {
  return {Mirror(way.interval, length), Mirror(way.origin, length)};
}

// The part of the edge's line that is nearer than `level` by these ways, or by
// them and then along the edge from an end of the interval. The latter closes
// the gaps that rounding leaves between windows. Its ends are at the level.
std::optional<Interval> NearerPart(const Way& way, double level);

// What of a way into the face of h goes on to `side`, another half-edge of that
// face, in the frame of `side` mirrored; none if it misses.
std::optional<Way> GoOnTo(HalfEdge side, const Mesh& mesh, HalfEdge h,
                          const Way& way);

// The ways from a segment of a curve to side h of the face that holds it, in
// the frame of h; none if no ray goes there. `sigma`: the curve's offset.
std::optional<Way> GoFromSegment(HalfEdge h, const Mesh& mesh,
                                 const CurveSegment& segment, double sigma);

}  // namespace geodesic

#endif  // GEODESIC_QUESTIONS_ISOLINES_WAY_H_
