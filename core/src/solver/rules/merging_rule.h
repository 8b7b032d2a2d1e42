// Windows within a tolerance: neighbours that wait at a half-edge together are
// merged before they cross its face (docs/algorithm.md, 22).
//
// As with the list rule (list_rule.h), windows that wait at a half-edge are
// trimmed against each other when it is due, cross together and are forgotten.
// But lists hold one or two windows here, and what a list costs beside its
// windows would be most of the time: so windows lie one by one, each in a cache
// line of its own with the distances at its ends, and everything is done at
// once, by one thread.
//
// Lower bounds hold: wherever a shortest path crosses an edge, some window is
// no farther than the truth. Let that hold on one edge, from which a shortest
// path goes straight to y on the next. The shortest way to y through the
// windows' lower envelope is no longer. It does not cross where trimming
// changes windows: there the slope falls, which is no minimum. Nor where
// neighbours meet: they agree, and their rays coincide or converge. Nor in a
// window that a filter dropped, which is longer everywhere. So it crosses
// inside a window, along its own ray, and that window reaches y with no more
// than the truth.
//
// Merged origins may lie anywhere, so the envelope splits windows where the
// difference of two has its extremum. A merged window is never stale. Filters
// compare windows with upper bounds.

#ifndef GEODESIC_SOLVER_RULES_MERGING_RULE_H_
#define GEODESIC_SOLVER_RULES_MERGING_RULE_H_

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "geodesic/distance_field.h"
#include "geodesic/mesh.h"
#include "mesh/prefetch.h"
#include "solver/accuracy.h"
#include "solver/rules/crossing_counter.h"
#include "solver/rules/expansion.h"
#include "solver/rules/face_corners.h"
#include "solver/rules/front.h"
#include "solver/rules/merging.h"
#include "solver/rules/passed_windows.h"
#include "solver/rules/shadow_fan.h"
#include "solver/rules/winding.h"
#include "solver/trimming/window_envelope.h"
#include "solver/windows/window.h"
#include "solver/windows/window_lists.h"
#include "solver/windows/window_pool.h"
#include "tolerances.h"

namespace geodesic {

// REQUIRES: the front's origins are points, its accuracy WithinTolerance, and
// the mesh has no faces without area.
template <typename Front>
class MergingRule {
 public:
  // The most half-edges and vertices that are propagated together.
  static constexpr size_t most_together() { return 1024; }

  explicit MergingRule(Front& front)
      : front_(front),
        mesh_(front.mesh()),
        waiting_(front.mesh().half_edge_count(), kNone),
        crossing_counts_(front.mesh().half_edge_count()),
        passed_(front.mesh()) {}

  // Adds a pseudo-source's window over what it sees of a half-edge.
  void Open(HalfEdge half_edge, uint32_t pseudo_source, const Origin& origin,
            const Interval& interval) {
    const auto window = front_.UsefulWindow(half_edge, origin, interval);
    if (window.has_value()) Wait(half_edge, *window, pseudo_source);
  }

  // Sources were added: nothing here depends on them.
  void Restart() {}

  // Forgets all windows. O(half-edges that they came to).
  // REQUIRES: the front has a goal.
  void Clear() {
    passed_.Clear(waited_at_, [](uint32_t) {});
    for (const HalfEdge h : waited_at_) waiting_[h] = kNone;
    waited_at_.clear();
    windows_.Clear();
    crossing_counts_ = CrossingCounter(mesh_.half_edge_count());
    winding_.Clear();
    pending_ = peak_ = created_ = 0;
  }

