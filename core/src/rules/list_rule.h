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
// Half-edges are propagated by rounds: what waits at each of them when the
// round begins crosses its face (list_crossing.h), none of them sees what
// becomes of the others, and then the results are applied in order. So the
// threads that share the crossings change nothing, whatever their number.

#ifndef GEODESIC_RULES_LIST_RULE_H_
#define GEODESIC_RULES_LIST_RULE_H_

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "rules/front.h"
#include "rules/list_crossing.h"
#include "thread_team.h"
#include "windows/window_blocks.h"
#include "windows/window_columns.h"

namespace geodesic {

// REQUIRES: the front's origins are points.
template <typename Front>
class ListRule {
 public:
  // The most half-edges of a round.
  static constexpr size_t kMostTogether = 1024;

  ListRule(Front& front, uint32_t threads)
      : front_(front),
        mesh_(front.mesh()),
        threads_(threads),
        waiting_(front.mesh().half_edge_count(), kNone) {
    for (uint32_t member = 0; member < threads; ++member) {
      crossings_.emplace_back(front, pool_);
    }
  }

  // Adds a pseudo-source's window over what it sees of a half-edge.
  void Open(HalfEdge half_edge, uint32_t pseudo_source, const Origin& origin,
            const Interval& interval);

  // Sources were added: nothing here depends on them.
  void Restart() {}

  // Propagates all that waits at some half-edges across their faces. Returns
  // how many windows; a half-edge that is named twice counts once.
  uint64_t Propagate(std::span<const HalfEdge> half_edges);

  uint64_t created() const { return created_; }
  uint64_t pending() const { return pending_; }
  uint64_t windows() const { return pending_; }
  uint64_t peak_windows() const { return peak_; }
  uint64_t bytes() const {
    return waiting_.capacity() * sizeof(uint32_t) +
           queues_.capacity() * sizeof(Queued) +
           free_.capacity() * sizeof(uint32_t) + pool_.bytes();
  }

 private:
  static constexpr uint32_t kNone = 0xffffffffu;
  // Rounds of fewer half-edges are not worth a team's start.
  static constexpr size_t kLeastShared = 32;
  // How many half-edges a thread takes at a time.
  static constexpr size_t kShare = 4;

  struct Queued {
    double label;  // the least the half-edge is queued with
    WaitingLists lists;
  };
  // A half-edge of the round.
  struct Taken {
    HalfEdge half_edge;
    WaitingLists lists;
    uint32_t member = 0;  // who crosses it
  };

  // Moves what waits at the half-edges to taken_.
  void Take(std::span<const HalfEdge> half_edges);
  // Crosses taken_[i] for i in [first, last).
  void Cross(size_t first, size_t last, uint32_t member);
  void CrossAll();
  void Apply(const Taken& taken, const Crossed& crossed);
  void HandOn(HalfEdge side, Exit exit, Side from,
              const Crossed::HandedOn& handed_on);
  // Adds a list to what waits at h.
  void Enqueue(HalfEdge h, Side from, const Crossed::HandedOn& handed_on);

  Front& front_;
  const Mesh& mesh_;
  const uint32_t threads_;
  std::vector<uint32_t> waiting_;  // by half-edge, into queues_; or kNone
  std::vector<Queued> queues_;
  std::vector<uint32_t> free_;  // of queues_
  BlockPool pool_;
  std::deque<ListCrossing<Front>> crossings_;  // by member of the team
  std::optional<ThreadTeam> team_;             // once a round was wide enough
  WindowColumns scratch_;

