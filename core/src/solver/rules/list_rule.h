// Lists of windows: all that wait to enter a face through one of its
// half-edges are trimmed against each other, cross the face together and are
// then forgotten.
//
// As with the MMP rule, every point of a half-edge belongs to the one window
// that reaches it soonest, but only among those that wait there together. A
// window that comes later is not compared with those that have gone. A
// half-edge is due when the wavefront reaches it, and most of its windows are
// there by then. Those that are late meet the others' children at a farther
// edge, or the filter of Xin and Wang drops them (Improving Chen and Han's
// algorithm on the discrete geodesic problem. ACM TOG 28(4), 2009). On real
// meshes this makes 1% more windows than MMP's rule does.
//
// Per-half-edge lists that are handed on whole: Qin, Han, Yu, Yu, Zhang: Fast
// and exact discrete geodesic computation based on triangle-oriented wavefront
// propagation. ACM TOG 35(4), 2016; ordered by vertices there, and linked.
//
//   Qin et al.      here
//   window list     WindowBlock at rest, WindowColumns at work
//   of an edge      WaitingLists: two chains, by the side they come across
//   in the queue    Queued: a half-edge, with the least label it waits with
//
// Work is done in rounds. What waits at a half-edge when a round begins crosses
// its face, and each vertex that has improved by then becomes a pseudo-source
// (list_worker.h). The results are applied after the round, in one fixed
// order, so they do not depend on the number of threads. A list is given to the
// thread that made it, in whose cache it lies. All vertices of a round come
// before all half-edges: where the two alternate the processor mispredicts the
// branch between them, which takes as long as a window.

#ifndef GEODESIC_SOLVER_RULES_LIST_RULE_H_
#define GEODESIC_SOLVER_RULES_LIST_RULE_H_

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "mesh/prefetch.h"
#include "solver/rules/crossing_counter.h"
#include "solver/rules/front.h"
#include "solver/rules/list_worker.h"
#include "solver/rules/passed_windows.h"
#include "solver/rules/wide_edges.h"
#include "solver/rules/winding.h"
#include "solver/thread_team.h"
#include "solver/windows/window_blocks.h"

namespace geodesic {

// REQUIRES: the front's origins are points, and its accuracy is Exact.
template <typename Front>
class ListRule {
 public:
  // The most half-edges and vertices that are propagated together: fewer where
  // so many windows wait at each half-edge that it would take long.
  size_t most_together() const {
    if (pending_ <= kMostWindowsTogether) return most_in_round_;
    const size_t half_edges = queues_.size() - free_.size();
    return std::clamp<size_t>(kMostWindowsTogether * half_edges / pending_, 1,
                              most_in_round_);
  }

  ListRule(Front& front, uint32_t threads)
      : front_(front),
        mesh_(front.mesh()),
        most_in_round_(MostInRound(front.mesh())),
        waiting_(front.mesh().half_edge_count(), kNothing),
        passed_(front.mesh()) {
    for (uint32_t member = 0; member < threads; ++member) {
      workers_.emplace_back(front, pool_);
      shares_.emplace_back();
    }
  }

  // Adds a pseudo-source's window over what it sees of a half-edge.
  void Open(HalfEdge half_edge, uint32_t pseudo_source, const Origin& origin,
            const Interval& interval) {
    Worker& worker = workers_[0];
    worker.Open(half_edge, pseudo_source, origin, interval);
    for (const auto& list : worker.handed_on()) Enqueue(list, 0);
    worker.Clear();
  }

