// How the windows that wait at a half-edge cross its face: trimmed against each
// other, all together, by one thread. Reads the front and changes nothing
// there; what comes out is applied afterwards (list_rule.h).

#ifndef GEODESIC_RULES_LIST_CROSSING_H_
#define GEODESIC_RULES_LIST_CROSSING_H_

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "geodesic/distance_field.h"
#include "geodesic/mesh.h"
#include "rules/envelope.h"
#include "rules/list_kernels.h"
#include "rules/shadow_fan.h"
#include "tolerances.h"
#include "windows/window_blocks.h"
#include "windows/window_columns.h"

namespace geodesic {

// Across which side of the neighbouring face windows come: those that come
// across its left side arrive nearer to the half-edge's begin.
enum Side { kLeft, kRight };

// What waits at a half-edge: chains of lists, each list trimmed. By Side.
using WaitingLists = std::array<WindowBlock*, 2>;

// What comes of the windows of one half-edge.
struct Crossed {
  // Windows that cross a side of the face.
  struct HandedOn {
    WindowBlock* list = nullptr;  // none
    double label = 0;             // no window's label is below
  };

  uint32_t waited;      // windows
  uint32_t propagated;  // those among them that were not useless
  // The best of them at the apex, if it improves that.
  double apex_distance;
  Arrival arrival;
  IncomingRay ray;
  std::array<HandedOn, 2> sides;  // by Side
  // What the front is to observe (ListCrossing::Observed).
  uint32_t first_observed, observed_count;
};

// REQUIRES: the front's origins are points.
template <typename Front>
class ListCrossing {
 public:
  struct ObservedWindow {
    Window window;
    uint32_t pseudo_source;
  };

  ListCrossing(const Front& front, BlockPool& pool)
      : front_(front), mesh_(front.mesh()), blocks_(pool) {}

  // Takes and frees the lists that wait at h.
  void Cross(HalfEdge h, const WaitingLists& lists, Crossed& crossed);

  WindowBlocks& blocks() { return blocks_; }
  // The windows of something crossed here that the front watches, until they
  // are forgotten.
  std::span<const ObservedWindow> Observed(const Crossed& crossed) const {
    return std::span(observed_).subspan(crossed.first_observed,
                                        crossed.observed_count);
  }
  void ForgetObserved() { observed_.clear(); }

 private:
  // Moves what waits to list_.
  void Take(const WaitingLists& lists, double length, Crossed& crossed);
  // Drops useless windows of list_ from `first` on.
  void DropStale(size_t first);
  void ReachApex(HalfEdge h, const HalfEdgeFrame& frame, Crossed& crossed);
  void CrossLeft(HalfEdge h, const HalfEdgeFrame& frame, Crossed& crossed);
  void CrossRight(HalfEdge h, const HalfEdgeFrame& frame, Crossed& crossed);
  // Trims children_ and puts them where they can be handed on.
  void Store(const ExitEdge& edge, Crossed::HandedOn& handed_on);

  const Front& front_;
  const Mesh& mesh_;
  WindowBlocks blocks_;
  std::vector<ObservedWindow> observed_;

