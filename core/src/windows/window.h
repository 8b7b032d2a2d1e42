// Windows in the plane: a window on half-edge A -> B holds the paths that
// enter the face left of it through an interval of AB, straight from one
// pseudo-source unfolded into the plane of that face.
//
// Frame (Mesh::frame): A = (0, 0), B = (length, 0), the face's apex C above;
// the pseudo-source lies at (source_x, -source_depth), below AB.
//
// Xu et al. 2015, section 3.1: interval [near_, far_] here first_, end_.

#ifndef GEODESIC_WINDOWS_WINDOW_H_
#define GEODESIC_WINDOWS_WINDOW_H_

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "geodesic/mesh.h"
#include "tolerances.h"

namespace geodesic {

// The unfolded pseudo-source of a window: where it lies and how far it is from
// the source itself.
struct Origin {
  double x = 0;
  double depth = 0;  // >= kLeastHeight
  double sigma = 0;  // distance from the source to the pseudo-source

  // Distance from the pseudo-source to the point (at, 0) of the edge.
  double DistanceTo(double at) const {
    return std::sqrt((at - x) * (at - x) + depth * depth);
  }
};

// An interval [begin, end] of an edge.
struct Interval {
  double begin = 0;
  double end = 0;

  double width() const { return end - begin; }
};

// Paths from one pseudo-source through one interval, with the distances from
// the source at its ends: most questions about a window are about these.
struct Window {
  Interval interval;
  Origin origin;
  double begin_distance = 0;
  double end_distance = 0;

  static Window Over(const Interval& interval, const Origin& origin) {
    return {interval, origin, origin.sigma + origin.DistanceTo(interval.begin),
            origin.sigma + origin.DistanceTo(interval.end)};
  }

  double DistanceTo(double at) const {
    return origin.sigma + origin.DistanceTo(at);
  }

  // The least distance over the interval. It lower bounds every distance the
  // window can give, so labels never decrease from parent to child (that of the
  // whole edge would).
  double Label() const {
    if (origin.x < interval.begin) return begin_distance;
    if (origin.x > interval.end) return end_distance;
    return origin.sigma + origin.depth;
  }

  // Gives up what lies outside `part`.
  void CutTo(const Interval& part) {
    if (part.begin != interval.begin) begin_distance = DistanceTo(part.begin);
    if (part.end != interval.end) end_distance = DistanceTo(part.end);
    interval = part;
  }
};

// Whether a window's distance at a point exceeds that of a known path.
inline bool Exceeds(double distance, double known) {
  return distance > known * (1 + kDominance);
}

// Where the line from the pseudo-source through the apex crosses AB.
inline double ApexCrossing(const Origin& origin, const HalfEdgeFrame& frame) {
  return (origin.x * frame.apex_y + frame.apex_x * origin.depth) /
         (frame.apex_y + origin.depth);
}

// How far outside its interval a window still relaxes the apex, through the
// interval's nearest end.
inline double NearMiss(const Origin& origin, const HalfEdgeFrame& frame) {
  return kNearMiss * (frame.length + std::abs(origin.x) + origin.depth);
}

// Distance from the pseudo-source to the apex.
inline double DistanceToApex(const Origin& origin, const HalfEdgeFrame& frame) {
  const double dx = frame.apex_x - origin.x;
  const double dy = frame.apex_y + origin.depth;
  return std::sqrt(dx * dx + dy * dy);
}

// Distance from the point (at, 0) of AB to the apex.
inline double EdgePointToApex(double at, const HalfEdgeFrame& frame) {
  const double dx = frame.apex_x - at;
  return std::sqrt(dx * dx + frame.apex_y * frame.apex_y);
}

// The pseudo-source in the frame of frame.left_exit, which runs A -> C: a
// rotation about A.
inline Origin UnfoldLeft(const Origin& origin, const HalfEdgeFrame& frame) {
  return {
      .x = origin.x * frame.left_x - origin.depth * frame.left_y,
      .depth = std::max(origin.x * frame.left_y + origin.depth * frame.left_x,
                        kLeastHeight),
      .sigma = origin.sigma};
}

// The pseudo-source in the frame of frame.right_exit, which runs C -> B and is
// right_length long: a rotation about B.
inline Origin UnfoldRight(const Origin& origin, const HalfEdgeFrame& frame,
                          double right_length) {
  const double x = origin.x - frame.length;  // from B
  return {
      .x = right_length - (x * frame.right_x - origin.depth * frame.right_y),
      .depth = std::max(-(x * frame.right_y + origin.depth * frame.right_x),
                        kLeastHeight),
      .sigma = origin.sigma};
}

// Distance from A along A -> C, which is `left_length` long, where the ray
// through (at, 0) meets it. REQUIRES: at <= ApexCrossing.
inline double ProjectLeft(const Origin& origin, double at,
                          const HalfEdgeFrame& frame, double left_length) {
  const double across =
      origin.depth * frame.left_x + (origin.x - at) * frame.left_y;
  const double t = origin.depth * at / across;
  // Rays along the edge (and rounding) may meet it nowhere or beyond C.
  return across > 0 && t < left_length ? std::max(t, 0.0) : left_length;
}

// Distance from B along B -> C, which is `right_length` long, where the ray
// through (at, 0) meets it. REQUIRES: at >= ApexCrossing.
inline double ProjectRight(const Origin& origin, double at,
                           const HalfEdgeFrame& frame, double right_length) {
  const double across =
      (at - origin.x) * frame.right_y - origin.depth * frame.right_x;
  const double t = origin.depth * (frame.length - at) / across;
  return across > 0 && t < right_length ? std::max(t, 0.0) : right_length;
}

}  // namespace geodesic

#endif  // GEODESIC_WINDOWS_WINDOW_H_