  // Expands vertices (numbers with kVertexEvent) and propagates all that waits
  // at half-edges across their faces. Returns how many windows were propagated;
  // whatever is named twice counts once. Vertices come first: where the two
  // alternate the processor mispredicts the branch between them.
  uint64_t Propagate(std::span<const uint32_t> ids) {
    half_edges_.clear();
    vertices_.clear();
    for (const uint32_t id : ids) {
      if (id & kVertexEvent) {
        vertices_.push_back(id & ~kVertexEvent);
      } else {
        __builtin_prefetch(&waiting_[id]);
        half_edges_.push_back(id);
      }
    }
    DirectSink sink(front_, *this);
    for (size_t i = 0; i < vertices_.size(); ++i) {
      if (i + 2 < vertices_.size()) PrefetchFan(mesh_, vertices_[i + 2]);
      if (front_.TakeEvent(vertices_[i])) Expand(front_, vertices_[i], sink);
    }
    uint64_t propagated = 0;
    met_ = {};
    for (size_t i = 0; i < half_edges_.size(); ++i) {
      Prefetch(i);
      propagated += Cross(half_edges_[i]);
    }
    passed_.Count(met_);
    passed_.Sweep([this](HalfEdge h) { return front_.IsPassed(h); },
                  [this](uint32_t list) { DropPassed(list); });
    return propagated;
  }

  uint64_t created() const { return created_; }
  // What was done.
  uint64_t steps() const { return created_; }
  uint64_t pending() const { return pending_; }
  uint64_t peak_windows() const { return peak_; }
  uint64_t bytes() const {
    return waiting_.capacity() * sizeof(uint32_t) + windows_.bytes() +
           passed_.bytes() + crossing_counts_.bytes() +
           waited_at_.capacity() * sizeof(HalfEdge);
  }

 private:
  static constexpr uint32_t kNone = std::numeric_limits<uint32_t>::max();

  // A list is a chain in windows_: the number of its first, and 1.
  using Passed = PassedWindows<uint32_t>;

  // One that waits: a cache line.
  struct alignas(64) Waiting {
    Window window;
    uint32_t pseudo_source;
    uint32_t next;  // at the half-edge
  };
  static_assert(sizeof(Waiting) == 64);

  // The first that waits at a half-edge has the least label, with which the
  // half-edge is queued.
  void Wait(HalfEdge h, const Window& window, uint32_t pseudo_source) {
    const double label = window.Label();
    uint32_t& first = waiting_[h];
    if constexpr (Front::Goal::kDirects) {
      if (std::isinf(front_.KeyOf(h, window, label))) return;
      if (first == kNone) waited_at_.push_back(h);
    }
    ++created_;
    peak_ = std::max(peak_, ++pending_);
    if (first == kNone || label < windows_[first].window.Label()) {
      first = windows_.Allocate({window, pseudo_source, first});
      front_.queue().Push(h, label);
    } else {
      uint32_t& next = windows_[first].next;
      next = windows_.Allocate({window, pseudo_source, next});
    }
  }

  // Fetches into cache what half-edges after the i-th will need. Each stage
  // needs what the one before has fetched.
  void Prefetch(size_t i) const {
    const size_t size = half_edges_.size();
    if (i + 16 < size) {
      const HalfEdge h = half_edges_[i + 16];
      PrefetchFace(mesh_, h);
      if (waiting_[h] != kNone) windows_.Prefetch(waiting_[h]);
    }
    if (i + 8 < size) {
      const HalfEdge h = half_edges_[i + 8];
      front_.PrefetchCorners(h);
      for (const Exit exit :
           {mesh_.frame(h).left_exit, mesh_.frame(h).right_exit}) {
        if (exit < kIrregularExit) __builtin_prefetch(&waiting_[exit]);
      }
    }
  }

  // Propagates all that waits at h. Returns how many windows that were.
  uint64_t Cross(HalfEdge h) {
    if (waiting_[h] == kNone) return 0;
    const double length = mesh_.frame(h).length;
    Take(h, length);
    std::vector<ListedWindow>& list = envelope_.windows();
    if (list.size() > 1) MergeNeighbours(list);
    const uint32_t times = crossing_counts_.Count(h, front_.reached());
    if (times >= kManyCrossings && winding_.MayLook()) DropWinding(h, list);
    if (uint32_t* const passed = passed_.At(h, times)) {
      MeetPassed(h, *passed, list);
    }
    if (list.empty()) return 0;
    if (front_.Watches(h)) {
      for (const ListedWindow& listed : list) {
        front_.Observe(h, listed.window, listed.pseudo_source);
      }
    }
    const FaceCorners corners(mesh_, h);
    if (crossings_to_apex_.size() < list.size()) {
      crossings_to_apex_.resize(2 * list.size());
    }
    ReachApex(h, corners.apex, list);
    Leave(FaceSide<kLeft>(mesh_, h), corners.from, corners.apex, list);
    Leave(FaceSide<kRight>(mesh_, h), corners.apex, corners.to, list);
    winding_.Count(list.size(), 0);
    return list.size();
  }