  // Scratch, kept for its memory.
  WindowColumns list_, children_;
  std::vector<double> crossings_, misses_, labels_;
  Envelope envelope_;
};

template <typename Front>
void ListCrossing<Front>::Cross(HalfEdge h, const WaitingLists& lists,
                                Crossed& crossed) {
  const HalfEdgeFrame& frame = mesh_.frame(h);
  crossed.sides = {};
  crossed.first_observed = crossed.observed_count = 0;
  Take(lists, frame.length, crossed);
  if (list_.size == 0) {
    crossed.apex_distance = std::numeric_limits<double>::infinity();
    return;
  }
  if (front_.Watches(h)) {
    crossed.first_observed = static_cast<uint32_t>(observed_.size());
    crossed.observed_count = crossed.propagated;
    for (size_t i = 0; i < list_.size; ++i) {
      observed_.push_back(
          {Window::Over({list_.begin[i], list_.end[i]}, list_.OriginAt(i)),
           list_.pseudo_source[i]});
    }
  }
  const size_t room = list_.size + WindowColumns::kPadding;
  if (crossings_.size() < room) {
    crossings_.resize(2 * room);
    misses_.resize(2 * room);
    labels_.resize(2 * room);
  }
  children_.Reserve(list_.size);
  CrossingsToApex(frame, list_, crossings_.data(), misses_.data());
  ReachApex(h, frame, crossed);
  if (frame.left_exit != kNoHalfEdge) CrossLeft(h, frame, crossed);
  if (frame.right_exit != kNoHalfEdge) CrossRight(h, frame, crossed);
}

template <typename Front>
void ListCrossing<Front>::Take(const WaitingLists& lists, double length,
                               Crossed& crossed) {
  list_.size = 0;
  crossed.waited = 0;
  for (WindowBlock* list : lists) {
    while (list != nullptr) {
      crossed.waited += list->count;
      const size_t middle = list_.size;
      list = blocks_.Take(list, list_);
      DropStale(middle);
      envelope_.Merge(length, front_.MayChangeOverTwice(), middle, list_);
    }
  }
  crossed.propagated = static_cast<uint32_t>(list_.size);
}

template <typename Front>
void ListCrossing<Front>::DropStale(size_t first) {
  size_t kept = first;
  for (size_t i = first; i < list_.size; ++i) {
    // The pseudo-source has improved since, and by so much that its newer
    // window wins whatever this one holds: by less it may have tied there.
    const double improved =
        list_.sigma[i] - front_.PseudoSourceDistance(list_.pseudo_source[i]);
    if (improved > 0 &&
        improved > kDominance * (list_.sigma[i] + list_.depth[i] +
                                 std::abs(list_.begin[i] - list_.x[i]))) {
      continue;
    }
    if (kept != i) list_.Move(i, kept);
    ++kept;
  }
  list_.size = kept;
}

template <typename Front>
void ListCrossing<Front>::ReachApex(HalfEdge h, const HalfEdgeFrame& frame,
                                    Crossed& crossed) {
  const PlanePoint apex = ApexOf(frame);
  double best = front_.distance(mesh_.Apex(h));
  for (size_t i = 0; i < list_.size; ++i) {
    if (!(misses_[i] <= 0)) continue;
    const Origin origin = list_.OriginAt(i);
    const double through =
        std::clamp(crossings_[i], list_.begin[i], list_.end[i]);
    const bool is_straight = through == crossings_[i];
    const double distance =
        origin.sigma +
        (is_straight ? DistanceToPlace(origin, apex)
                     : origin.DistanceTo(through) + EdgePointTo(through, apex));
    if (!Front::Improves(distance, best)) continue;
    best = distance;
    crossed.arrival = {list_.pseudo_source[i], h, origin.x, origin.depth};
    crossed.ray = is_straight ? RayThrough(h, origin, apex) : IncomingRay();
  }
  crossed.apex_distance = best;
}

template <typename Front>
void ListCrossing<Front>::CrossLeft(HalfEdge h, const HalfEdgeFrame& frame,
                                    Crossed& crossed) {
  size_t last = list_.size;
  while (last > 0 && crossings_[last - 1] <= list_.begin[last - 1]) --last;
  if (last == 0) return;
  const ExitEdge edge{mesh_.frame(Prev(h)).length,
                      front_.distance(mesh_.From(h)), crossed.apex_distance};
  ChildrenLeft(frame, edge, list_, crossings_.data(), 0, last, children_,
               labels_.data());
  Store(edge, crossed.sides[kLeft]);
}

template <typename Front>
void ListCrossing<Front>::CrossRight(HalfEdge h, const HalfEdgeFrame& frame,
                                     Crossed& crossed) {
  size_t first = 0;
  while (first < list_.size && crossings_[first] >= list_.end[first]) ++first;
  if (first == list_.size) return;
  const ExitEdge edge{mesh_.frame(Next(h)).length, crossed.apex_distance,
                      front_.distance(mesh_.To(h))};
  ChildrenRight(frame, edge, list_, crossings_.data(), first, list_.size,
                children_, labels_.data());
  Store(edge, crossed.sides[kRight]);
}

template <typename Front>
void ListCrossing<Front>::Store(const ExitEdge& edge,
                                Crossed::HandedOn& handed_on) {
  constexpr double kUseless = std::numeric_limits<double>::infinity();
  double label = kUseless, most = 0;
  for (size_t i = 0; i < children_.size; ++i) {
    label = std::min(label, labels_[i]);
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
  if (children_.size > 0) handed_on = {blocks_.Store(children_), label};
}

}  // namespace geodesic

#endif  // GEODESIC_RULES_LIST_CROSSING_H_
