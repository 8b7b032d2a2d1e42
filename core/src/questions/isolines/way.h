// Straight ways to the points of an edge, and where a level of the distance
// crosses it by them.

#ifndef GEODESIC_QUESTIONS_ISOLINES_WAY_H_
#define GEODESIC_QUESTIONS_ISOLINES_WAY_H_

#include <optional>
#include <span>
#include <vector>

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

// Where a level crosses the edge from P to Q, by the ways to its points and
// along it from its ends: the places at which the union of all parts that are
// nearer begins and ends. Lengths are measured from P; p, q: the distances of
// the two ends. In order from P to Q; two in a row differ; one next to an end
// that is at the level is put there.
//
// P and Q are nearer or not by their own distances alone, so around any cycle
// of edges as many crossings lead in as out, whatever rounding does.
//
// Parts that meet in a point count as one; `have_met` becomes true then.
class LevelOnEdge {
 public:
  LevelOnEdge(double level, double length, double p, double q);

  // Takes some of the ways.
  void Add(std::span<const Way> ways);
  // Once all are there.
  std::vector<double> Crossings(bool& have_met);

 private:
  // Parts that are kept before those within others are dropped: of edges with
  // very many faces nearly all.
  static constexpr size_t kMostParts = 1024;

  void DropCovered();

  double level_, length_;
  double p_, q_;  // distances of the ends
  // Within [0, length], but for the part of a nearer end, which begins or ends
  // at infinity.
  std::vector<Interval> parts_;
  size_t most_parts_ = kMostParts;
};

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
