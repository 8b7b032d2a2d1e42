// How a single window crosses its face under Chen and Han's rule: where its
// rays meet the apex, and which children leave across the two other sides. What
// is done with these is up to ch_rule.h and pch_rule.h.
//
//   Xin, Wang     here
//   I, sigma      ChenHanWindow::origin    the unfolded pseudo-source, its
//                                          distance
//   A, B          ChenHanWindow::interval  begin and end of the window
//   v1, v2        corners a, b             ends of the window's edge
//   v3            corner c, apex           the face's third corner

#ifndef GEODESIC_SOLVER_RULES_CHEN_HAN_CROSSING_H_
#define GEODESIC_SOLVER_RULES_CHEN_HAN_CROSSING_H_

#include <cmath>
#include <cstdint>
#include <limits>

#include "geodesic/mesh.h"
#include "solver/rules/front.h"
#include "solver/rules/shadow_fan.h"
#include "solver/windows/window.h"

namespace geodesic {

struct ChenHanWindow {
  Interval interval;
  Origin origin;
  HalfEdge half_edge;
  uint32_t pseudo_source;
};

// The best window so far to reach the apex across a half-edge, among those
// whose ray no other window can go round.
struct BestAtApex {
  double distance = std::numeric_limits<double>::infinity();
  double lean = 0;
};

// Where the rays of a window meet the apex of its face.
struct ApexMeeting {
  // Of the ray into the apex with the window's edge: beyond an end of the
  // window no ray of its own reaches the apex.
  double crossing;
  // If one does: the distance that way, and the sine of its angle to AB's
  // normal, which grows as it comes from further left.
  double distance = std::numeric_limits<double>::infinity();
  double lean = 0;

  // The children that stay beside the best window: all of the best one; of a
  // worse one that on its own side of the best one's ray.
  bool goes_left(const BestAtApex& best) const {
    return !IsWorse(best) || lean > best.lean - kSameRay;
  }
  bool goes_right(const BestAtApex& best) const {
    return !IsWorse(best) || lean < best.lean + kSameRay;
  }

 private:
  bool IsWorse(const BestAtApex& best) const {
    return Exceeds(distance, best.distance);
  }
};

// relax(vertex, distance, arrival, ray), as Front::Relax, hears of a path to
// the apex, if there is one.
template <typename Front, typename Relax>
ApexMeeting MeetApex(const Front& front, const ChenHanWindow& window,
                     Relax relax) {
  const auto& [interval, origin, h, pseudo_source] = window;
  const Mesh& mesh = front.mesh();
  const HalfEdgeFrame& frame = mesh.frame(h);
  const uint32_t c = mesh.Apex(h);
  const Arrival arrival{pseudo_source, h, origin.x, origin.depth};
  const PlanePoint apex = ApexOf(frame);
  ApexMeeting meeting{.crossing = CrossingTo(origin, apex)};
  const double crossing = meeting.crossing;
  if (crossing > interval.begin && crossing < interval.end) {
    const double to_apex = DistanceToPlace(origin, apex);
    meeting.distance = origin.sigma + to_apex;
    meeting.lean = (apex.x - origin.x) / to_apex;
    relax(c, meeting.distance, arrival, RayThrough(h, origin, apex));
    return meeting;
  }
  const double near_miss = NearMiss(origin, frame, apex);
  const Window whole = Window::Over(interval, origin);
  if (crossing <= interval.begin) {
    if (crossing > interval.begin - near_miss) {
      relax(c, whole.begin_distance + EdgePointTo(interval.begin, apex),
            arrival, RayPast(mesh, h, origin, interval.begin - crossing));
    }
  } else if (crossing < interval.end + near_miss) {
    relax(c, whole.end_distance + EdgePointTo(interval.end, apex), arrival,
          RayPast(mesh, h, origin, crossing - interval.end));
  }
  return meeting;
}

// Calls emit(half_edge, window) for the child across a side that the window
// reaches, in every face beyond it. kFilters: not for one that the filter of
// Xin and Wang finds useless.
template <Side kSide, bool kFilters, typename Front, typename Emit>
void LeaveAcross(const Front& front, const ChenHanWindow& parent,
                 double crossing, Emit emit) {
  const Mesh& mesh = front.mesh();
  const FaceSide<kSide> side(mesh, parent.half_edge);
  if (side.exit == kNoHalfEdge) return;
  const Interval hit = side.Hit(parent.origin, parent.interval, crossing);
  const Interval interval = side.InExit(hit);
  if (interval.width() <= kLeastWidth * side.length) return;
  const Window child = Window::Over(interval, Unfold(side, parent.origin));
  if constexpr (kFilters) {
    const uint32_t a = mesh.From(parent.half_edge);
    const uint32_t b = mesh.To(parent.half_edge);
    const uint32_t c = mesh.Apex(parent.half_edge);
    if (front.EndsAreNearer(child, side.length, kSide == kLeft ? a : c,
                            kSide == kLeft ? c : b)) {
      return;
    }
    // Third condition: through the end of the parent's edge that is no end of
    // the child's.
    const double dx = hit.begin * side.cosine - side.edge;
    const double dy = hit.begin * side.sine;
    if (Exceeds(kSide == kLeft ? child.begin_distance : child.end_distance,
                front.distance(kSide == kLeft ? b : a) +
                    std::sqrt(dx * dx + dy * dy))) {
      return;
    }
  }
  if (side.exit < kIrregularExit) {
    emit(side.exit, child);
    return;
  }
  front.Cross(
      side.half_edge, child.origin, child.interval,
      [&](HalfEdge half_edge, const Origin& origin, const Interval& within) {
        emit(half_edge, Window::Over(within, origin));
      });
}

}  // namespace geodesic

#endif  // GEODESIC_SOLVER_RULES_CHEN_HAN_CROSSING_H_
