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

  bool operator==(const MixedOrigin&) const = default;

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

inline MixedOrigin AsMixed(const Origin& origin) {
  return {origin.x, origin.depth, origin.sigma};
}

// A window of either kind, as observers see it.
inline MixedWindow AsMixed(const MixedWindow& window) { return window; }
inline MixedWindow AsMixed(const Window& window) {
  return {window.interval, AsMixed(window.origin), window.begin_distance,
          window.end_distance};
}

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

inline double RunTo(const MixedOrigin& origin, double at) {
  return origin.is_segment ? origin.x : RunTo(origin.AsPoint(), at);
}

template <Side kSide>
MixedOrigin Unfold(const FaceSide<kSide>& side, const MixedOrigin& origin) {
  if (!origin.is_segment) return AsMixed(Unfold(side, origin.AsPoint()));
  const double x = side.Mirrored(origin.x);
  // On the right the exit runs from the apex.
  return {.x = side.Mirrored(x * side.cosine + origin.depth * side.sine),
          .depth = std::max(origin.depth * side.cosine - x * side.sine,
                            kLeastHeight),
          .sigma = kSide == kLeft ? origin.sigma
                                  : origin.sigma + origin.x * side.apex.x +
                                        origin.depth * side.apex.y,
          .is_segment = true};
}

inline MixedOrigin Mirror(const MixedOrigin& origin, double length) {
  if (!origin.is_segment) return AsMixed(Mirror(origin.AsPoint(), length));
  return {.x = -origin.x,
          .depth = origin.depth,
          .sigma = origin.sigma + origin.x * length,
          .is_segment = true};
}

}  // namespace geodesic

#endif  // GEODESIC_SOLVER_WINDOWS_MIXED_ORIGIN_H_
