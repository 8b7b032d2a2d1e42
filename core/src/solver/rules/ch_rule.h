// The Chen-Han rule, without (CH) and with the Xin-Wang filter (ICH).
//
// Chen, Han: Shortest paths on a polyhedron. SoCG 1990: one angle, one split.
// Xin, Wang: Improving Chen and Han's algorithm on the discrete geodesic
// problem. ACM TOG 28(4), 2009: the window filter.
//
// The geometry of a window is in chen_han_crossing.h.
//
// A window is propagated once and then freed. It has two children only if its
// distance at the apex is the best yet across its half-edge. A worse one keeps
// the child on its own side of the best one's ray, because its rays to the
// other side cross that ray where the best one is nearer. The lean of the rays
// at the apex tells the sides; it differs even where the apex lies on the edge.
// If both rays lie on one line nothing crosses, and both children stay: the
// worse window may come from behind the better one's pseudo-source and pass it.
// A source that is no vertex may be passed on both sides where there are others
// (Front::MayBePassedBy): its windows prune nothing. Where several sources are
// like that, the MMP rule is used instead (AlgorithmFor).
//
// Without the filter nothing else ends a window on a closed surface. Two facts
// about shortest paths do: a path enters a face once at most, so no window has
// more ancestors than the mesh has faces (Chen and Han), and it is no longer
// than the way along edges to the farthest point.

#ifndef GEODESIC_SOLVER_RULES_CH_RULE_H_
#define GEODESIC_SOLVER_RULES_CH_RULE_H_

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <queue>
#include <type_traits>
#include <utility>
#include <vector>

#include "mesh/prefetch.h"
#include "solver/rules/chen_han_crossing.h"
#include "solver/rules/front.h"
#include "solver/windows/window.h"
#include "solver/windows/window_pool.h"

namespace geodesic {

// No point of the surface that paths lead to is farther than this, given the
// vertices that `front` has reached: each has a way to it along edges to a
// corner of its face and from there no farther than a side of that face.
// O(n log n) (Dijkstra).
template <typename Front>
double EdgeReach(const Front& front) {
  const Mesh& mesh = front.mesh();
  using Reached = std::pair<double, uint32_t>;
  std::priority_queue<Reached, std::vector<Reached>, std::greater<>> next;
  std::vector<double> distances(mesh.vertex_count());
  for (uint32_t v = 0; v < mesh.vertex_count(); ++v) {
    distances[v] = front.distance(v);
    if (std::isfinite(distances[v])) next.emplace(distances[v], v);
  }
  double reach = 0;
  while (!next.empty()) {
    const double distance = next.top().first;
    const uint32_t v = next.top().second;
    next.pop();
    if (distance > distances[v]) continue;
    reach = std::max(reach, distance);
    const auto relax = [&](uint32_t to, double length) {
      reach = std::max(reach, distance + length);
      if (distance + length >= distances[to]) return;
      distances[to] = distance + length;
      next.emplace(distances[to], to);
    };
    for (HalfEdge h : mesh.Outgoing(v)) {
      relax(mesh.To(h), mesh.frame(h).length);
      relax(mesh.Apex(h), mesh.frame(Prev(h)).length);
    }
  }
  return reach;
}

// What ends windows, beside one angle, one split.
enum class WindowFilter { kNone, kXinWang };

// REQUIRES: the front's origins are points.
template <typename Front, WindowFilter kFilter>
class ChenHanRule {
 public:
  // How many windows ahead of their use the stages of Prefetch come.
  static constexpr std::array<uint32_t, 3> kPrefetchAhead = {12, 8, 4};

  explicit ChenHanRule(Front& front)
      : front_(front),
        mesh_(front.mesh()),
        best_(front.mesh().half_edge_count()) {}

  // Adds a pseudo-source's window over what it sees of a half-edge.
  void Open(HalfEdge half_edge, uint32_t pseudo_source, const Origin& origin,
            const Interval& interval) {
    if (interval.width() > 0) {
      Add(Window::Over(interval, origin), half_edge, pseudo_source, {});
    }
  }

  // Sources were added: more may be within reach.
  void Restart() {
    reach_.reset();
    if (std::exchange(holds_anchors_, false)) {
      std::ranges::fill(best_, BestAtApex());
    }
  }

  // Forgets all windows. O(half-edges whose apex was reached).
  // REQUIRES: the front has a goal; no window is left (Drop).
  void Clear() {
    for (const HalfEdge h : touched_) best_[h] = {};
    touched_.clear();
    holds_anchors_ = false;
    reach_.reset();
  }
  // Frees window `id`, which will not be propagated.
  void Drop(uint32_t id) { pool_.Free(id); }