  // The same beyond `side`, an edge of very many faces: by and by (Spread).
  static constexpr bool kTakesWideEdges = !Front::Goal::kDirects;
  void OpenBeyond(HalfEdge side, uint32_t pseudo_source, const Origin& origin,
                  const Interval& interval) {
    Worker& worker = workers_[0];
    worker.OpenBeyond(side, pseudo_source, origin, interval);
    for (const auto& list : worker.handed_on()) Enqueue(list, 0);
    worker.Clear();
  }
  // Whether lists are to go on across edges of very many faces, before anything
  // else is done.
  bool HasToSpread() const { return !wide_.IsEmpty(); }
  // Lets the first of them go on into some of the faces.
  void Spread() {
    Worker& worker = workers_[0];
    const HandedOn* copied = nullptr;
    wide_.Spread(
        mesh_, kSpreadAtATime,
        [&](HalfEdge side, HalfEdge to, bool is_mirrored, const HandedOn& all) {
          ++faces_;
          if (!front_.MayEnter(side, to)) return;
          if (copied == nullptr) worker.BeginCopies(side, all.list);
          copied = &all;
          Enqueue({to, is_mirrored ? kRight : all.from,
                   worker.CopyFor(is_mirrored), all.count, all.label},
                  0);
        },
        [this](const HandedOn& all) { Drop(all.list); });
  }

  // Sources were added: nothing here depends on them.
  void Restart() {}

  // Forgets all windows. O(half-edges that they came to).
  // REQUIRES: the front has a goal.
  void Clear() {
    for (const Queued& queued : queues_) {
      if (!Waits(queued.half_edge)) continue;
      workers_[0].Drop(queues_[waiting_[queued.half_edge]].lists);
      waiting_[queued.half_edge] = kNothing;
    }
    passed_.Clear(crossed_, [this](WindowBlock* list) { Drop(list); });
    for (const HalfEdge h : crossed_) waiting_[h] = kNothing;
    crossed_.clear();
    queues_.clear();
    free_.clear();
    has_dropped_ = false;
    pending_ = peak_ = created_ = 0;
    winding_.Clear();
  }

  // Ends the threads; the next round starts others.
  void ReleaseThreads() { team_.reset(); }

  // A round or several: propagates all that waits at some half-edges across
  // their faces and expands vertices (numbers with kVertexEvent). Returns how
  // many windows were propagated; whatever is named twice counts once.
  uint64_t Propagate(std::span<const uint32_t> ids) {
    uint64_t propagated = 0;
    while (!ids.empty()) {
      const size_t together = std::min(ids.size(), most_in_round_);
      propagated += Round(ids.first(together));
      ids = ids.subspan(together);
    }
    return propagated;
  }

  // Whether windows were dropped since there were too many (MostCrossings). In
  // the order of labels these are of no use, in another they may be.
  bool has_dropped() const { return has_dropped_; }

  uint64_t created() const { return created_; }
  // Windows made, and faces looked at beyond irregular edges.
  uint64_t steps() const { return created_ + faces_; }
  uint64_t pending() const { return pending_; }
  uint64_t peak_windows() const { return peak_; }
  uint64_t bytes() const {
    uint64_t bytes =
        waiting_.capacity() * sizeof(uint32_t) +
        queues_.capacity() * sizeof(Queued) +
        (free_.capacity() + crossed_.capacity()) * sizeof(uint32_t) +
        passed_.bytes() + pool_.bytes();
    for (const Worker& worker : workers_) bytes += worker.bytes();
    return bytes;
  }

 private:
  using Worker = ListWorker<Front>;
  using HandedOn = typename Worker::HandedOn;
  using Passed = PassedWindows<WindowBlock*>;

  // Nothing waits; added to it, how often lists have crossed from there.
  static constexpr uint32_t kNothing =
      std::numeric_limits<uint32_t>::max() - kMostCrossings;
  static constexpr size_t kMostTogether = 1024;
  // Tens of milliseconds of one thread.
  static constexpr uint64_t kMostWindowsTogether = uint64_t{1} << 16;
  // Rounds of fewer events are not worth a team's start.
  static constexpr size_t kLeastShared = 32;
  // How many events a thread takes at a time.
  static constexpr size_t kShare = 8;
  // Lists that the half-edges of a round hand on, if there are several.
  static constexpr size_t kMostHandedOn = size_t{1} << 16;
  // Each of many faces at an edge hands the same lists on to all others. So
  // many that wait there are trimmed at once. Where there are very many faces
  // it is up to twice as many, so that not all of them have theirs trimmed in a
  // row.
  static constexpr uint32_t kMostWaiting = 16;
  // Faces beyond an edge of very many that are entered at once.
  static constexpr size_t kSpreadAtATime = 256;