  // Of the round.
  std::vector<Taken> taken_;
  std::vector<Crossed> crossed_;  // by number in taken_
  std::atomic<size_t> next_ = 0;  // of taken_, that nobody has begun

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
  scratch_.Reserve(1);
  scratch_.Set(0, window, pseudo_source);
  scratch_.size = 1;
  Enqueue(half_edge, kLeft,
          {crossings_[0].blocks().Store(scratch_), window.Label()});
}

template <typename Front>
uint64_t ListRule<Front>::Propagate(std::span<const HalfEdge> half_edges) {
  Take(half_edges);
  CrossAll();
  uint64_t propagated = 0;
  for (size_t i = 0; i < taken_.size(); ++i) {
    if (i + 2 < taken_.size()) {
      const HalfEdgeFrame& frame = mesh_.frame(taken_[i + 2].half_edge);
      for (const Exit exit : {frame.left_exit, frame.right_exit}) {
        if (exit < kIrregularExit) __builtin_prefetch(&waiting_[exit]);
      }
    }
    Apply(taken_[i], crossed_[i]);
    propagated += crossed_[i].propagated;
  }
  for (ListCrossing<Front>& crossing : crossings_) crossing.ForgetObserved();
  return propagated;
}

template <typename Front>
void ListRule<Front>::Take(std::span<const HalfEdge> half_edges) {
  constexpr size_t kAhead = 8;
  taken_.clear();
  for (size_t i = 0; i < half_edges.size(); ++i) {
    if (i + kAhead < half_edges.size()) {
      __builtin_prefetch(&waiting_[half_edges[i + kAhead]]);
    }
    const HalfEdge h = half_edges[i];
    if (waiting_[h] == kNone) continue;
    taken_.push_back({h, queues_[waiting_[h]].lists});
    free_.push_back(waiting_[h]);
    waiting_[h] = kNone;
  }
  if (crossed_.size() < taken_.size()) crossed_.resize(taken_.size());
}

template <typename Front>
void ListRule<Front>::CrossAll() {
  const size_t count = taken_.size();
  if (threads_ == 1 || count < kLeastShared) {
    Cross(0, count, 0);
    return;
  }
  if (!team_.has_value()) team_.emplace(threads_);
  next_.store(0, std::memory_order_relaxed);
  team_->Run([this, count](uint32_t member) {
    for (;;) {
      const size_t first = next_.fetch_add(kShare, std::memory_order_relaxed);
      if (first >= count) return;
      Cross(first, std::min(first + kShare, count), member);
    }
  });
}

template <typename Front>
void ListRule<Front>::Cross(size_t first, size_t last, uint32_t member) {
  for (size_t i = first; i < last; ++i) {
    if (i + 3 < taken_.size()) {
      front_.PrefetchFace(taken_[i + 3].half_edge);
      for (const WindowBlock* list : taken_[i + 3].lists) {
        if (list != nullptr) WindowBlocks::Prefetch(list);
      }
    }
    if (i + 1 < taken_.size()) {
      front_.PrefetchCorners(taken_[i + 1].half_edge);
      for (const WindowBlock* list : taken_[i + 1].lists) {
        if (list != nullptr) WindowBlocks::PrefetchRest(list);
      }
    }
    taken_[i].member = member;
    crossings_[member].Cross(taken_[i].half_edge, taken_[i].lists, crossed_[i]);
  }
}

template <typename Front>
void ListRule<Front>::Apply(const Taken& taken, const Crossed& crossed) {
  const HalfEdge h = taken.half_edge;
  pending_ -= crossed.waited;
  for (const auto& [window, pseudo_source] :
       crossings_[taken.member].Observed(crossed)) {
    front_.Observe(h, window, pseudo_source);
  }
  front_.Relax(mesh_.Apex(h), crossed.apex_distance, crossed.arrival,
               crossed.ray);
  const HalfEdgeFrame& frame = mesh_.frame(h);
  HandOn(Prev(h), frame.left_exit, kLeft, crossed.sides[kLeft]);
  HandOn(Next(h), frame.right_exit, kRight, crossed.sides[kRight]);
}

template <typename Front>
void ListRule<Front>::HandOn(HalfEdge side, Exit exit, Side from,
                             const Crossed::HandedOn& handed_on) {
  if (handed_on.list == nullptr) return;
  if (exit < kIrregularExit) {
    Enqueue(exit, from, handed_on);
    return;
  }
  WindowBlocks& blocks = crossings_[0].blocks();
  scratch_.size = 0;
  blocks.Take(handed_on.list, scratch_);
  const double length = mesh_.frame(side).length;
  mesh_.ForEachBeyond(side, [&](HalfEdge half_edge, bool is_mirrored) {
    if (is_mirrored) scratch_.Mirror(length);
    Enqueue(half_edge, is_mirrored ? kRight : from,
            {blocks.Store(scratch_), handed_on.label});
    if (is_mirrored) scratch_.Mirror(length);
  });
}

template <typename Front>
void ListRule<Front>::Enqueue(HalfEdge h, Side from,
                              const Crossed::HandedOn& handed_on) {
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
  WindowBlock** place = &queued.lists[from];
  while (*place != nullptr) place = &(*place)->next;
  *place = handed_on.list;
  created_ += handed_on.list->count;
  pending_ += handed_on.list->count;
  peak_ = std::max(peak_, pending_);
  if (handed_on.label >= queued.label) return;
  queued.label = handed_on.label;
  front_.queue().Push(h, handed_on.label);
}

}  // namespace geodesic

#endif  // GEODESIC_RULES_LIST_RULE_H_
