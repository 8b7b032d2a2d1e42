// All windows that wait at a half-edge cross its face together.

#ifndef GEODESIC_SOLVER_RULES_FACE_CROSSING_H_
#define GEODESIC_SOLVER_RULES_FACE_CROSSING_H_

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "geodesic/distance_field.h"
#include "geodesic/mesh.h"
#include "solver/rules/envelope.h"
#include "solver/rules/list_kernels.h"
#include "solver/rules/shadow_fan.h"
#include "solver/windows/window.h"
#include "solver/windows/window_columns.h"

namespace geodesic {

// Loops without branches over columns. Scratch that is kept for its memory: one
// for each thread. REQUIRES: the front's origins are points, and the mesh has
// no faces without area.
template <typename Front>
class FaceCrossing {
 public:
  // The front outlives this.
  explicit FaceCrossing(const Front& front)
      : front_(front), mesh_(front.mesh()) {}

  // The windows that are to cross: sorted along their half-edge and disjoint.
  WindowColumns& list() { return list_; }

  // Takes the windows of list(), at least one, across the face of h.
  // relax(vertex, distance, arrival, ray), as Front::Relax, hears of the
  // shortest path to the apex if that improves; then hand_on(side, exit,
  // children, label) of the children across either side, if there are any: in
  // the frame that an oriented neighbour has, without those that are useless
  // (list_kernels.h), trimmed against each other. No child's label is below
  // `label`.
  template <typename Relax, typename HandOn>
  void Cross(HalfEdge h, Relax relax, HandOn hand_on);

 private:
  static constexpr double kUseless = std::numeric_limits<double>::infinity();

  void Reserve(size_t count);
  // Returns the distance of the apex that is known then.
  template <typename Relax>
  double ReachApex(HalfEdge h, const HalfEdgeFrame& frame, Relax relax);
  void CrossLeft(const HalfEdgeFrame& frame, const ExitEdge& edge);
  void CrossRight(const HalfEdgeFrame& frame, const ExitEdge& edge);
  // Trims children_. Returns a lower bound on their labels.
  double TrimChildren(const ExitEdge& edge);

  const Front& front_;
  const Mesh& mesh_;
  WindowColumns list_, children_;
  std::vector<double> crossings_, misses_, labels_;
  std::vector<uint32_t> hits_;
  Envelope envelope_;
};

template <typename Front>
template <typename Relax, typename HandOn>
void FaceCrossing<Front>::Cross(HalfEdge h, Relax relax, HandOn hand_on) {
  const HalfEdgeFrame& frame = mesh_.frame(h);
  Reserve(list_.size);
  CrossingsToApex(frame, list_, crossings_.data(), misses_.data());
  const double apex_distance = ReachApex(h, frame, relax);
  if (frame.left_exit != kNoHalfEdge) {
    const ExitEdge edge{mesh_.frame(Prev(h)).length,
                        front_.distance(mesh_.From(h)), apex_distance};
    CrossLeft(frame, edge);
    const double label = TrimChildren(edge);
    if (children_.size > 0) hand_on(Prev(h), frame.left_exit, children_, label);
  }
  if (frame.right_exit != kNoHalfEdge) {
    const ExitEdge edge{mesh_.frame(Next(h)).length, apex_distance,
                        front_.distance(mesh_.To(h))};
    CrossRight(frame, edge);
    const double label = TrimChildren(edge);
    if (children_.size > 0)
      hand_on(Next(h), frame.right_exit, children_, label);
  }
}

template <typename Front>
void FaceCrossing<Front>::Reserve(size_t count) {
  children_.Reserve(count);
  const size_t room = count + WindowColumns::kPadding;
  if (crossings_.size() >= room) return;
  for (auto* column : {&crossings_, &misses_, &labels_}) {
    column->resize(2 * room);
  }
  hits_.resize(2 * room);
}

template <typename Front>
template <typename Relax>
double FaceCrossing<Front>::ReachApex(HalfEdge h, const HalfEdgeFrame& frame,
                                      Relax relax) {
  const PlanePoint apex = ApexOf(frame);
  const uint32_t vertex = mesh_.Apex(h);
  double best = front_.distance(vertex);
  Arrival arrival;
  IncomingRay ray;
  bool improves = false;
  // Gathered without a branch: which windows see the apex cannot be foreseen.
  size_t hits = 0;
  for (size_t i = 0; i < list_.size; ++i) {
    hits_[hits] = static_cast<uint32_t>(i);
    hits += misses_[i] <= 0;
  }
  for (const uint32_t i : std::span(hits_).first(hits)) {
    const Origin origin = list_.OriginAt(i);
    // The point of the interval nearest to the ray through the apex; paths
    // through it to the apex are real, and straight if the ray is in there.
    const double through =
        std::clamp(crossings_[i], list_.begin[i], list_.end[i]);
    const bool is_straight = through == crossings_[i];
    const double distance =
        origin.sigma +
        (is_straight ? DistanceToPlace(origin, apex)
                     : origin.DistanceTo(through) + EdgePointTo(through, apex));
    if (!Front::Improves(distance, best)) continue;
    improves = true;
    best = distance;
    arrival = {list_.pseudo_source[i], h, origin.x, origin.depth};
    ray = RayPast(mesh_, h, origin, std::abs(through - crossings_[i]));
  }
  if (improves) relax(vertex, best, arrival, ray);
  return best;
}

template <typename Front>
void FaceCrossing<Front>::CrossLeft(const HalfEdgeFrame& frame,
                                    const ExitEdge& edge) {
  size_t last = list_.size;
  while (last > 0 && crossings_[last - 1] <= list_.begin[last - 1]) --last;
  children_.size = 0;
  if (last == 0) return;
  ChildrenLeft(frame, edge, list_, crossings_.data(), 0, last, children_,
               labels_.data());
}

template <typename Front>
void FaceCrossing<Front>::CrossRight(const HalfEdgeFrame& frame,
                                     const ExitEdge& edge) {
  size_t first = 0;
  while (first < list_.size && crossings_[first] >= list_.end[first]) ++first;
  children_.size = 0;
  if (first == list_.size) return;
  ChildrenRight(frame, edge, list_, crossings_.data(), first, list_.size,
                children_, labels_.data());
}

template <typename Front>
double FaceCrossing<Front>::TrimChildren(const ExitEdge& edge) {
  double least = kUseless, most = 0;
  for (size_t i = 0; i < children_.size; ++i) {
    least = std::min(least, labels_[i]);
    most = std::max(most, labels_[i]);
  }
  if (most == kUseless) {
    size_t kept = 0;
    for (size_t i = 0; i < children_.size; ++i) {
      if (labels_[i] == kUseless) continue;
      if (kept != i) children_.Move(i, kept);
      ++kept;
    }
    children_.size = kept;
  }
  envelope_.Trim(edge.length, front_.MayChangeOverTwice(), children_);
  return least;
}

}  // namespace geodesic

#endif  // GEODESIC_SOLVER_RULES_FACE_CROSSING_H_
