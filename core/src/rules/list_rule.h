// Lists of windows: all that wait to enter a face through one of its
// half-edges are trimmed against each other, cross the face together and are
// then forgotten.
//
// As with the MMP rule, every point of a half-edge belongs to the one window
// that reaches it soonest, but only among those that wait there together.
// Whoever comes later is not compared with those that have gone: a half-edge is
// due when the wavefront reaches it, most of its windows are there by then, and
// those that are late meet the others' children at a farther edge, or paths
// through vertices that are nearer (the filter of Xin and Wang: Improving Chen
// and Han's algorithm on the discrete geodesic problem. ACM TOG 28(4), 2009).
// On real meshes that leaves as many windows as MMP's rule does, to 1%.
//
// Per-half-edge lists that are handed on whole: Qin, Han, Yu, Yu, Zhang: Fast
// and exact discrete geodesic computation based on triangle-oriented wavefront
// propagation. ACM TOG 35(4), 2016; ordered by vertices there, and linked.
//
// Propagate works on scratch and on what it reads of the front; the children go
// to at most two other half-edges. Lists are columns (structures of arrays), so
// crossing a face is a few loops that vectorize (list_kernels.h).

#ifndef GEODESIC_RULES_LIST_RULE_H_
#define GEODESIC_RULES_LIST_RULE_H_

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "rules/envelope.h"
#include "rules/front.h"
#include "rules/list_kernels.h"
#include "windows/window_blocks.h"
#include "windows/window_columns.h"

namespace geodesic {

// REQUIRES: the front's origins are points.
template <typename Front>
class ListRule {
 public:
  // How many half-edges ahead of their use the stages of Prefetch come.
  static constexpr std::array<uint32_t, 3> kPrefetchAhead = {6, 4, 2};

  explicit ListRule(Front& front)
      : front_(front),
        mesh_(front.mesh()),
        waiting_(front.mesh().half_edge_count(), kNone) {}

  // Adds a pseudo-source's window over what it sees of a half-edge.
  void Open(HalfEdge half_edge, uint32_t pseudo_source, const Origin& origin,
            const Interval& interval);

  // Sources were added: nothing here depends on them.
  void Restart() {}

  // Propagates all that waits at half-edge `h` across its face. Returns how
  // many windows: none if another entry of `h` has done so.
  uint32_t Propagate(HalfEdge h);

  // Fetches into cache what propagating `h` will need. Each stage needs what
  // the one before has fetched.
  void Prefetch(HalfEdge h, size_t stage) const;

  uint64_t created() const { return created_; }
  uint64_t pending() const { return pending_; }
  uint64_t windows() const { return pending_; }
  uint64_t peak_windows() const { return peak_; }
  uint64_t bytes() const {
    return waiting_.capacity() * sizeof(uint32_t) +
           queues_.capacity() * sizeof(Queued) +
           free_.capacity() * sizeof(uint32_t) + blocks_.bytes();
  }

 private:
  static constexpr uint32_t kNone = 0xffffffffu;

  // Across which side of the neighbouring face windows come: those that come
  // across its left side arrive nearer to the half-edge's begin.
  enum Side { kLeft, kRight };

  // What waits at a half-edge.
  struct Queued {
    double label;  // the least the half-edge is queued with
    std::array<WindowBlock, 2> blocks;  // by Side
  };

  // Moves what waits at h to list_.
  void Take(HalfEdge h, const HalfEdgeFrame& frame);
  // Drops useless windows of list_ from `first` on.
  void DropStale(size_t first);
  void RelaxApex(HalfEdge h, const HalfEdgeFrame& frame);
  void CrossLeft(HalfEdge h, const HalfEdgeFrame& frame);
  void CrossRight(HalfEdge h, const HalfEdgeFrame& frame);
  // Trims children_ and hands them on.
  void HandOn(HalfEdge side, Exit exit, const ExitEdge& edge, Side from);
  // Adds children_ to what waits at h; no label among them is below `label`.
  void Enqueue(HalfEdge h, double length, Side from, double label);

