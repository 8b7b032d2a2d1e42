// The rule of Mitchell, Mount and Papadimitriou: windows on a half-edge are
// trimmed against each other, so that every point of it belongs to the one
// window that reaches it soonest.
//
// Mitchell, Mount, Papadimitriou: The discrete geodesic problem. SIAM J.
// Comput. 16(4), 1987. Windows as in Surazhsky et al.: Fast exact and
// approximate geodesics on meshes. ACM TOG 24(3), 2005.
//
// The windows of a half-edge are disjoint. Propagated ones stay in its list, to
// trim those that come later, until the wavefront has passed the edge: then
// whatever came would lose all of it, and the list is dropped. Memory thus goes
// with the wavefront, not with the mesh.

#ifndef GEODESIC_RULES_MMP_RULE_H_
#define GEODESIC_RULES_MMP_RULE_H_

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "rules/front.h"
#include "rules/trimming.h"
#include "windows/window.h"
#include "windows/window_lists.h"
#include "windows/window_pool.h"

namespace geodesic {

template <WindowQueue Queue>
class MmpRule {
 public:
  // How many windows ahead of their use the stages of Prefetch come.
  static constexpr std::array<uint32_t, 4> kPrefetchAhead = {12, 8, 4, 2};

  explicit MmpRule(Front<Queue>& front)
      : front_(front),
        mesh_(front.mesh()),
        lists_(front.mesh().half_edge_count()) {}

  // Adds the window of pseudo-source v over a whole half-edge.
  void Open(HalfEdge half_edge, uint32_t v, const Origin& origin) {
    Insert(half_edge, v, origin, {0, mesh_.frame(half_edge).length});
  }

  // Sources were added: nothing here depends on them.
  void Restart() {}

  // Propagates what is left of window `id` across its face. False if nothing
  // is: the window was void, or its pseudo-source has improved since.
  bool Propagate(uint32_t id);

  // Fetches into cache what propagating window `id` will need. Each stage
  // needs what the one before has fetched.
  void Prefetch(uint32_t id, size_t stage) const {
    const auto [h, pseudo_source] = queued_[id];
    if (h == kNoHalfEdge) return;
    switch (stage) {
      case 0:
        lists_.PrefetchHead(h);
        break;
      case 1:
        lists_.PrefetchList(h);
        front_.PrefetchFace(h);
        front_.PrefetchDistance(pseudo_source);
        break;
      case 2:
        front_.PrefetchCorners(h);
        ForEachExit(h, [&](HalfEdge exit) { lists_.PrefetchHead(exit); });
        break;
      default:
        ForEachExit(h, [&](HalfEdge exit) { lists_.PrefetchList(exit); });
    }
  }

  uint64_t created() const { return created_; }
  uint64_t peak_windows() const { return lists_.peak_size(); }
  uint64_t bytes() const {
    return queued_.bytes() + lists_.bytes() +
           listed_.capacity() * sizeof(HalfEdge);
  }

 private:
  // Sweeps come when the lists have doubled, so each window pays for one visit;
  // below this many windows there is little to gain.
  static constexpr uint64_t kLeastSweep = 16384;

  struct Queued {
    HalfEdge half_edge;  // kNoHalfEdge: void, trimmed to nothing since
    uint32_t pseudo_source;
  };

  // Adds a window, as far as it beats those on the half-edge already.
  void Insert(HalfEdge half_edge, uint32_t pseudo_source, const Origin& origin,
              const Interval& interval);
  // Queues a window that is to be in the list of `half_edge`.
  void Enqueue(HalfEdge half_edge, ListedWindow& listed);
  void Cross(HalfEdge h, const Window& window, uint32_t pseudo_source);
  // Drops the lists of all edges that the wavefront has passed.
  void Sweep();
  // Makes a window void if it is in the queue.
  void Forget(const ListedWindow& window);

  template <typename Visit>
  void ForEachExit(HalfEdge h, Visit visit) const {
    const HalfEdgeFrame& frame = mesh_.frame(h);
    if (frame.left_exit != kNoHalfEdge) visit(frame.left_exit);
    if (frame.right_exit != kNoHalfEdge) visit(frame.right_exit);
  }