  struct Queued {
    double label;  // the least the half-edge is queued with
    WaitingLists lists = {};
    WaitingLists last = {};  // of the chains
    uint32_t member = 0;     // who has handed on the latest
    HalfEdge half_edge = kNoHalfEdge;
    uint32_t crossings = 0;  // so far, up to MostCrossings
    uint32_t count = 0;      // lists that wait
  };
  // One of the round.
  struct Event {
    uint32_t id;
    uint32_t member;                 // who has done it
    WaitingLists lists;              // of a half-edge
    WindowBlock** passed = nullptr;  // what is kept there (PassedWindows::At)
    Winding winding = Winding::kUnknown;
    typename Worker::Outcome outcome;
  };
  // What came of events in a row that one member has done in a row.
  struct Run {
    uint32_t member;
    typename Worker::Place begin, end;
  };
  // What a member is to do. When nothing is left of it, that is what others
  // have not begun.
  struct alignas(kCacheLine) Share {
    std::vector<Event> events;
    std::atomic<size_t> next = 0;  // that nobody has begun
    size_t applied = 0;
  };

  // A half-edge hands lists on to all other faces at two edges, a vertex at all
  // edges opposite to it: where many of these have three faces or more, to very
  // many.
  static size_t MostInRound(const Mesh& mesh) {
    size_t most = 2 * mesh.MostFacesAtEdge();
    if (mesh.HasNonManifoldEdges()) {
      for (uint32_t v = 0; v < mesh.vertex_count(); ++v) {
        size_t faces = 0;
        for (const HalfEdge h : mesh.Outgoing(v)) {
          if (mesh.IsNonManifoldEdge(Next(h))) {
            faces += mesh.HalfEdgesAt(Next(h)).size();
          }
        }
        most = std::max(most, faces);
      }
    }
    return std::clamp<size_t>(kMostHandedOn / most, 1, kMostTogether);
  }

  uint32_t MostWaiting(HalfEdge h) const {
    return kMostWaiting + (IsWideEdge(mesh_, h) ? h / 3 % kMostWaiting : 0);
  }

  uint64_t Round(std::span<const uint32_t> ids) {
    Take(ids);
    DoAll();
    const uint64_t propagated = FindRuns();
    for (const Run& run : runs_) Relax(run);
    for (const Run& run : runs_) Enqueue(run);
    // Together: they decide in the same round for any number of threads.
    MetWindows met;
    uint64_t followed = 0;
    for (Worker& worker : workers_) {
      met += worker.met();
      followed += worker.followed();
      faces_ += worker.faces();
      worker.Clear();
    }
    passed_.Count(met);
    passed_.Sweep([this](HalfEdge h) { return front_.IsPassed(h); },
                  [this](WindowBlock* list) { Drop(list); });
    winding_.Count(propagated, followed);
    return propagated;
  }

  void Drop(WindowBlock* list) { workers_[0].Drop({list, nullptr}); }

  bool Waits(HalfEdge h) const { return waiting_[h] < kNothing; }

