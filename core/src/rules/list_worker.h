// What one thread does of a round of the list rule: lists of windows cross the
// faces that they wait to enter, and vertices that have improved become
// pseudo-sources. Reads the front and changes nothing there; what comes of it
// is kept until it is applied (list_rule.h).

#ifndef GEODESIC_RULES_LIST_WORKER_H_
#define GEODESIC_RULES_LIST_WORKER_H_

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
#include "thread_team.h"
#include "tolerances.h"
#include "windows/window_blocks.h"
#include "windows/window_columns.h"

namespace geodesic {

// Across which side of the neighbouring face windows come: those that come
// across its left side arrive nearer to the half-edge's begin.
enum Side { kLeft, kRight };

// What waits at a half-edge: chains of lists, each list trimmed. By Side.
using WaitingLists = std::array<WindowBlock*, 2>;

// On cache lines of its own, for its scratch is written all the time.
// REQUIRES: the front's origins are points.
template <typename Front>
class alignas(kCacheLine) ListWorker {
 public:
  // A better path to a vertex, as Front::Relax takes it.
  struct Relaxation {
    uint32_t vertex;
    double distance;
    Arrival arrival;
    IncomingRay ray;
  };
  // A list that goes on through a half-edge.
  struct HandedOn {
    HalfEdge to;
    Side from;
    WindowBlock* list;
    uint32_t count;  // its windows
    double label;    // no window's label is below
  };
  // A window that the front watches.
  struct Observed {
    HalfEdge half_edge;
    Window window;
    uint32_t pseudo_source;
  };
  // A place in what is kept.
  struct Place {
    uint32_t relaxation = 0, handed_on = 0, observed = 0;
    bool operator==(const Place&) const = default;
  };
  // What comes of one half-edge or vertex.
  struct Outcome {
    uint32_t waited = 0;      // windows
    uint32_t propagated = 0;  // those among them that were not useless
    Place begin, end;
  };

  ListWorker(const Front& front, BlockPool& pool)
      : front_(front), mesh_(front.mesh()), blocks_(pool) {}

  // Takes and frees the lists that wait at h.
  Outcome Cross(HalfEdge h, const WaitingLists& lists);
  Outcome Expand(uint32_t vertex);

  // What came of all that was done since the last Forget.
  std::span<const Relaxation> relaxations() const { return relaxations_; }
  std::span<const HandedOn> handed_on() const { return handed_on_; }
  std::span<const Observed> observed() const { return observed_; }
  void Forget() {
    relaxations_.clear();
    handed_on_.clear();
    observed_.clear();
  }

  // As Front::Expand calls them.
  void Relax(uint32_t vertex, double distance, const Arrival& arrival,
             const IncomingRay& ray = {}) {
    if (!Front::Improves(distance, front_.distance(vertex))) return;
    relaxations_.push_back({vertex, distance, arrival, ray});
  }
  void Open(HalfEdge half_edge, uint32_t pseudo_source, const Origin& origin,
            const Interval& interval);
  void Observe(HalfEdge h, const Window& window, uint32_t pseudo_source) {
    if (front_.Watches(h)) observed_.push_back({h, window, pseudo_source});
  }

 private:
  Place Here() const {
    return {static_cast<uint32_t>(relaxations_.size()),
            static_cast<uint32_t>(handed_on_.size()),
            static_cast<uint32_t>(observed_.size())};
  }
  void CrossFace(HalfEdge h, const HalfEdgeFrame& frame);
  // Moves what waits to list_. Returns how many windows that were.
  uint32_t Take(const WaitingLists& lists, double length);
  // Drops useless windows of list_ from `first` on.
  void DropStale(size_t first);
  // Returns the distance of the apex that is known then.
  double ReachApex(HalfEdge h, const HalfEdgeFrame& frame);
  void CrossLeft(HalfEdge h, const HalfEdgeFrame& frame, double apex_distance);
  void CrossRight(HalfEdge h, const HalfEdgeFrame& frame, double apex_distance);
  // Trims children_, which leave the face across `side`, and hands them on.
  void HandOn(HalfEdge side, Exit exit, const ExitEdge& edge, Side from);

  const Front& front_;
  const Mesh& mesh_;
  WindowBlocks blocks_;
  std::vector<Relaxation> relaxations_;
  std::vector<HandedOn> handed_on_;
  std::vector<Observed> observed_;

