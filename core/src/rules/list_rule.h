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
// Work is done by rounds: of each half-edge, what waits there when the round
// begins crosses its face, and each vertex that has improved by then becomes a
// pseudo-source (list_worker.h). None of them sees what comes of the others,
// which is applied afterwards, in order. So the threads that share the work
// change nothing, whatever their number.

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
#include "rules/list_worker.h"
#include "thread_team.h"
#include "windows/window_blocks.h"

namespace geodesic {

// REQUIRES: the front's origins are points.
template <typename Front>
class ListRule {
 public:
  // The most half-edges and vertices of a round.
  static constexpr size_t kMostTogether = 1024;

  ListRule(Front& front, uint32_t threads)
      : front_(front),
        mesh_(front.mesh()),
        waiting_(front.mesh().half_edge_count(), kNone) {
    for (uint32_t member = 0; member < threads; ++member) {
      workers_.emplace_back(front, pool_);
    }
  }

  // Adds a pseudo-source's window over what it sees of a half-edge.
  void Open(HalfEdge half_edge, uint32_t pseudo_source, const Origin& origin,
            const Interval& interval);

  // Sources were added: nothing here depends on them.
  void Restart() {}

  // Keeps no threads until the next round.
  void Rest() { team_.reset(); }

  // A round: propagates all that waits at some half-edges across their faces
  // and expands vertices (numbers with kVertexEvent). Returns how many windows
  // were propagated; whatever is named twice counts once.
  uint64_t Propagate(std::span<const uint32_t> events);

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
  using Worker = ListWorker<Front>;

  static constexpr uint32_t kNone = 0xffffffffu;
  // Rounds of fewer events are not worth a team's start.
  static constexpr size_t kLeastShared = 32;
  // How many events a thread takes at a time.
  static constexpr size_t kShare = 4;

  struct Queued {
    double label;  // the least the half-edge is queued with
    WaitingLists lists;
  };
  // One of the round.
  struct Event {
    uint32_t id;
    WaitingLists lists;  // of a half-edge
    uint32_t member;     // who does it
    typename Worker::Outcome outcome;
  };

  // Makes events_ of those that have something to do.
  void Take(std::span<const uint32_t> ids);
  void DoAll();
  // Does events_[i] for i in [first, last).
  void Do(size_t first, size_t last, uint32_t member);
  void Prefetch(size_t i) const;
  void Apply(const Event& event);
  // Adds a list to what waits at a half-edge.
  void Enqueue(const typename Worker::HandedOn& list);

  Front& front_;
  const Mesh& mesh_;
  std::vector<uint32_t> waiting_;  // by half-edge, into queues_; or kNone
  std::vector<Queued> queues_;
  std::vector<uint32_t> free_;  // of queues_
  BlockPool pool_;
  std::deque<Worker> workers_;      // by member of the team
  std::optional<ThreadTeam> team_;  // once a round was wide enough

  // Of the round.
  std::vector<Event> events_;
  std::atomic<size_t> next_ = 0;  // of events_, that nobody has begun

