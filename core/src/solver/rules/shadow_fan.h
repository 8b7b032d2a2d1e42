// What a pseudo-source has to see: a shortest path that bends at a vertex has
// an angle of pi or more on either side there (Mitchell, Mount, Papadimitriou
// 1987), so beyond the vertex only its shadow is of interest, the fan between
// the two directions that make an angle of pi with the path that arrives.

#ifndef GEODESIC_SOLVER_RULES_SHADOW_FAN_H_
#define GEODESIC_SOLVER_RULES_SHADOW_FAN_H_

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "geodesic/mesh.h"
#include "solver/windows/mixed_origin.h"
#include "solver/windows/window.h"
#include "surface/plane_point.h"
#include "tolerances.h"

namespace geodesic {

// From where a shortest path comes to a vertex: along an edge, or through a
// half-edge opposite to the vertex. A direction that is not known hides
// nothing.
struct IncomingRay {
  HalfEdge half_edge = kNoHalfEdge;
  // Of the angle to the half-edge's normal; NaN along the half-edge, in either
  // direction. kFanMargin covers the rounding. Not NaN without a half-edge: the
  // path is bent.
  float tangent = std::numeric_limits<float>::quiet_NaN();

  static IncomingRay Along(HalfEdge half_edge) { return {half_edge}; }
  // Of a path through the end of a window that misses the vertex: it bends
  // there, at a point that is no vertex. So other faces around the vertex may
  // lie where no window goes.
  static IncomingRay Bent() { return {kNoHalfEdge, 0}; }
  // Not known if the tangent is beyond single precision.
  static IncomingRay Across(HalfEdge half_edge, double tangent) {
    const auto rounded = static_cast<float>(tangent);
    return std::isfinite(rounded) ? IncomingRay{half_edge, rounded}
                                  : IncomingRay{};
  }

  bool is_known() const { return half_edge != kNoHalfEdge; }
  bool is_bent() const { return !is_known() && !std::isnan(tangent); }
};

// The ray of a window on half_edge into the apex.
inline IncomingRay RayThrough(HalfEdge half_edge, const Origin& origin,
                              const PlanePoint& apex) {
  return IncomingRay::Across(half_edge,
                             (apex.x - origin.x) / (apex.y + origin.depth));
}
inline IncomingRay RayThrough(HalfEdge half_edge, const MixedOrigin& origin,
                              const PlanePoint& apex) {
  return origin.is_segment
             ? IncomingRay::Across(half_edge, origin.x / origin.depth)
             : RayThrough(half_edge, origin.AsPoint(), apex);
}

// Of the faces around v, over their longest edges.
inline double LeastHeightAround(const Mesh& mesh, uint32_t v) {
  double least = std::numeric_limits<double>::infinity();
  for (const HalfEdge h : mesh.Outgoing(v)) {
    const HalfEdgeFrame& frame = mesh.frame(h);
    least = std::min(least, frame.length * frame.apex_y / mesh.LongestSide(h));
  }
  return least;
}

// The ray of a window on half_edge into the apex, which lies this far outside
// the window, across the half-edge.
template <typename OriginType>
IncomingRay RayPast(const Mesh& mesh, HalfEdge half_edge,
                    const OriginType& origin, double missed_by) {
  if (missed_by > 0 &&
      missed_by >
          kMissedFaces * LeastHeightAround(mesh, mesh.Apex(half_edge))) {
    return IncomingRay::Bent();
  }
  return RayThrough(half_edge, origin, ApexOf(mesh.frame(half_edge)));
}

// The fan behind one vertex of a mesh without irregular edges.
class ShadowFan {
 public:
  // REQUIRES: the faces around v form one fan, and `ray` is known.
  ShadowFan(const Mesh& mesh, uint32_t v, const IncomingRay& ray)
      : mesh_(mesh), v_(v) {
    FindStarts(ray);
  }

  // Calls visit(half_edge, part) for each half-edge that leaves v and whose
  // face the shadow meets, with the part of the opposite edge Next(half_edge)
  // that lies in there.
  template <typename Visit>
  void ForEachFace(Visit visit) const {
    const std::optional<Limit> left = FindLimit<kLeft>(left_);
    const std::optional<Limit> right = FindLimit<kRight>(right_);
    // Where the faces around v close, a side that is nowhere pi away from the
    // ray takes less than pi in all: a spike has no shadow.
    if (left.has_value() != right.has_value() && !mesh_.IsBoundary(v_)) return;
    if (left.has_value() && right.has_value() &&
        left->half_edge == right->half_edge) {
      Interval part{left->at, right->at};
      if (part.width() > 0) visit(left->half_edge, part);
      return;
    }
    if (left.has_value()) {
      visit(left->half_edge, Interval{left->at, OppositeLength(*left)});
    }
    HalfEdge h = left.has_value() ? LeftOf(left->half_edge) : kNoHalfEdge;
    while (h != kNoHalfEdge && !(right.has_value() && h == right->half_edge)) {
      visit(h, Interval{0, mesh_.frame(Next(h)).length});
      h = LeftOf(h);
    }
    if (!right.has_value()) return;
    visit(right->half_edge, Interval{0, right->at});
    // At a boundary the two sides do not meet.
    if (left.has_value() && h == right->half_edge) return;
    h = RightOf(right->half_edge);
    while (h != kNoHalfEdge) {
      visit(h, Interval{0, mesh_.frame(Next(h)).length});
      h = RightOf(h);
    }
  }

