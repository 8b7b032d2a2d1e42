// Windows in the plane: a window on half-edge A -> B holds the paths that
// enter the face left of it through an interval of AB, straight from one
// pseudo-source unfolded into the plane of that face.
//
// This is all of the geometry of points; that of curves is in mixed_origin.h.
// Functions select instead of branching, since loops over columns
// (list_kernels.h) call them too.
//
// Surazhsky et al.: Fast exact and approximate geodesics on meshes. ACM TOG
// 24(3), 2005, section 3:
//
//   paper     here
//   b0, b1    Interval             begin and end of a window, from A
//   s         Origin               the unfolded pseudo-source, at (x, -depth)
//   sigma     Origin::sigma        distance from the source to s
//   d0, d1    begin_distance,      at b0 and b1; in the paper from s, here from
//             end_distance         the source
//   p0, p1    A = (0, 0),          ends of the half-edge, in its frame
//             B = (length, 0)      (Mesh::frame)
//             C, the apex          the face's third corner, above AB
//             Label                the least distance over the interval

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

  bool operator==(const Origin&) const = default;

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
  const double least =
      interval.end < origin.x ? end_distance : origin.sigma + origin.depth;
  return interval.begin > origin.x ? begin_distance : least;
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

// Length of the path from the source to a place of the face by way of
// (through, 0), straight if that is where the ray crosses.
template <typename OriginType>
double PathToPlace(const OriginType& origin, double through, double crossing,
                   const PlanePoint& place) {
  return through == crossing
             ? origin.sigma + DistanceToPlace(origin, place)
             : origin.PathTo(through) + EdgePointTo(through, place);
}

// Whether the pseudo-source lies inside AB, where a face without area has put
// it.
inline bool LiesOnEdge(const Origin& origin, const HalfEdgeFrame& frame) {
  return origin.depth <= kCollapsedFace * frame.length && origin.x > 0 &&
         origin.x < frame.length;
}

// Whether an end of AB is so near to a pseudo-source on AB that it hides more
// than rounding: then it is a pseudo-source and opens what it hides.
template <typename OriginType>
bool EndsHide(const OriginType& origin, const HalfEdgeFrame& frame) {
  const double to_end = std::min(origin.x, frame.length - origin.x);
  return to_end <= kNearVertex * frame.length ||
         origin.depth > kHiddenWedge * to_end;
}

// Whether the rays of a part of AB come from a pseudo-source in there, which
// then sees all of AB.
template <typename OriginType>
bool SeesAllOfEdge(const OriginType& origin, const Interval& part,
                   const HalfEdgeFrame& frame) {
  const double near = kCollapsedFace * frame.length;
  return LiesOnEdge(origin, frame) && !EndsHide(origin, frame) &&
         part.begin - near <= origin.x && origin.x <= part.end + near;
}

// Into a frame that is turned over: A and B change places.
inline Origin Mirror(const Origin& origin, double length) {
  return {.x = length - origin.x, .depth = origin.depth, .sigma = origin.sigma};
}
inline Interval Mirror(const Interval& interval, double length) {
  return {length - interval.end, length - interval.begin};
}

// How far right the ray through (at, 0) runs while it rises by origin.depth.
inline double RunTo(const Origin& origin, double at) { return at - origin.x; }

// The left side AC or the right side CB of a face, which windows that came in
// through AB leave it by.
enum Side { kLeft, kRight };

// That side, seen from O, where it meets AB. On the right all is mirrored, so
// that either side is written once: O is B, and `cosine` and `edge` are as they
// look from there.
template <Side kSide>
struct FaceSide {
  HalfEdge half_edge;
  Exit exit;
  double edge;          // |AB|
  double length;        // |OC|
  double cosine, sine;  // of the angle at O
  PlanePoint apex;      // C in the frame of AB

  // Of the face left of h.
  FaceSide(const Mesh& mesh, HalfEdge h)
      : FaceSide(mesh, mesh.frame(h), kSide == kLeft ? Prev(h) : Next(h)) {}

  // Whether windows reach it through this interval. `crossing`: CrossingTo the
  // apex.
  static bool IsReached(const Interval& interval, double crossing) {
    return kSide == kLeft ? crossing > interval.begin : crossing < interval.end;
  }

  // The part of OC, from O, that an interval's rays hit. REQUIRES: IsReached.
  template <typename OriginType>
  Interval Hit(const OriginType& origin, const Interval& interval,
               double crossing) const {
    const double near = kSide == kLeft ? interval.begin : interval.end;
    const double far = kSide == kLeft ? interval.end : interval.begin;
    const bool sees_apex =
        kSide == kLeft ? crossing < interval.end : crossing > interval.begin;
    return {HitOf(origin, near), sees_apex ? length : HitOf(origin, far)};
  }

  // A part of OC, from O, as an interval of the exit, which on the right runs
  // from C.
  Interval InExit(const Interval& part) const {
    return kSide == kLeft ? part : Mirror(part, length);
  }

  // Of a place on AB.
  double FromO(double at) const { return kSide == kLeft ? at : edge - at; }
  // Of a vector along AB.
  static double Mirrored(double run) { return kSide == kLeft ? run : -run; }

 private:
  FaceSide(const Mesh& mesh, const HalfEdgeFrame& frame, HalfEdge side)
      : half_edge(side),
        exit(kSide == kLeft ? frame.left_exit : frame.right_exit),
        edge(frame.length),
        length(mesh.frame(side).length),
        cosine(kSide == kLeft ? frame.left_x : -frame.right_x),
        sine(kSide == kLeft ? frame.left_y : frame.right_y),
        apex(ApexOf(frame)) {}

  // Distance from O to where the ray through (at, 0) hits OC.
  // Rays along the edge (and rounding) may hit it nowhere or beyond C.
  template <typename OriginType>
  double HitOf(const OriginType& origin, double at) const {
    const double across =
        origin.depth * cosine - Mirrored(RunTo(origin, at)) * sine;
    double hit = origin.depth * FromO(at) / across;
    hit = hit > 0 ? hit : 0;
    hit = hit < length ? hit : length;
    return across > 0 ? hit : length;
  }
};

// The pseudo-source in the frame of the exit: a rotation about O.
template <Side kSide>
Origin Unfold(const FaceSide<kSide>& side, const Origin& origin) {
  const double x = side.FromO(origin.x);
  const double along = x * side.cosine - origin.depth * side.sine;
  const double depth = x * side.sine + origin.depth * side.cosine;
  return {.x = kSide == kLeft ? along : side.length - along,
          .depth = std::max(depth, kLeastHeight),
          .sigma = origin.sigma};
}

}  // namespace geodesic

#endif  // GEODESIC_SOLVER_WINDOWS_WINDOW_H_
