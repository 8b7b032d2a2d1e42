// Windows in the plane: a window on half-edge A -> B holds the paths that
// enter the face left of it through an interval of AB, straight from one
// pseudo-source unfolded into the plane of that face.
//
// Frame (Mesh::frame): A = (0, 0), B = (length, 0), the face's apex C above;
// the pseudo-source lies at (source_x, -source_depth), below AB.
//
// Xu et al. 2015, section 3.1: interval [near_, far_] here first_, end_.

#ifndef GEODESIC_SOLVER_WINDOWS_WINDOW_H_
#define GEODESIC_SOLVER_WINDOWS_WINDOW_H_

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "geodesic/mesh.h"
#include "surface/plane_point.h"
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
  // The same from the source.
  double PathTo(double at) const { return sigma + DistanceTo(at); }
};

// An interval [begin, end] of an edge.
struct Interval {
  double begin = 0;
  double end = 0;

  double width() const { return end - begin; }
};

// The least distance over an interval, given those at its ends. It lower bounds
// every distance that a window can give, so labels never decrease from parent
// to child (that of the whole edge would).
inline double LeastDistance(const Origin& origin, const Interval& interval,
                            double begin_distance, double end_distance) {
  if (origin.x < interval.begin) return begin_distance;
  if (origin.x > interval.end) return end_distance;
  return origin.sigma + origin.depth;
}

// Paths from one pseudo-source through one interval, with the distances from
// the source at its ends: most questions about a window are about these.
// OriginType: Origin, or MixedOrigin where sources are curves.
template <typename OriginType>
struct BasicWindow {
  Interval interval;
  OriginType origin;
  double begin_distance = 0;
  double end_distance = 0;

  static BasicWindow Over(const Interval& interval, const OriginType& origin) {
    return {interval, origin, origin.PathTo(interval.begin),
            origin.PathTo(interval.end)};
  }

  double DistanceTo(double at) const { return origin.PathTo(at); }

  double Label() const {
    return LeastDistance(origin, interval, begin_distance, end_distance);
  }

  // Gives up what lies outside `part`.
  void CutTo(const Interval& part) {
    if (part.begin != interval.begin) begin_distance = DistanceTo(part.begin);
    if (part.end != interval.end) end_distance = DistanceTo(part.end);
    interval = part;
  }
};

using Window = BasicWindow<Origin>;

// Whether a window's distance at a point exceeds that of a known path.
inline bool Exceeds(double distance, double known) {
  return distance > known * (1 + kDominance);
}

// The widest part of an edge of this length that may be lost, if the
// pseudo-source is this far from where it begins.
inline double WidthOfLost(double distance, double length) {
  return std::min(kLeastWidth * length,
                  std::max(kLeastWidth * distance, kRoundedWidth * length));
}

// Whether a part of an edge is too narrow to matter.
inline bool IsLost(const Interval& part, const Origin& origin, double length) {
  // Rarely narrow, and then seldom wide for the pseudo-source.
  return part.width() <= kLeastWidth * length &&
         part.width() <= WidthOfLost(origin.DistanceTo(part.begin), length);
}

inline PlanePoint ApexOf(const HalfEdgeFrame& frame) {
  return {frame.apex_x, frame.apex_y};
}

// Where the ray into a place of the face crosses the line of AB.
inline double CrossingTo(const Origin& origin, const PlanePoint& place) {
  return (origin.x * place.y + place.x * origin.depth) /
         (place.y + origin.depth);
}

// How far outside its interval a window still relaxes a place of the face (the
// apex, a target), through the interval's nearest end. The ray into the place
// misses the window by so much less as it runs along the edge.
inline double NearMiss(const Origin& origin, const HalfEdgeFrame& frame,
                       const PlanePoint& place, double of_reach = kNearMiss) {
  const double slope = std::abs(place.x - origin.x) / (place.y + origin.depth);
  return of_reach * (frame.length + std::abs(origin.x) + origin.depth) *
         (1 + slope);
}

// Distance from the pseudo-source straight to a place of the face.
inline double DistanceToPlace(const Origin& origin, const PlanePoint& place) {
  const double dx = place.x - origin.x;
  const double dy = place.y + origin.depth;
  return std::sqrt(dx * dx + dy * dy);
}

// Distance from the point (at, 0) of AB to a place of the face.
inline double EdgePointTo(double at, const PlanePoint& place) {
  const double dx = place.x - at;
  return std::sqrt(dx * dx + place.y * place.y);
}

// How far the ray into a place, `distance` away, leans to the right of AB's
// normal: the sine of the angle.
inline double Lean(const Origin& origin, const PlanePoint& place,
                   double distance) {
  return (place.x - origin.x) / distance;
}

// Whether the pseudo-source lies inside AB, where a face without area has put
// it.
inline bool LiesOnEdge(const Origin& origin, const HalfEdgeFrame& frame) {
  return origin.depth <= kCollapsedFace * frame.length && origin.x > 0 &&
         origin.x < frame.length;
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
// through (at, 0) meets it. REQUIRES: at is not right of the ray into the apex.
inline double ProjectLeft(const Origin& origin, double at,
                          const HalfEdgeFrame& frame, double left_length) {
  const double across =
      origin.depth * frame.left_x + (origin.x - at) * frame.left_y;
  const double t = origin.depth * at / across;
  // Rays along the edge (and rounding) may meet it nowhere or beyond C.
  return across > 0 && t < left_length ? std::max(t, 0.0) : left_length;
}

// Distance from B along B -> C, which is `right_length` long, where the ray
// through (at, 0) meets it. REQUIRES: at is not left of the ray into the apex.
inline double ProjectRight(const Origin& origin, double at,
                           const HalfEdgeFrame& frame, double right_length) {
  const double across =
      (at - origin.x) * frame.right_y - origin.depth * frame.right_x;
  const double t = origin.depth * (frame.length - at) / across;
  return across > 0 && t < right_length ? std::max(t, 0.0) : right_length;
}

// Into a frame that is turned over: A and B change places.
inline Origin Mirror(const Origin& origin, double length) {
  return {.x = length - origin.x, .depth = origin.depth, .sigma = origin.sigma};
}
inline Interval Mirror(const Interval& interval, double length) {
  return {length - interval.end, length - interval.begin};
}

}  // namespace geodesic

#endif  // GEODESIC_SOLVER_WINDOWS_WINDOW_H_