 private:
  // A unit vector, also as a rotation.
  using Direction = PlanePoint;
  static Direction Back(const Direction& a) { return {a.x, -a.y}; }

  // Where a side of the shadow ends: at `at` on Next(half_edge).
  struct Limit {
    HalfEdge half_edge;
    double at;
  };
  // Where a walk around v starts: the first face, and the angle between the
  // ray and the edge that leads into it.
  struct Start {
    HalfEdge half_edge = kNoHalfEdge;
    Direction angle{1, 0};
  };

  double OppositeLength(const Limit& limit) const {
    return mesh_.frame(Next(limit.half_edge)).length;
  }
  // Of half-edges that leave v, the next counterclockwise and clockwise;
  // kNoHalfEdge at a boundary.
  HalfEdge LeftOf(HalfEdge h) const { return mesh_.Twin(Prev(h)); }
  HalfEdge RightOf(HalfEdge h) const {
    const HalfEdge twin = mesh_.Twin(h);
    return twin == kNoHalfEdge ? kNoHalfEdge : Next(twin);
  }

  void FindStarts(const IncomingRay& ray) {
    const HalfEdge h = ray.half_edge;
    if (std::isnan(ray.tangent)) {
      const bool leaves = mesh_.From(h) == v_;
      left_.half_edge = leaves ? h : mesh_.Twin(h);
      right_.half_edge = leaves ? RightOf(h) : Next(h);
    } else {
      const HalfEdgeFrame& frame = mesh_.frame(h);
      const double t = ray.tangent;
      const double norm = 1 / std::sqrt(1 + t * t);
      // From v back to where the ray comes from, and to the ends of h.
      const Direction back{-t * norm, -norm};
      const Direction to_a{-frame.left_x, -frame.left_y};
      const Direction to_b{-frame.right_x, -frame.right_y};
      left_ = {mesh_.Twin(Next(h)), Product(Back(back), to_b)};
      right_ = {RightOf(Prev(h)), Product(Back(to_a), back)};
    }
    const Direction margin{std::cos(kFanMargin), std::sin(kFanMargin)};
    left_.angle = Product(left_.angle, margin);
    right_.angle = Product(right_.angle, margin);
  }

  // Walks from face to face until the angle to the ray is pi. No limit if a
  // boundary comes first, or the way round v is shorter.
  template <Side kSide>
  std::optional<Limit> FindLimit(const Start& start) const {
    Direction angle = start.angle;
    HalfEdge h = start.half_edge;
    // Along a needle, the face that the ray comes through may take all of pi.
    if (h != kNoHalfEdge && angle.y <= 0) {
      return Limit{h, kSide == kLeft ? 0 : mesh_.frame(Next(h)).length};
    }
    for (size_t i = 0; h != kNoHalfEdge && i < Degree(); ++i) {
      const HalfEdgeFrame& frame = mesh_.frame(h);
      const Direction corner{frame.left_x, frame.left_y};
      const Direction turned = Product(angle, corner);
      if (turned.y <= 0) {
        // The direction at pi, from h.
        const Direction limit = kSide == kLeft
                                    ? Direction{-angle.x, angle.y}
                                    : Product(corner, {-angle.x, -angle.y});
        return Limit{h, HitOnOpposite(frame, limit, h)};
      }
      angle = turned;
      h = kSide == kLeft ? LeftOf(h) : RightOf(h);
    }
    return std::nullopt;
  }
  size_t Degree() const { return mesh_.Outgoing(v_).size(); }

  // Where a ray from A meets BC, from B.
  double HitOnOpposite(const HalfEdgeFrame& frame, const Direction& ray,
                       HalfEdge h) const {
    const double length = mesh_.frame(Next(h)).length;
    const double across = ray.x * frame.right_y - ray.y * frame.right_x;
    const double t = ray.y * frame.length / across;
    return across > 0 ? std::clamp(t, 0.0, length) : length;
  }

  const Mesh& mesh_;
  const uint32_t v_;
  Start left_, right_;
};

}  // namespace geodesic

#endif  // GEODESIC_SOLVER_RULES_SHADOW_FAN_H_
