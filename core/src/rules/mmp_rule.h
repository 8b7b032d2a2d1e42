// The rule of Mitchell, Mount and Papadimitriou: windows on a half-edge are
// trimmed against each other, so that every point of it belongs to the one
// window that reaches it soonest.
//
// Mitchell, Mount, Papadimitriou: The discrete geodesic problem. SIAM J.
// Comput. 16(4), 1987. Windows as in Surazhsky et al.: Fast exact and
// approximate geodesics on meshes. ACM TOG 24(3), 2005.
//
// The windows of a half-edge are disjoint. Propagated ones stay in its list, to
// trim those that come later.

#ifndef GEODESIC_RULES_MMP_RULE_H_
#define GEODESIC_RULES_MMP_RULE_H_

#include <algorithm>
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
  explicit MmpRule(Front<Queue>& front)
      : front_(front),
        mesh_(front.mesh()),
        lists_(front.mesh().half_edge_count()) {}

  // Adds the window of pseudo-source v over a whole half-edge.
  void Open(HalfEdge half_edge, uint32_t v, const Origin& origin) {
    Insert(half_edge, v, origin, {0, mesh_.frame(half_edge).length});
  }

  // Propagates what is left of window `id` across its face. False if nothing
  // is: the window was void, or its pseudo-source has improved since.
  bool Propagate(uint32_t id);

  void PrefetchWindow(uint32_t id) const { pool_.Prefetch(id); }
  void PrefetchFace(uint32_t id) const {
    const Window& window = pool_[id];
    front_.PrefetchFace(window.half_edge);
    front_.PrefetchDistance(window.pseudo_source);
  }
  void PrefetchCorners(uint32_t id) const {
    const HalfEdge h = pool_[id].half_edge;
    front_.PrefetchCorners(h);
    lists_.PrefetchHead(mesh_.frame(h).left_exit);
    lists_.PrefetchHead(mesh_.frame(h).right_exit);
  }

  uint64_t created() const { return created_; }
  uint64_t peak_windows() const { return pool_.peak(); }
  uint64_t bytes() const { return pool_.bytes() + lists_.bytes(); }

 private:
  enum State : uint32_t {
    kQueued,
    kPropagated,  // in its list only
    kVoid,        // in the queue only: nothing of it is left
  };

  struct alignas(64) Window {
    Interval interval;
    Origin origin;
    HalfEdge half_edge;
    uint32_t pseudo_source;
    State state;
  };
  static_assert(sizeof(Window) == 64);

  // Adds a window, as far as it beats those on the half-edge already.
  void Insert(HalfEdge half_edge, uint32_t pseudo_source, const Origin& origin,
              Interval interval);
  // Makes a window, appends it to parts_, and queues it unless it is the rest
  // of one that has been propagated.
  void Add(const Window& window);
  // Forgets a window of which nothing is left.
  void Discard(uint32_t id);

  void Cross(const Window& window);

  Front<Queue>& front_;
  const Mesh& mesh_;
  WindowPool<Window> pool_;
  WindowLists lists_;
  std::vector<WindowLists::Entry> parts_;  // of Insert, kept for its memory
  uint64_t created_ = 0;
};

template <WindowQueue Queue>
bool MmpRule<Queue>::Propagate(uint32_t id) {
  Window& window = pool_[id];
  if (window.state == kVoid) {
    pool_.Free(id);
    front_.queue().DropVoid();
    return false;
  }
  window.state = kPropagated;
  if (window.origin.sigma >
      front_.distance(window.pseudo_source) * (1 + kDominance)) {
    return false;
  }
  Cross(window);
  return true;
}

template <WindowQueue Queue>
void MmpRule<Queue>::Cross(const Window& window) {
  const auto& [interval, origin, h, pseudo_source, state] = window;
  const HalfEdgeFrame& frame = mesh_.frame(h);
  const double left_length = mesh_.frame(Prev(h)).length;
  const double right_length = mesh_.frame(Next(h)).length;
  const double crossing = ApexCrossing(origin, frame);

  // The point of the interval nearest to the ray through the apex; paths
  // through it to the apex are real, and straight if the ray is in there.
  const double through = std::clamp(crossing, interval.begin, interval.end);
  if (std::abs(through - crossing) <= kNearMiss * frame.length) {
    front_.Relax(mesh_.Apex(h),
                 origin.sigma + (through == crossing
                                     ? DistanceToApex(origin, frame)
                                     : origin.DistanceTo(through) +
                                           EdgePointToApex(through, frame)));
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
                            const Origin& origin, Interval interval) {
  const double length = mesh_.frame(half_edge).length;
  const double least_width = kLeastWidth * length;
  if (interval.width() <= least_width) return;
  // Cheaper than the contests it saves: a third of them, on real meshes.
  if (front_.EndsAreNearer(origin, interval, length, mesh_.From(half_edge),
                           mesh_.To(half_edge))) {
    return;
  }
  const std::span<const WindowLists::Entry> list = lists_.Of(half_edge);

  // The entries [first, last) that overlap the new window give way to parts_.
  uint32_t first = 0;
  while (first < list.size() && list[first].begin <= interval.begin) ++first;
  if (first > 0 && pool_[list[first - 1].id].interval.end > interval.begin) {
    --first;
  }
  uint32_t last = first;
  parts_.clear();

  // The new window holds [held_from, ...) until an older one keeps a part.
  double held_from = interval.begin;
  const auto put_down = [&](double held_until) {
    const Interval held{held_from, held_until};
    if (held.width() > least_width) {
      Add({held, origin, half_edge, pseudo_source, kQueued});
    }
  };
  for (; last < list.size() && list[last].begin < interval.end; ++last) {
    const uint32_t id = list[last].id;
    const Window older = pool_[id];
    const Interval overlap{std::max(older.interval.begin, interval.begin),
                           std::min(older.interval.end, interval.end)};
    const Interval won = WonByNewer(older.origin, origin, overlap);
    if (won.begin > overlap.begin || won.width() <= 0) {
      put_down(overlap.begin);
      held_from = won.begin;
    }
    if (won.width() <= 0) {
      parts_.push_back(list[last]);
      held_from = overlap.end;
      continue;
    }
    const Interval before{older.interval.begin, won.begin};
    const Interval after{won.end, older.interval.end};
    const bool keeps_before = before.width() > least_width;
    const bool keeps_after = after.width() > least_width;
    if (keeps_before) {
      pool_[id].interval = before;
      parts_.push_back({before.begin, id});
    }
    if (keeps_after) {
      put_down(won.end);
      held_from = overlap.end;
    }
    if (keeps_after && keeps_before) {
      Window rest = older;
      rest.interval = after;
      Add(rest);
    } else if (keeps_after) {
      pool_[id].interval = after;
      parts_.push_back({after.begin, id});
    } else if (!keeps_before) {
      Discard(id);
    }
  }
  put_down(interval.end);
  lists_.Replace(half_edge, first, last, parts_);
}

template <WindowQueue Queue>
void MmpRule<Queue>::Add(const Window& window) {
  const uint32_t id = pool_.Allocate(window);
  parts_.push_back({window.interval.begin, id});
  if (window.state == kQueued) {
    ++created_;
    front_.queue().Push(id, Label(window.origin, window.interval));
  }
}

template <WindowQueue Queue>
void MmpRule<Queue>::Discard(uint32_t id) {
  if (pool_[id].state == kQueued) {
    pool_[id].state = kVoid;
    front_.queue().MarkVoid();
  } else {
    pool_.Free(id);
  }
}

}  // namespace geodesic

#endif  // GEODESIC_RULES_MMP_RULE_H_