  uint64_t pending_ = 0;
  uint64_t peak_ = 0;
  uint64_t created_ = 0;
};

template <typename Front>
void ListRule<Front>::Open(HalfEdge half_edge, uint32_t pseudo_source,
                           const Origin& origin, const Interval& interval) {
  Worker& worker = workers_[0];
  worker.Open(half_edge, pseudo_source, origin, interval);
  for (const auto& list : worker.handed_on()) Enqueue(list);
  worker.Forget();
}

template <typename Front>
uint64_t ListRule<Front>::Propagate(std::span<const uint32_t> ids) {
  Take(ids);
  DoAll();
  uint64_t propagated = 0;
  for (const Event& event : events_) {
    Apply(event);
    propagated += event.outcome.propagated;
  }
  for (Worker& worker : workers_) worker.Forget();
  return propagated;
}

template <typename Front>
void ListRule<Front>::Take(std::span<const uint32_t> ids) {
  constexpr size_t kAhead = 8;
  events_.clear();
  for (size_t i = 0; i < ids.size(); ++i) {
    if (i + kAhead < ids.size() && !(ids[i + kAhead] & kVertexEvent)) {
      __builtin_prefetch(&waiting_[ids[i + kAhead]]);
    }
    const uint32_t id = ids[i];
    if (id & kVertexEvent) {
      if (front_.TakeEvent(id & ~kVertexEvent)) events_.push_back({.id = id});
    } else if (waiting_[id] != kNone) {
      events_.push_back({.id = id, .lists = queues_[waiting_[id]].lists});
      free_.push_back(waiting_[id]);
      waiting_[id] = kNone;
    }
  }
}

template <typename Front>
void ListRule<Front>::DoAll() {
  const size_t count = events_.size();
  if (workers_.size() == 1 || count < kLeastShared) {
    Do(0, count, 0);
    return;
  }
  if (!team_.has_value()) {
    team_.emplace(static_cast<uint32_t>(workers_.size()));
  }
  next_.store(0, std::memory_order_relaxed);
  team_->Run([this, count](uint32_t member) {
    for (;;) {
      const size_t first = next_.fetch_add(kShare, std::memory_order_relaxed);
      if (first >= count) return;
      Do(first, std::min(first + kShare, count), member);
    }
  });
}

template <typename Front>
void ListRule<Front>::Do(size_t first, size_t last, uint32_t member) {
  for (size_t i = first; i < last; ++i) {
    Prefetch(i);
    Event& event = events_[i];
    event.member = member;
    Worker& worker = workers_[member];
    event.outcome = event.id & kVertexEvent
                        ? worker.Expand(event.id & ~kVertexEvent)
                        : worker.Cross(event.id, event.lists);
  }
}

// What the events after events_[i] will need. Each stage needs what the one
// before has fetched.
template <typename Front>
void ListRule<Front>::Prefetch(size_t i) const {
  if (i + 3 < events_.size()) {
    const Event& event = events_[i + 3];
    if (event.id & kVertexEvent) {
      front_.PrefetchFan(event.id & ~kVertexEvent);
    } else {
      front_.PrefetchFace(event.id);
      for (const WindowBlock* list : event.lists) {
        if (list != nullptr) WindowBlocks::Prefetch(list);
      }
    }
  }
  if (i + 1 < events_.size() && !(events_[i + 1].id & kVertexEvent)) {
    const Event& event = events_[i + 1];
    front_.PrefetchCorners(event.id);
    for (const WindowBlock* list : event.lists) {
      if (list != nullptr) WindowBlocks::PrefetchRest(list);
    }
  }
}

template <typename Front>
void ListRule<Front>::Apply(const Event& event) {
  const Worker& worker = workers_[event.member];
  const auto& [waited, propagated, begin, end] = event.outcome;
  pending_ -= waited;
  for (uint32_t i = begin.observed; i < end.observed; ++i) {
    const auto& [h, window, pseudo_source] = worker.observed()[i];
    front_.Observe(h, window, pseudo_source);
  }
  for (uint32_t i = begin.relaxation; i < end.relaxation; ++i) {
    const auto& [vertex, distance, arrival, ray] = worker.relaxations()[i];
    front_.Relax(vertex, distance, arrival, ray);
  }
  for (uint32_t i = begin.handed_on; i < end.handed_on; ++i) {
    Enqueue(worker.handed_on()[i]);
  }
}

template <typename Front>
void ListRule<Front>::Enqueue(const typename Worker::HandedOn& handed_on) {
  const auto& [h, from, list, label] = handed_on;
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
  *place = list;
  created_ += list->count;
  pending_ += list->count;
  peak_ = std::max(peak_, pending_);
  if (label >= queued.label) return;
  queued.label = label;
  front_.queue().Push(h, label);
}

}  // namespace geodesic

#endif  // GEODESIC_RULES_LIST_RULE_H_