  // Scratch, kept for its memory.
  WindowColumns list_, children_;
  std::vector<double> crossings_, misses_, labels_;
  std::vector<uint32_t> hits_;
  Envelope envelope_;
};

template <typename Front>
typename ListWorker<Front>::Outcome ListWorker<Front>::Cross(
    HalfEdge h, const WaitingLists& lists) {
  const HalfEdgeFrame& frame = mesh_.frame(h);
  Outcome outcome{.begin = Here()};
  outcome.waited = Take(lists, frame.length);
  outcome.propagated = static_cast<uint32_t>(list_.size);
  if (list_.size > 0) CrossFace(h, frame);
  outcome.end = Here();
  return outcome;
}

template <typename Front>
typename ListWorker<Front>::Outcome ListWorker<Front>::Expand(uint32_t vertex) {
  Outcome outcome{.begin = Here()};
  front_.Expand(vertex, *this);
  outcome.end = Here();
  return outcome;
}

template <typename Front>
void ListWorker<Front>::Open(HalfEdge half_edge, uint32_t pseudo_source,
                             const Origin& origin, const Interval& interval) {
  const double length = mesh_.frame(half_edge).length;
  if (IsLost(interval, origin, length)) return;
  const Window window = Window::Over(interval, origin);
  if (front_.EndsAreNearer(window, length, mesh_.From(half_edge),
                           mesh_.To(half_edge))) {
    return;
  }
  children_.Reserve(1);
  children_.Set(0, window, pseudo_source);
  children_.size = 1;
  handed_on_.push_back(
      {half_edge, kLeft, blocks_.Store(children_), 1, window.Label()});
}

template <typename Front>
uint32_t ListWorker<Front>::Take(const WaitingLists& lists, double length) {
  uint32_t waited = 0;
  list_.size = 0;
  for (WindowBlock* list : lists) {
    while (list != nullptr) {
      waited += list->count;
      const size_t middle = list_.size;
      list = blocks_.Take(list, list_);
      DropStale(middle);
      envelope_.Merge(length, front_.MayChangeOverTwice(), middle, list_);
    }
  }
  return waited;
}

template <typename Front>
void ListWorker<Front>::DropStale(size_t first) {
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
void ListWorker<Front>::CrossFace(HalfEdge h, const HalfEdgeFrame& frame) {
  if (front_.Watches(h)) {
    for (size_t i = 0; i < list_.size; ++i) {
      Observe(h,
              Window::Over({list_.begin[i], list_.end[i]}, list_.OriginAt(i)),
              list_.pseudo_source[i]);
    }
  }
  const size_t room = list_.size + WindowColumns::kPadding;
  if (crossings_.size() < room) {
    crossings_.resize(2 * room);
    misses_.resize(2 * room);
    labels_.resize(2 * room);
    hits_.resize(2 * room);
  }
  children_.Reserve(list_.size);
  CrossingsToApex(frame, list_, crossings_.data(), misses_.data());
  const double apex_distance = ReachApex(h, frame);
  if (frame.left_exit != kNoHalfEdge) CrossLeft(h, frame, apex_distance);
  if (frame.right_exit != kNoHalfEdge) CrossRight(h, frame, apex_distance);
}

template <typename Front>
double ListWorker<Front>::ReachApex(HalfEdge h, const HalfEdgeFrame& frame) {
  const PlanePoint apex = ApexOf(frame);
  const uint32_t vertex = mesh_.Apex(h);
  const double known = front_.distance(vertex);
  Relaxation best{
      .vertex = vertex, .distance = known, .arrival = {}, .ray = {}};
  // Gathered without a branch: which they are cannot be foreseen.
  size_t hits = 0;
  for (size_t i = 0; i < list_.size; ++i) {
    hits_[hits] = static_cast<uint32_t>(i);
    hits += misses_[i] <= 0;
  }
  for (const uint32_t i : std::span(hits_).first(hits)) {
    const Origin origin = list_.OriginAt(i);
    const double through =
        std::clamp(crossings_[i], list_.begin[i], list_.end[i]);
    const bool is_straight = through == crossings_[i];
    const double distance =
        origin.sigma +
        (is_straight ? DistanceToPlace(origin, apex)
                     : origin.DistanceTo(through) + EdgePointTo(through, apex));
    if (!Front::Improves(distance, best.distance)) continue;
    best.distance = distance;
    best.arrival = {list_.pseudo_source[i], h, origin.x, origin.depth};
    best.ray = is_straight ? RayThrough(h, origin, apex) : IncomingRay();
  }
  if (best.distance != known) relaxations_.push_back(best);
  return best.distance;
}

template <typename Front>
void ListWorker<Front>::CrossLeft(HalfEdge h, const HalfEdgeFrame& frame,
                                  double apex_distance) {
  size_t last = list_.size;
  while (last > 0 && crossings_[last - 1] <= list_.begin[last - 1]) --last;
  if (last == 0) return;
  const ExitEdge edge{mesh_.frame(Prev(h)).length,
                      front_.distance(mesh_.From(h)), apex_distance};
  ChildrenLeft(frame, edge, list_, crossings_.data(), 0, last, children_,
               labels_.data());
  HandOn(Prev(h), frame.left_exit, edge, kLeft);
}

template <typename Front>
void ListWorker<Front>::CrossRight(HalfEdge h, const HalfEdgeFrame& frame,
                                   double apex_distance) {
  size_t first = 0;
  while (first < list_.size && crossings_[first] >= list_.end[first]) ++first;
  if (first == list_.size) return;
  const ExitEdge edge{mesh_.frame(Next(h)).length, apex_distance,
                      front_.distance(mesh_.To(h))};
  ChildrenRight(frame, edge, list_, crossings_.data(), first, list_.size,
                children_, labels_.data());
  HandOn(Next(h), frame.right_exit, edge, kRight);
}

template <typename Front>
void ListWorker<Front>::HandOn(HalfEdge side, Exit exit, const ExitEdge& edge,
                               Side from) {
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
  if (children_.size == 0) return;
  const auto count = static_cast<uint32_t>(children_.size);
  if (exit < kIrregularExit) {
    handed_on_.push_back({exit, from, blocks_.Store(children_), count, label});
    return;
  }
  mesh_.ForEachBeyond(side, [&](HalfEdge to, bool is_mirrored) {
    if (is_mirrored) children_.Mirror(edge.length);
    handed_on_.push_back({to, is_mirrored ? kRight : from,
                          blocks_.Store(children_), count, label});
    if (is_mirrored) children_.Mirror(edge.length);
  });
}

}  // namespace geodesic

#endif  // GEODESIC_RULES_LIST_WORKER_H_