  Front<Queue>& front_;
  const Mesh& mesh_;
  WindowLists lists_;
  WindowPool<Queued> queued_;     // what is known of a window by its number
  std::vector<HalfEdge> listed_;  // with a list, since the last sweep
  uint64_t next_sweep_ = kLeastSweep;  // when so many windows are in lists
  std::vector<ListedWindow> parts_;    // of Insert, kept for its memory
  uint64_t created_ = 0;
};

template <WindowQueue Queue>
bool MmpRule<Queue>::Propagate(uint32_t id) {
  const auto [h, pseudo_source] = queued_[id];
  queued_.Free(id);
  if (h == kNoHalfEdge) {
    front_.queue().DropVoid();
    return false;
  }
  ListedWindow& listed =
      *std::ranges::find(lists_.Of(h), id, &ListedWindow::id);
  listed.id = kNothing;
  if (Exceeds(listed.window.origin.sigma,
              front_.PseudoSourceDistance(pseudo_source))) {
    return false;
  }
  Cross(h, Window(listed.window), pseudo_source);  // a copy: lists will move
  return true;
}

template <WindowQueue Queue>
void MmpRule<Queue>::Sweep() {
  const double settled = front_.queue().SettledRadius();
  std::erase_if(listed_, [&](HalfEdge h) {
    if (front_.Farthest(h) > settled) return false;
    for (const ListedWindow& window : lists_.Of(h)) Forget(window);
    lists_.Drop(h);
    return true;
  });
  next_sweep_ = std::max(2 * lists_.size(), kLeastSweep);
}

template <WindowQueue Queue>
void MmpRule<Queue>::Forget(const ListedWindow& window) {
  if (window.id == kNothing) return;
  queued_[window.id].half_edge = kNoHalfEdge;
  front_.queue().MarkVoid();
}

template <WindowQueue Queue>
void MmpRule<Queue>::Cross(HalfEdge h, const Window& window,
                           uint32_t pseudo_source) {
  const auto& [interval, origin, begin_distance, end_distance] = window;
  const HalfEdgeFrame& frame = mesh_.frame(h);
  const double left_length = mesh_.frame(Prev(h)).length;
  const double right_length = mesh_.frame(Next(h)).length;
  const double crossing = ApexCrossing(origin, frame);
  // The point of the interval nearest to the ray through the apex; paths
  // through it to the apex are real, and straight if the ray is in there.
  const double through = std::clamp(crossing, interval.begin, interval.end);
  if (std::abs(through - crossing) <= NearMiss(origin, frame)) {
    front_.Relax(mesh_.Apex(h),
                 origin.sigma + (through == crossing
                                     ? DistanceToApex(origin, frame)
                                     : origin.DistanceTo(through) +
                                           EdgePointToApex(through, frame)),
                 {pseudo_source, h, origin.x, origin.depth});
  }
  if (crossing > interval.begin && frame.left_exit != kNoHalfEdge) {
    Insert(frame.left_exit, pseudo_source, UnfoldLeft(origin, frame),
           {ProjectLeft(origin, interval.begin, frame, left_length),
            crossing < interval.end
                ? left_length
                : ProjectLeft(origin, interval.end, frame, left_length)});
  }
  if (crossing < interval.end && frame.right_exit != kNoHalfEdge) {
    Insert(frame.right_exit, pseudo_source,
           UnfoldRight(origin, frame, right_length),
           {crossing > interval.begin
                ? 0
                : right_length -
                      ProjectRight(origin, interval.begin, frame, right_length),
            right_length -
                ProjectRight(origin, interval.end, frame, right_length)});
  }
}

template <WindowQueue Queue>
void MmpRule<Queue>::Insert(HalfEdge half_edge, uint32_t pseudo_source,
                            const Origin& origin, const Interval& interval) {
  const double length = mesh_.frame(half_edge).length;
  const double least_width = kLeastWidth * length;
  if (interval.width() <= least_width) return;
  const Window newer = Window::Over(interval, origin);
  // Cheaper than the contests it saves: a third of them, on real meshes.
  if (front_.EndsAreNearer(newer, length, mesh_.From(half_edge),
                           mesh_.To(half_edge))) {
    return;
  }
  const std::span<const ListedWindow> list = lists_.Of(half_edge);

  // The windows [first, last) that overlap the new one give way to parts_.
  uint32_t first = 0;
  while (first < list.size() &&
         list[first].window.interval.end <= interval.begin) {
    ++first;
  }
  uint32_t last = first;
  parts_.clear();

  // The new window holds [held_from, ...) until an older one keeps a part.
  double held_from = interval.begin;
  const auto put_down = [&](double held_until) {
    const Interval held{held_from, held_until};
    if (held.width() > least_width) {
      parts_.push_back({newer, pseudo_source, kNothing});
      parts_.back().window.CutTo(held);
      Enqueue(half_edge, parts_.back());
    }
  };
  for (; last < list.size() && list[last].window.interval.begin < interval.end;
       ++last) {
    const ListedWindow& older = list[last];
    const Interval& held = older.window.interval;
    const Interval overlap{std::max(held.begin, interval.begin),
                           std::min(held.end, interval.end)};
    const Interval won = WonByNewer(older.window, newer);
    if (won.width() <= 0) {
      put_down(overlap.begin);
      held_from = overlap.end;
      parts_.push_back(older);
      continue;
    }
    if (won.begin > overlap.begin) {
      put_down(overlap.begin);
      held_from = won.begin;
    }
    const Interval before{held.begin, won.begin};
    const Interval after{won.end, held.end};
    const bool keeps_before = before.width() > least_width;
    const bool keeps_after = after.width() > least_width;
    if (keeps_before) {
      parts_.push_back(older);
      parts_.back().window.CutTo(before);
    }
    if (keeps_after) {
      put_down(won.end);
      held_from = overlap.end;
      parts_.push_back(older);
      parts_.back().window.CutTo(after);
      // Both ends of a window in the queue are left: the second is queued anew.
      if (keeps_before && older.id != kNothing) {
        Enqueue(half_edge, parts_.back());
      }
    }
    if (!keeps_before && !keeps_after) Forget(older);
  }
  put_down(interval.end);
  if (list.empty() && !parts_.empty()) listed_.push_back(half_edge);
  lists_.Replace(half_edge, first, last, parts_);
  if (lists_.size() >= next_sweep_) Sweep();
}

template <WindowQueue Queue>
void MmpRule<Queue>::Enqueue(HalfEdge half_edge, ListedWindow& listed) {
  listed.id = queued_.Allocate({half_edge, listed.pseudo_source});
  ++created_;
  front_.Observe(half_edge, listed.window, listed.pseudo_source);
  front_.queue().Push(listed.id, listed.window.Label());
}

}  // namespace geodesic

#endif  // GEODESIC_RULES_MMP_RULE_H_