  // Shares out those that have something to do, vertices first.
  void Take(std::span<const uint32_t> ids) {
    order_.clear();
    for (Share& share : shares_) {
      share.events.clear();
      share.next.store(0, std::memory_order_relaxed);
    }
    const auto give = [this](uint32_t member, const Event& event) {
      shares_[member].events.push_back(event);
      order_.push_back(member);
    };
    for (const uint32_t id : ids) {
      if (!(id & kVertexEvent)) __builtin_prefetch(&waiting_[id]);
    }
    // A vertex goes with the half-edge before it.
    uint32_t member = 0;
    for (const uint32_t id : ids) {
      if (id & kVertexEvent) {
        if (front_.TakeEvent(id & ~kVertexEvent)) give(member, {.id = id});
      } else if (workers_.size() > 1 && Waits(id)) {
        member = queues_[waiting_[id]].member;
      }
    }
    const uint32_t most = MostCrossings(mesh_, front_.anchor_count());
    for (const uint32_t id : ids) {
      if ((id & kVertexEvent) || !Waits(id)) continue;
      const Queued& queued = queues_[waiting_[id]];
      const uint32_t times = std::min(queued.crossings + 1, most);
      const Winding winding = WindingAfter(times, most);
      has_dropped_ |= winding == Winding::kCertain;
      give(queued.member, {.id = id,
                           .lists = queued.lists,
                           .passed = passed_.At(id, times),
                           .winding = winding});
      free_.push_back(waiting_[id]);
      waiting_[id] = kNothing + times;
      if constexpr (Front::Goal::kDirects) {
        if (times == 1) crossed_.push_back(id);
      }
    }
  }

  // `most`: MostCrossings.
  Winding WindingAfter(uint32_t crossings, uint32_t most) const {
    if (crossings == most) return Winding::kCertain;
    return crossings >= kManyCrossings && winding_.MayLook()
               ? Winding::kSuspected
               : Winding::kUnknown;
  }

  void DoAll() {
    if (workers_.size() == 1 || order_.size() < kLeastShared) {
      for (Share& share : shares_) {
        Do(share.events, 0, share.events.size(), 0);
      }
      return;
    }
    if (!team_.has_value()) {
      team_.emplace(static_cast<uint32_t>(workers_.size()));
    }
    team_->Run([this](uint32_t member) {
      for (size_t k = 0; k < shares_.size(); ++k) {
        Share& share = shares_[(member + k) % shares_.size()];
        for (;;) {
          const size_t first =
              share.next.fetch_add(kShare, std::memory_order_relaxed);
          if (first >= share.events.size()) break;
          Do(share.events, first, std::min(first + kShare, share.events.size()),
             member);
        }
      }
    });
  }

  // Does events [first, last).
  void Do(std::span<Event> events, size_t first, size_t last, uint32_t member) {
    for (size_t i = first; i < last; ++i) {
      Prefetch(events, i);
      Event& event = events[i];
      event.member = member;
      Worker& worker = workers_[member];
      event.outcome = event.id & kVertexEvent
                          ? worker.Expand(event.id & ~kVertexEvent)
                          : worker.Cross(event.id, event.lists, event.passed,
                                         event.winding);
    }
  }

  // Fetches into cache what the events after event i will need. Each stage
  // needs what the one before has fetched.
  void Prefetch(std::span<const Event> events, size_t i) const {
    if (i + 3 < events.size()) {
      const Event& event = events[i + 3];
      if (event.id & kVertexEvent) {
        PrefetchFan(mesh_, event.id & ~kVertexEvent);
      } else {
        PrefetchFace(mesh_, event.id);
        // Without a branch: whether there are both cannot be foreseen.
        const WindowBlock* const any =
            event.lists[0] != nullptr ? event.lists[0] : event.lists[1];
        for (const WindowBlock* list : event.lists) {
          WindowBlocks::Prefetch(list != nullptr ? list : any);
        }
      }
    }
    if (i + 1 < events.size()) {
      const Event& event = events[i + 1];
      if (event.id & kVertexEvent) return;
      front_.PrefetchCorners(event.id);
      for (const WindowBlock* list : event.lists) {
        if (list != nullptr) WindowBlocks::PrefetchRest(list);
      }
    }
  }

  // Of all that was done, in order. Returns how many windows were propagated.
  uint64_t FindRuns() {
    uint64_t propagated = 0;
    runs_.clear();
    for (Share& share : shares_) share.applied = 0;
    for (const uint32_t member : order_) {
      Share& share = shares_[member];
      const Event& event = share.events[share.applied++];
      pending_ -= event.outcome.waited;
      propagated += event.outcome.propagated;
      if (!runs_.empty() && runs_.back().member == event.member &&
          runs_.back().end == event.outcome.begin) {
        runs_.back().end = event.outcome.end;
      } else {
        runs_.push_back({event.member, event.outcome.begin, event.outcome.end});
      }
    }
    return propagated;
  }