  // Propagates window `id` across its face and frees it. False if the window
  // turned out to be useless: it does not count as propagated.
  bool Propagate(uint32_t id) {
    const Entry entry = pool_[id];
    pool_.Free(id);
    const auto& [interval, origin, h, pseudo_source] = entry.window;
    // The pseudo-source has improved since: its newer windows replace this one.
    if (Exceeds(origin.sigma, front_.PseudoSourceDistance(pseudo_source)))
      return false;
    if constexpr (kFilters) {
      // Distances have improved since the window was made: test it again.
      if (front_.EndsAreNearer(Window::Over(interval, origin),
                               mesh_.frame(h).length, mesh_.From(h),
                               mesh_.To(h))) {
        return false;
      }
    }
    if (!kFilters && !reach_.has_value()) reach_ = EdgeReach(front_);

    const ApexMeeting meeting =
        MeetApex(front_, entry.window,
                 [this](uint32_t vertex, double distance,
                        const Arrival& arrival, const IncomingRay& ray) {
                   front_.Relax(vertex, distance, arrival, ray);
                 });
    if (meeting.crossing <= interval.begin) {
      Leave<kRight>(entry, meeting.crossing);
      return true;
    }
    if (meeting.crossing >= interval.end) {
      Leave<kLeft>(entry, meeting.crossing);
      return true;
    }
    BestAtApex& best = best_[h];
    const bool goes_left = meeting.goes_left(best);
    const bool goes_right = meeting.goes_right(best);
    if (meeting.distance < best.distance &&
        !front_.MayBePassedBy(pseudo_source)) {
      if constexpr (Front::Goal::kDirects) {
        if (std::isinf(best.distance)) touched_.push_back(h);
      }
      best = {meeting.distance, meeting.lean};
      holds_anchors_ |= pseudo_source >= mesh_.vertex_count();
    }
    if (goes_left) Leave<kLeft>(entry, meeting.crossing);
    if (goes_right) Leave<kRight>(entry, meeting.crossing);
    return true;
  }

  // Fetches into cache what propagating window `id` will need. Each stage
  // needs what the one before has fetched.
  void Prefetch(uint32_t id, size_t stage) const {
    if (stage == 0) {
      pool_.Prefetch(id);
      return;
    }
    const Entry& entry = pool_[id];
    if (stage == 1) {
      PrefetchFace(mesh_, entry.window.half_edge);
      front_.PrefetchDistance(entry.window.pseudo_source);
      __builtin_prefetch(&best_[entry.window.half_edge]);
    } else {
      front_.PrefetchCorners(entry.window.half_edge);
    }
  }

  uint64_t created() const { return created_; }
  // What was done.
  uint64_t steps() const { return created_; }
  uint64_t pending() const { return pool_.live(); }
  uint64_t peak_windows() const { return pool_.peak(); }
  uint64_t bytes() const {
    return pool_.bytes() + best_.capacity() * sizeof(BestAtApex) +
           touched_.capacity() * sizeof(HalfEdge);
  }

 private:
  static constexpr bool kFilters = kFilter == WindowFilter::kXinWang;

  // How many faces a window has crossed since its pseudo-source: kept only
  // where it ends windows.
  struct Crossed {
    uint32_t faces = 0;
  };
  struct Untold {};
  using Depth = std::conditional_t<kFilters, Untold, Crossed>;

  // A window of the wavefront.
  struct Entry {
    ChenHanWindow window;
    [[no_unique_address]] Depth depth;
  };
  static_assert(!kFilters || sizeof(Entry) == 48);

  void Add(const Window& window, HalfEdge half_edge, uint32_t pseudo_source,
           Depth depth) {
    ++created_;
    front_.Observe(half_edge, window, pseudo_source);
    const double key = front_.KeyOf(half_edge, window, window.Label());
    if constexpr (Front::Goal::kDirects) {
      if (std::isinf(key)) return;
    }
    front_.queue().Push(pool_.Allocate({{window.interval, window.origin,
                                         half_edge, pseudo_source},
                                        depth}),
                        key);
  }
  void AddChild(const Window& window, HalfEdge half_edge, const Entry& parent) {
    if constexpr (kFilters) {
      Add(window, half_edge, parent.window.pseudo_source, {});
    } else {
      const Crossed depth{parent.depth.faces + 1};
      if (depth.faces >= mesh_.face_count()) return;
      if (Exceeds(window.Label(), *reach_)) return;
      Add(window, half_edge, parent.window.pseudo_source, depth);
    }
  }

  // Makes the child across a side that the parent reaches. `crossing`: of the
  // ray into the apex.
  template <Side kSide>
  void Leave(const Entry& parent, double crossing) {
    LeaveAcross<kSide, kFilters>(front_, parent.window, crossing,
                                 [&](HalfEdge half_edge, const Window& child) {
                                   AddChild(child, half_edge, parent);
                                 });
  }

  Front& front_;
  const Mesh& mesh_;
  WindowPool<Entry> pool_;
  std::vector<BestAtApex> best_;   // one per half-edge
  std::vector<HalfEdge> touched_;  // those that are known; with a goal only
  // Whether some of them are of sources that are no vertex.
  bool holds_anchors_ = false;
  // No point is farther than this; set by the first window of a start. Not if
  // kFilters.
  std::optional<double> reach_;
  uint64_t created_ = 0;
};

// As templates over the front alone, which is what Propagation takes.
template <typename Front>
using ChRule = ChenHanRule<Front, WindowFilter::kNone>;
template <typename Front>
using IchRule = ChenHanRule<Front, WindowFilter::kXinWang>;

}  // namespace geodesic

#endif  // GEODESIC_SOLVER_RULES_CH_RULE_H_
