// Origins for queries with curves: a pseudo-source is a point or a straight
// segment.
//
// The shortest paths from a segment leave it at right angles, so a window of
// one holds parallel rays, and distance grows linearly along the edge.

#ifndef GEODESIC_SOLVER_WINDOWS_MIXED_ORIGIN_H_
#define GEODESIC_SOLVER_WINDOWS_MIXED_ORIGIN_H_

#include <algorithm>
#include <cmath>

#include "geodesic/mesh.h"
#include "solver/windows/window.h"
#include "tolerances.h"

namespace geodesic {

// A point as Origin has it; or, if `is_segment`, the unit vector (x, depth) in
// which all rays run, depth > 0, and sigma the distance that they give A,
// whether or not the window holds that point.
struct MixedOrigin {
  double x = 0;
  double depth = 0;
  double sigma = 0;
  bool is_segment = false;

  Origin AsPoint() const { return {x, depth, sigma}; }

  double DistanceTo(double at) const {
    return is_segment ? at * x : AsPoint().DistanceTo(at);
  }
  // Not below 0, where rounding may put points beside the segment: relative
  // tolerances would take equal distances for better ones.
  double PathTo(double at) const {
    return std::max(sigma + DistanceTo(at), 0.0);
  }
};

using MixedWindow = BasicWindow<MixedOrigin>;

inline double LeastDistance(const MixedOrigin& origin, const Interval& interval,
                            double begin_distance, double end_distance) {
  return origin.is_segment ? std::min(begin_distance, end_distance)
                           : LeastDistance(origin.AsPoint(), interval,
                                           begin_distance, end_distance);
}

// Parallel rays see no more of what lies behind.
inline bool IsLost(const Interval& part, const MixedOrigin& origin,
                   double length) {
  return origin.is_segment ? part.width() <= kLeastWidth * length
                           : IsLost(part, origin.AsPoint(), length);
}

inline double CrossingTo(const MixedOrigin& origin, const PlanePoint& place) {
  return origin.is_segment ? place.x - place.y * origin.x / origin.depth
                           : CrossingTo(origin.AsPoint(), place);
}

inline double DistanceToPlace(const MixedOrigin& origin,
                              const PlanePoint& place) {
  return origin.is_segment ? place.x * origin.x + place.y * origin.depth
                           : DistanceToPlace(origin.AsPoint(), place);
}

inline double Lean(const MixedOrigin& origin, const PlanePoint& place,
                   double distance) {
  return origin.is_segment ? origin.x : Lean(origin.AsPoint(), place, distance);
}

inline double NearMiss(const MixedOrigin& origin, const HalfEdgeFrame& frame,
                       const PlanePoint& place) {
  return origin.is_segment
             ? kNearMissOfCurves * (frame.length + std::abs(origin.sigma)) /
                   origin.depth
             : NearMiss(origin.AsPoint(), frame, place, kNearMissOfCurves);
}

inline bool LiesOnEdge(const MixedOrigin& origin, const HalfEdgeFrame& frame) {
  return !origin.is_segment && LiesOnEdge(origin.AsPoint(), frame);
}

inline MixedOrigin UnfoldLeft(const MixedOrigin& origin,
                              const HalfEdgeFrame& frame) {
  if (!origin.is_segment) {
    const Origin point = UnfoldLeft(origin.AsPoint(), frame);
    return {point.x, point.depth, point.sigma};
  }
  return {
      .x = origin.x * frame.left_x + origin.depth * frame.left_y,
      .depth = std::max(origin.depth * frame.left_x - origin.x * frame.left_y,
                        kLeastHeight),
      .sigma = origin.sigma,
      .is_segment = true};
}

inline MixedOrigin UnfoldRight(const MixedOrigin& origin,
                               const HalfEdgeFrame& frame,
                               double right_length) {
  if (!origin.is_segment) {
    const Origin point = UnfoldRight(origin.AsPoint(), frame, right_length);
    return {point.x, point.depth, point.sigma};
  }
  // The exit runs from the apex.
  return {
      .x = -(origin.x * frame.right_x + origin.depth * frame.right_y),
      .depth = std::max(origin.x * frame.right_y - origin.depth * frame.right_x,
                        kLeastHeight),
      .sigma =
          origin.sigma + origin.x * frame.apex_x + origin.depth * frame.apex_y,
      .is_segment = true};
}

inline double ProjectLeft(const MixedOrigin& origin, double at,
                          const HalfEdgeFrame& frame, double left_length) {
  if (!origin.is_segment) {
    return ProjectLeft(origin.AsPoint(), at, frame, left_length);
  }
  const double across = origin.depth * frame.left_x - origin.x * frame.left_y;
  const double t = origin.depth * at / across;
  return across > 0 && t < left_length ? std::max(t, 0.0) : left_length;
}

inline double ProjectRight(const MixedOrigin& origin, double at,
                           const HalfEdgeFrame& frame, double right_length) {
  if (!origin.is_segment) {
    return ProjectRight(origin.AsPoint(), at, frame, right_length);
  }
  const double across = origin.x * frame.right_y - origin.depth * frame.right_x;
  const double t = origin.depth * (frame.length - at) / across;
  return across > 0 && t < right_length ? std::max(t, 0.0) : right_length;
}

inline MixedOrigin Mirror(const MixedOrigin& origin, double length) {
  if (!origin.is_segment) {
    const Origin point = Mirror(origin.AsPoint(), length);
    return {point.x, point.depth, point.sigma};
  }
  return {.x = -origin.x,
          .depth = origin.depth,
          .sigma = origin.sigma + origin.x * length,
          .is_segment = true};
}

// A window of either kind, as observers see it.
inline MixedWindow AsMixed(const MixedWindow& window) { return window; }
inline MixedWindow AsMixed(const Window& window) {
  return {window.interval,
          {window.origin.x, window.origin.depth, window.origin.sigma},
          window.begin_distance,
          window.end_distance};
}

}  // namespace geodesic

#endif  // GEODESIC_SOLVER_WINDOWS_MIXED_ORIGIN_H_