  // Tells the front.
  void Relax(const Run& run) {
    const Worker& worker = workers_[run.member];
    for (uint32_t i = run.begin.observed; i < run.end.observed; ++i) {
      const auto& [h, window, pseudo_source] = worker.observed()[i];
      front_.Observe(h, window, pseudo_source);
    }
    for (uint32_t i = run.begin.relaxation; i < run.end.relaxation; ++i) {
      const auto& [vertex, distance, arrival, ray] = worker.relaxations()[i];
      front_.Relax(vertex, distance, arrival, ray);
    }
  }

  void Enqueue(const Run& run) {
    constexpr uint32_t kAhead = 16;
    const auto lists = workers_[run.member].handed_on();
    for (uint32_t i = run.begin.handed_on; i < run.end.handed_on; ++i) {
      if (i + kAhead < lists.size()) {
        __builtin_prefetch(&waiting_[lists[i + kAhead].to & ~Worker::kBeyond]);
      }
      Enqueue(lists[i], run.member);
    }
  }

  // Adds a list, which `member` has handed on, to what waits at a half-edge.
  void Enqueue(const HandedOn& handed_on, uint32_t member) {
    const auto& [h, from, list, count, label] = handed_on;
    if (h & Worker::kBeyond) {
      const HalfEdge side = h & ~Worker::kBeyond;
      wide_.Add(side, handed_on);
      // The queue knows of it, too.
      front_.queue().Push(mesh_.HalfEdgesAt(side)[0], label);
      return;
    }
    if (!Waits(h)) {
      const uint32_t crossings = waiting_[h] - kNothing;
      if (free_.empty()) {
        waiting_[h] = static_cast<uint32_t>(queues_.size());
        queues_.emplace_back();
      } else {
        waiting_[h] = free_.back();
        free_.pop_back();
      }
      queues_[waiting_[h]] = {.label = std::numeric_limits<double>::infinity(),
                              .half_edge = h,
                              .crossings = crossings};
    }
    Queued& queued = queues_[waiting_[h]];
    queued.member = member;
    WindowBlock*& first = queued.lists[from];
    (first == nullptr ? first : queued.last[from]->next) = list;
    queued.last[from] = list;
    created_ += count;
    pending_ += count;
    peak_ = std::max(peak_, pending_);
    if (++queued.count >= kMostWaiting && Passed::AlwaysKeeps(mesh_, h) &&
        queued.count >= MostWaiting(h)) {
      pending_ += workers_[0].Join(h, queued.lists);
      queued.last = queued.lists;
      queued.count = 1;
    }
    if (label >= queued.label) return;
    queued.label = label;
    front_.queue().Push(h, label);
  }

  Front& front_;
  const Mesh& mesh_;
  const size_t most_in_round_;
  // By half-edge, into queues_; or from kNothing on.
  std::vector<uint32_t> waiting_;
  std::vector<HalfEdge> crossed_;  // with a goal only
  std::vector<Queued> queues_;
  std::vector<uint32_t> free_;  // of queues_
  Passed passed_;
  WideEdges<HandedOn> wide_;
  WindingWatch winding_;
  BlockPool pool_;
  std::deque<Worker> workers_;      // by member of the team
  std::optional<ThreadTeam> team_;  // once a round was wide enough

  // Of the round.
  std::deque<Share> shares_;     // by member
  std::vector<uint32_t> order_;  // of events: whose share has the next
  std::vector<Run> runs_;

  bool has_dropped_ = false;
  uint64_t pending_ = 0;
  uint64_t peak_ = 0;
  uint64_t created_ = 0;
  uint64_t faces_ = 0;
};

}  // namespace geodesic

#endif  // GEODESIC_SOLVER_RULES_LIST_RULE_H_