  // If the pseudo-source has improved, a newer window is on its way, or those
  // of a straight path to it are.
  bool IsOfUse(const Waiting& waiting) const {
    return waiting.window.origin.sigma <=
           front_.PseudoSourceDistance(waiting.pseudo_source);
  }

  // Moves what waits at h and is of use to the envelope.
  void Take(HalfEdge h, double length) {
    envelope_.Start(length, true);
    taken_.clear();
    for (uint32_t id = std::exchange(waiting_[h], kNone); id != kNone;) {
      const Waiting& waiting = windows_[id];
      const uint32_t next = waiting.next;
      --pending_;
      if (IsOfUse(waiting)) {
        taken_.emplace_back(waiting.window.interval.begin, id);
      } else {
        windows_.Free(id);
      }
      id = next;
    }
    if (taken_.size() > 1) std::ranges::sort(taken_);
    for (const auto& [begin, id] : taken_) {
      const ListedWindow listed = {windows_[id].window,
                                   windows_[id].pseudo_source};
      if (taken_.size() == 1) {
        envelope_.Append(listed);
      } else {
        envelope_.Add(listed);
      }
      windows_.Free(id);
    }
  }

  // Merges neighbours while their accounts allow it.
  void MergeNeighbours(std::vector<ListedWindow>& list) const {
    const double share = front_.accuracy().share();
    const double merge_share = std::min(kPartOfAccount * share, kMostOfLabel);
    size_t kept = 0;
    MergedWindow merged;
    for (size_t i = 1; i < list.size(); ++i) {
      ListedWindow& last = list[kept];
      const ListedWindow& next = list[i];
      const double label = std::min(last.window.Label(), next.window.Label());
      if (FindMerged(last.window, next.window, merge_share * label, merged)) {
        const float account = RoundedUp(std::max(
            front_.AccountOf(last.pseudo_source) + merged.below_first,
            front_.AccountOf(next.pseudo_source) + merged.below_second));
        if (account <= share * label) {
          last = {merged.window, MergedWithAccount(account)};
          continue;
        }
      }
      if (++kept != i) list[kept] = next;
    }
    list.resize(kept + 1);
  }

  // Relaxes the apex.
  void ReachApex(HalfEdge h, uint32_t vertex,
                 const std::vector<ListedWindow>& list) {
    const HalfEdgeFrame& frame = mesh_.frame(h);
    const PlanePoint apex = ApexOf(frame);
    double best = front_.distance(vertex);
    double upper = front_.UpperBound(vertex);
    const size_t none = list.size();
    size_t nearest = none, surest = none;
    double missed_by = 0;
    for (size_t i = 0; i < list.size(); ++i) {
      const auto& [interval, origin, begin_distance, end_distance] =
          list[i].window;
      const double crossing = CrossingTo(origin, apex);
      crossings_to_apex_[i] = crossing;
      // Paths through the point of the interval nearest to the ray into the
      // apex are real, and straight if the ray is in there.
      const double through = std::clamp(crossing, interval.begin, interval.end);
      const double missed = std::abs(through - crossing);
      if (missed > 0 && missed > NearMiss(origin, frame, apex)) continue;
      const double distance = PathToPlace(origin, through, crossing, apex);
      const double bound = distance + front_.AccountOf(list[i].pseudo_source);
      if (Front::Improves(bound, upper)) {
        upper = bound;
        surest = i;
      }
      if (!Front::Improves(distance, best)) continue;
      best = distance;
      nearest = i;
      missed_by = missed;
    }
    const auto arrival = [&](size_t i) {
      const Origin& origin = list[i].window.origin;
      return Arrival{list[i].pseudo_source, h, origin.x, origin.depth};
    };
    if (nearest != none) {
      front_.Relax(vertex, best, arrival(nearest),
                   RayPast(mesh_, h, list[nearest].window.origin, missed_by));
    }
    // Not the nearest, so no ray of it bends at the apex.
    if (surest != none && surest != nearest) {
      front_.Relax(vertex, upper - front_.AccountOf(list[surest].pseudo_source),
                   arrival(surest));
    }
  }