  Front& front_;
  const Mesh& mesh_;
  std::vector<uint32_t> waiting_;  // by half-edge, into queues_; or kNone
  std::vector<Queued> queues_;
  std::vector<uint32_t> free_;  // of queues_
  WindowBlocks blocks_;

  // Scratch of Propagate, kept for its memory.
  WindowColumns list_, children_, merged_;
  std::vector<double> crossings_, misses_, labels_;
  Envelope envelope_;

  uint64_t pending_ = 0;
  uint64_t peak_ = 0;
  uint64_t created_ = 0;
};

template <typename Front>
void ListRule<Front>::Open(HalfEdge half_edge, uint32_t pseudo_source,
                           const Origin& origin, const Interval& interval) {
  const double length = mesh_.frame(half_edge).length;
  if (interval.width() <= kLeastWidth * length &&
      IsSliver(interval, origin, length)) {
    return;
  }
  const Window window = Window::Over(interval, origin);
  if (front_.EndsAreNearer(window, length, mesh_.From(half_edge),
                           mesh_.To(half_edge))) {
    return;
  }
  children_.Reserve(1);
  children_.Set(0, window, pseudo_source);
  children_.size = 1;
  Enqueue(half_edge, length, kLeft, window.Label());
}

template <typename Front>
uint32_t ListRule<Front>::Propagate(HalfEdge h) {
  if (waiting_[h] == kNone) return 0;
  const HalfEdgeFrame& frame = mesh_.frame(h);
  Take(h, frame);
  if (list_.size == 0) return 0;
  if (front_.Watches(h)) {
    for (size_t i = 0; i < list_.size; ++i) {
      front_.Observe(
          h, Window::Over({list_.begin[i], list_.end[i]}, list_.OriginAt(i)),
          list_.pseudo_source[i]);
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
  RelaxApex(h, frame);
  if (frame.left_exit != kNoHalfEdge) CrossLeft(h, frame);
  if (frame.right_exit != kNoHalfEdge) CrossRight(h, frame);
  return static_cast<uint32_t>(list_.size);
}

template <typename Front>
void ListRule<Front>::Take(HalfEdge h, const HalfEdgeFrame& frame) {
  const auto [label, blocks] = queues_[waiting_[h]];
  free_.push_back(waiting_[h]);
  waiting_[h] = kNone;
  list_.size = 0;
  list_.Reserve(blocks[kLeft].count + blocks[kRight].count);
  if (blocks[kLeft].count > 0) blocks_.Take(blocks[kLeft], list_);
  DropStale(0);
  if (blocks[kRight].count > 0) {
    const size_t middle = list_.size;
    blocks_.Take(blocks[kRight], list_);
    DropStale(middle);
    envelope_.Merge(frame.length, front_.MayChangeOverTwice(), middle, list_);
  }
  pending_ -= blocks[kLeft].count + blocks[kRight].count;
}

template <typename Front>
void ListRule<Front>::DropStale(size_t first) {
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
void ListRule<Front>::RelaxApex(HalfEdge h, const HalfEdgeFrame& frame) {
  const PlanePoint apex = ApexOf(frame);
  const uint32_t vertex = mesh_.Apex(h);
  for (size_t i = 0; i < list_.size; ++i) {
    if (!(misses_[i] <= 0)) continue;
    const Origin origin = list_.OriginAt(i);
    const Arrival arrival{list_.pseudo_source[i], h, origin.x, origin.depth};
    const double through =
        std::clamp(crossings_[i], list_.begin[i], list_.end[i]);
    if (through == crossings_[i]) {
      front_.Relax(vertex, origin.sigma + DistanceToPlace(origin, apex),
                   arrival, RayThrough(h, origin, apex));
    } else {
      front_.Relax(vertex,
                   origin.sigma + origin.DistanceTo(through) +
                       EdgePointTo(through, apex),
                   arrival);
    }
  }
}

template <typename Front>
void ListRule<Front>::CrossLeft(HalfEdge h, const HalfEdgeFrame& frame) {
  size_t last = list_.size;
  while (last > 0 && crossings_[last - 1] <= list_.begin[last - 1]) --last;
  if (last == 0) return;
  const ExitEdge edge{mesh_.frame(Prev(h)).length,
                      front_.distance(mesh_.From(h)),
                      front_.distance(mesh_.Apex(h))};
  ChildrenLeft(frame, edge, list_, crossings_.data(), 0, last, children_,
               labels_.data());
  HandOn(Prev(h), frame.left_exit, edge, kLeft);
}

template <typename Front>
void ListRule<Front>::CrossRight(HalfEdge h, const HalfEdgeFrame& frame) {
  size_t first = 0;
  while (first < list_.size && crossings_[first] >= list_.end[first]) ++first;
  if (first == list_.size) return;
  const ExitEdge edge{mesh_.frame(Next(h)).length,
                      front_.distance(mesh_.Apex(h)),
                      front_.distance(mesh_.To(h))};
  ChildrenRight(frame, edge, list_, crossings_.data(), first, list_.size,
                children_, labels_.data());
  HandOn(Next(h), frame.right_exit, edge, kRight);
}

template <typename Front>
void ListRule<Front>::HandOn(HalfEdge side, Exit exit, const ExitEdge& edge,
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
  if (exit < kIrregularExit) {
    Enqueue(exit, edge.length, from, label);
    return;
  }
  mesh_.ForEachBeyond(side, [&](HalfEdge half_edge, bool is_mirrored) {
    if (is_mirrored) children_.Mirror(edge.length);
    Enqueue(half_edge, edge.length, is_mirrored ? kRight : from, label);
    if (is_mirrored) children_.Mirror(edge.length);
  });
}

template <typename Front>
void ListRule<Front>::Enqueue(HalfEdge h, double length, Side from,
                              double label) {
  if (children_.size == 0) return;
  if (waiting_[h] == kNone) {
    if (free_.empty()) {
      waiting_[h] = static_cast<uint32_t>(queues_.size());
      queues_.emplace_back();
    } else {
      waiting_[h] = free_.back();
      free_.pop_back();
    }
    queues_[waiting_[h]] = {std::numeric_limits<double>::infinity(), {}};
  }
  Queued& queued = queues_[waiting_[h]];
  created_ += children_.size;
  WindowBlock& block = queued.blocks[from];
  if (block.count == 0) {
    block = blocks_.Store(children_);
    pending_ += block.count;
  } else {
    pending_ -= block.count;
    merged_.size = 0;
    merged_.Reserve(block.count + children_.size);
    blocks_.Take(block, merged_);
    const size_t middle = merged_.size;
    for (size_t i = 0; i < children_.size; ++i) {
      merged_.Set(middle + i, children_.At(i), children_.pseudo_source[i]);
    }
    merged_.size += children_.size;
    envelope_.Merge(length, front_.MayChangeOverTwice(), middle, merged_);
    block = blocks_.Store(merged_);
    pending_ += block.count;
  }
  peak_ = std::max(peak_, pending_);
  if (label >= queued.label) return;
  queued.label = label;
  front_.queue().Push(h, label);
}

template <typename Front>
void ListRule<Front>::Prefetch(HalfEdge h, size_t stage) const {
  if (stage == 0) {
    front_.PrefetchFace(h);
    __builtin_prefetch(&waiting_[h]);
    return;
  }
  const HalfEdgeFrame& frame = mesh_.frame(h);
  if (stage == 1) {
    front_.PrefetchCorners(h);
    if (waiting_[h] != kNone) __builtin_prefetch(&queues_[waiting_[h]]);
    if (frame.left_exit < kIrregularExit) {
      __builtin_prefetch(&waiting_[frame.left_exit]);
    }
    if (frame.right_exit < kIrregularExit) {
      __builtin_prefetch(&waiting_[frame.right_exit]);
    }
    return;
  }
  if (waiting_[h] == kNone) return;
  for (const WindowBlock& block : queues_[waiting_[h]].blocks) {
    if (block.count > 0) blocks_.Prefetch(block);
  }
}

}  // namespace geodesic

#endif  // GEODESIC_RULES_LIST_RULE_H_
