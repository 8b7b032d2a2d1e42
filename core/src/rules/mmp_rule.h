// The rule of Mitchell, Mount and Papadimitriou: windows on a half-edge are
// trimmed against each other, so that every point of it belongs to the one
// window that reaches it soonest.
//
// Mitchell, Mount, Papadimitriou: The discrete geodesic problem. SIAM J.
// Comput. 16(4), 1987. Windows as in Surazhsky et al.: Fast exact and
// approximate geodesics on meshes. ACM TOG 24(3), 2005.
//
// Windows of a half-edge form a list, sorted and disjoint. Propagated windows
// stay in it for trimming those that come later.

#ifndef GEODESIC_RULES_MMP_RULE_H_
#define GEODESIC_RULES_MMP_RULE_H_

#include <algorithm>
#include <cstdint>
#include <vector>

#include "rules/front.h"
#include "rules/trimming.h"
#include "windows/window.h"
#include "windows/window_pool.h"

namespace geodesic {

template <WindowQueue Queue>
class MmpRule {
 public:
  explicit MmpRule(Front<Queue>& front)
      : front_(front),
        mesh_(front.mesh()),
        first_(front.mesh().half_edge_count(), kNothing) {}

  // Adds the window of pseudo-source v over a whole half-edge.
  void Open(HalfEdge half_edge, uint32_t v, const Origin& origin) {
    Insert(half_edge, v, origin, {0, mesh_.frame(half_edge).length});
  }

  // Propagates what is left of window `id` across its face. False if nothing
  // is: the window was void, or its pseudo-source has improved since.
  bool Propagate(uint32_t id);

  void PrefetchWindow(uint32_t id) const { pool_.Prefetch(id); }
  void PrefetchFace(uint32_t id) const {
    const HalfEdge h = pool_[id].half_edge;
    __builtin_prefetch(&mesh_.frame(h));
    __builtin_prefetch(&mesh_.triangles()[h / 3]);
  }

  uint64_t created() const { return created_; }
  uint64_t peak_windows() const { return pool_.peak(); }
  uint64_t bytes() const {
    return pool_.bytes() + first_.capacity() * sizeof(uint32_t);
  }

 private:
  enum State : uint32_t {
    kQueued,
    kPropagated,  // in its list only
    kVoid,        // in the queue only: nothing of it is left
  };

  struct Window {
    Interval interval;
    Origin origin;
    HalfEdge half_edge;
    uint32_t pseudo_source;
    uint32_t next;  // on the half-edge; kNothing at the end
    State state;
  };
  static_assert(sizeof(Window) == 56);

  // Adds a window, as far as it beats those on the half-edge already.
  void Insert(HalfEdge half_edge, uint32_t pseudo_source, const Origin& origin,
              Interval interval);
  // Makes a window and links it in at *link; returns where the next link is.
  uint32_t LinkBehind(uint32_t previous, const Window& window, bool queue);
  void Unlink(uint32_t previous, uint32_t id);
  uint32_t& LinkOf(HalfEdge half_edge, uint32_t previous) {
    return previous == kNothing ? first_[half_edge] : pool_[previous].next;
  }

  void Cross(const Window& window);

  Front<Queue>& front_;
  const Mesh& mesh_;
  WindowPool<Window> pool_;
  std::vector<uint32_t> first_;  // one per half-edge
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
  Cross(Window(window));  // a copy: children may move the pool
  return true;
}

template <WindowQueue Queue>
void MmpRule<Queue>::Cross(const Window& window) {
  const auto& [interval, origin, h, pseudo_source, next, state] = window;
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
                : right_length - ProjectRight(origin, interval.begin, frame,
                                              right_length),
            right_length -
                ProjectRight(origin, interval.end, frame, right_length)});
  }
}

template <WindowQueue Queue>
void MmpRule<Queue>::Insert(HalfEdge half_edge, uint32_t pseudo_source,
                            const Origin& origin, Interval interval) {
  const double least_width = kLeastWidth * mesh_.frame(half_edge).length;
  if (interval.width() <= least_width) return;
  Window window{interval, origin, half_edge, pseudo_source, kNothing, kQueued};

  uint32_t previous = kNothing;
  uint32_t at = first_[half_edge];
  while (at != kNothing && pool_[at].interval.end <= interval.begin) {
    previous = at;
    at = pool_[at].next;
  }
  // What the new window has won so far ends at `won_until`, and began at
  // `won_from`; it is put down when an older window keeps a part.
  double won_from = interval.begin;
  const auto put_down = [&](double won_until) {
    window.interval = {won_from, won_until};
    if (window.interval.width() > least_width) {
      previous = LinkBehind(previous, window, true);
    }
  };
  while (at != kNothing && pool_[at].interval.begin < interval.end) {
    const Window older = pool_[at];
    const Interval overlap{std::max(older.interval.begin, interval.begin),
                           std::min(older.interval.end, interval.end)};
    Contest contest = Contend(older.origin, origin, overlap);
    // The part of the overlap that the new window wins.
    Interval won = overlap;
    switch (contest.outcome) {
      case Contest::kOlderWins:
        won.end = won.begin;
        break;
      case Contest::kNewerWins:
        break;
      case Contest::kNewerBefore:
        won.end = contest.crossing;
        break;
      case Contest::kNewerAfter:
        won.begin = contest.crossing;
        break;
    }
    if (won.width() <= 0) {  // the older window keeps everything
      put_down(overlap.begin);
      won_from = overlap.end;
      previous = at;
      at = older.next;
      continue;
    }
    const Interval before{older.interval.begin, won.begin};
    const Interval after{won.end, older.interval.end};
    const bool keeps_before = before.width() > least_width;
    const bool keeps_after = after.width() > least_width;
    if (won.begin > overlap.begin) {
      put_down(overlap.begin);
      won_from = won.begin;
    }
    if (keeps_before) {
      pool_[at].interval = before;
      previous = at;
      if (keeps_after) {
        // Won in the middle, or at one end with the older reaching beyond.
        put_down(won.end);
        won_from = overlap.end;
        Window rest = older;
        rest.interval = after;
        previous = LinkBehind(previous, rest, older.state == kQueued);
      }
    } else if (keeps_after) {
      pool_[at].interval = after;
      put_down(won.end);
      won_from = overlap.end;
      previous = at;
    } else {
      Unlink(previous, at);
    }
    at = LinkOf(half_edge, previous);
  }
  put_down(interval.end);
}

template <WindowQueue Queue>
uint32_t MmpRule<Queue>::LinkBehind(uint32_t previous, const Window& window,
                                    bool queue) {
  const uint32_t id = pool_.Allocate(window);
  uint32_t& link = LinkOf(window.half_edge, previous);
  pool_[id].next = link;
  link = id;
  if (queue) {
    ++created_;
    front_.queue().Push(id, Label(window.origin, window.interval));
  }
  return id;
}

template <WindowQueue Queue>
void MmpRule<Queue>::Unlink(uint32_t previous, uint32_t id) {
  Window& window = pool_[id];
  LinkOf(window.half_edge, previous) = window.next;
  if (window.state == kQueued) {
    window.state = kVoid;
    front_.queue().MarkVoid();
  } else {
    pool_.Free(id);
  }
}

}  // namespace geodesic

#endif  // GEODESIC_RULES_MMP_RULE_H_