  // Hands on what leaves a face by a side, which runs from -> to, seen from
  // beyond.
  template <Side kSide>
  void Leave(const FaceSide<kSide>& side, uint32_t from, uint32_t to,
             const std::vector<ListedWindow>& list) {
    if (side.exit == kNoHalfEdge) return;
    for (size_t i = 0; i < list.size(); ++i) {
      const auto& [interval, origin, begin_distance, end_distance] =
          list[i].window;
      const double crossing = crossings_to_apex_[i];
      if (!side.IsReached(interval, crossing)) continue;
      const Window child =
          Window::Over(side.InExit(side.Hit(origin, interval, crossing)),
                       Unfold(side, origin));
      if (IsLost(child.interval, child.origin, side.length) ||
          front_.EndsAreNearer(child, side.length, from, to)) {
        continue;
      }
      if (side.exit < kIrregularExit) {
        Wait(side.exit, child, list[i].pseudo_source);
        continue;
      }
      front_.Cross(
          side.half_edge, child.origin, child.interval,
          [&](HalfEdge half_edge, const Origin& seen, const Interval& through) {
            Wait(half_edge, Window::Over(through, seen), list[i].pseudo_source);
          });
    }
  }

  void DropWinding(HalfEdge h, std::vector<ListedWindow>& list) {
    uint64_t followed = 0;
    std::erase_if(list, [&](const ListedWindow& listed) {
      return !IsMerged(listed.pseudo_source) &&
             ComesBack(mesh_, h, listed.window, followed);
    });
    winding_.Count(0, followed);
  }

  // As ListWorker::MeetPassed.
  void MeetPassed(HalfEdge h, uint32_t& passed,
                  std::vector<ListedWindow>& list) {
    const double length = mesh_.frame(h).length;
    MetWindows met{.all = list.size()};
    envelope_of_passed_.Start(length, true);
    std::vector<ListedWindow>& older = envelope_of_passed_.windows();
    for (uint32_t id = passed; id != 0; id = windows_[id - 1].next) {
      const Waiting& kept = windows_[id - 1];
      if (IsOfUse(kept)) older.push_back({kept.window, kept.pseudo_source});
    }
    if (passed != 0) {
      met.late = list.size();
      met.lost = std::erase_if(list, [&](const ListedWindow& listed) {
        return LosesAll(listed.window, length, true, older.size(),
                        [&older](size_t k) { return older[k].window; });
      });
    }
    if (!Passed::AlwaysKeeps(mesh_, h)) met_ += met;
    if (list.empty()) return;
    DropPassed(passed);
    if (older.size() + list.size() > Passed::Most(mesh_, h)) return;
    for (const ListedWindow& listed : list) envelope_of_passed_.Add(listed);
    for (size_t i = older.size(); i-- > 0;) {
      passed =
          windows_.Allocate({older[i].window, older[i].pseudo_source, passed}) +
          1;
    }
  }
  void DropPassed(uint32_t& passed) {
    while (passed != 0) {
      const uint32_t id = passed - 1;
      passed = windows_[id].next;
      windows_.Free(id);
    }
  }

  Front& front_;
  const Mesh& mesh_;
  std::vector<uint32_t> waiting_;    // by half-edge, into windows_
  std::vector<HalfEdge> waited_at_;  // with a goal only
  WindowPool<Waiting> windows_;
  CrossingCounter crossing_counts_;  // of lists
  Passed passed_;
  WindingWatch winding_;
  MetWindows met_;

  // Scratch, kept for its memory.
  std::vector<uint32_t> vertices_;
  std::vector<HalfEdge> half_edges_;
  std::vector<std::pair<double, uint32_t>> taken_;  // where they begin
  std::vector<double> crossings_to_apex_;
  WindowEnvelope<WithinTolerance> envelope_, envelope_of_passed_;

  uint64_t pending_ = 0;
  uint64_t peak_ = 0;
  uint64_t created_ = 0;
};

}  // namespace geodesic

#endif  // GEODESIC_SOLVER_RULES_MERGING_RULE_H_
