// The rule of Mitchell, Mount and Papadimitriou: windows on a half-edge are
// trimmed against each other, so that every point of it belongs to the one
// window that reaches it soonest.
//
// Mitchell, Mount, Papadimitriou: The discrete geodesic problem. SIAM J.
// Comput. 16(4), 1987. Windows as in Surazhsky et al.: Fast exact and
// approximate geodesics on meshes. ACM TOG 24(3), 2005.
//
//   paper                  here
//   interval of            ListedWindow   in lists_, along its half-edge; the
//   optimality                            symbols of a window are in window.h
//   candidate interval     newer          arrives, and meets
//                          older, next    those that are there
//                          won            where the newer is nearer
//                          held_from      where what it holds so far begins
//
// The queue orders half-edges. One that is strict about labels takes windows
// one by one, as MMP does, and has an entry for each. Any other takes all
// pending windows of a half-edge together, which any order permits (Xu et al.
// 2015, Proposition 1): they cross the face together (FaceCrossing), trim each
// other before they meet those that are on the next half-edge already, and what
// meets nobody there is added as it is, run by run.
//
// The windows of a half-edge are disjoint. Propagated ones stay in its list, to
// trim those that come later, until the wavefront has passed the edge: then
// whatever came would lose all of it, and the list is dropped. Memory thus goes
// with the wavefront, not with the mesh.

#ifndef GEODESIC_SOLVER_RULES_MMP_RULE_H_
#define GEODESIC_SOLVER_RULES_MMP_RULE_H_

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>

#include "mesh/prefetch.h"
#include "solver/rules/crossing_counter.h"
#include "solver/rules/face_crossing.h"
#include "solver/rules/front.h"
#include "solver/rules/wide_edges.h"
#include "solver/rules/winding.h"
#include "solver/trimming/fragments.h"
#include "solver/trimming/trimming.h"
#include "solver/windows/window.h"
#include "solver/windows/window_columns.h"
#include "solver/windows/window_lists.h"

namespace geodesic {

template <typename Front>
class MmpRule {
 public:
  using Queue = typename Front::Queue;
  using Origin = typename Front::Origin;
  using Window = BasicWindow<Origin>;
  using ListedWindow = BasicListedWindow<Origin>;

  // How many half-edges ahead of their use the stages of Prefetch come.
  static constexpr std::array<uint32_t, 4> kPrefetchAhead = {8, 6, 4, 2};

  explicit MmpRule(Front& front)
      : front_(front),
        mesh_(front.mesh()),
        lists_(front.mesh().half_edge_count()),
        crossing_counts_(front.mesh().half_edge_count()),
        crossing_(front) {}

  // Adds a pseudo-source's window over what it sees of a half-edge.
  void Open(HalfEdge half_edge, uint32_t pseudo_source, const Origin& origin,
            const Interval& interval) {
    Insert(half_edge, pseudo_source, origin, interval);
  }

  // The same beyond `side`, an edge of very many faces: by and by (Spread).
  static constexpr bool kTakesWideEdges = !Front::Goal::kDirects;
  void OpenBeyond(HalfEdge side, uint32_t pseudo_source, const Origin& origin,
                  const Interval& interval) {
    wide_.Add(side, {pseudo_source, origin, interval});
    // The queue knows of it, too.
    const HalfEdge first = mesh_.HalfEdgesAt(side)[0];
    front_.queue().Push(first, Window::Over(interval, origin).Label());
  }
  // Whether windows are to go on across edges of very many faces, before
  // anything else is done.
  bool HasToSpread() const { return !wide_.IsEmpty(); }
  // Lets the first of them go on into some of the faces.
  void Spread() {
    wide_.Spread(
        mesh_, kSpreadAtATime,
        [this](HalfEdge side, HalfEdge to, bool is_mirrored, const Wide& wide) {
          ++steps_;
          if (!front_.MayEnter(side, to)) return;
          const double length = mesh_.frame(side).length;
          if (is_mirrored) {
            Insert(to, wide.pseudo_source, Mirror(wide.origin, length),
                   Mirror(wide.interval, length));
          } else {
            Insert(to, wide.pseudo_source, wide.origin, wide.interval);
          }
        },
        [](const Wide&) {});
  }

  // Sources were added: nothing here depends on them.
  void Restart() {}

  // Propagates the windows of half-edge `h` that are due across its face.
  // Returns how many: none if they have been trimmed to nothing, propagated by
  // another entry of `h`, or if their pseudo-source has improved since.
  uint32_t Propagate(HalfEdge h) {
    const bool ends =
        mesh_.IsCopy(h) ||
        crossing_counts_.Count(h, front_.reached()) >=
            kWindowsAtATime * MostCrossings(mesh_, front_.anchor_count());
    if constexpr (Queue::kStrict) {
      const double due = front_.queue().popped_label();
      return ends ? Drop(h, due, 1) : PropagateOneByOne(h, due, 1);
    } else {
      if (lists_.queued(h) == kPropagated) return 0;
      lists_.set_queued(h, kPropagated);
      if (ends) return Drop(h, kAnyLabel, kAll);
      if constexpr (kTogether) {
        if (!mesh_.HasCollapsedFaces()) return PropagateTogether(h);
      }
      return PropagateOneByOne(h, kAnyLabel, kAll);
    }
  }

  // Fetches into cache what propagating `h` will need. Each stage needs what
  // the one before has fetched.
  void Prefetch(HalfEdge h, size_t stage) const {
    switch (stage) {
      case 0:
        lists_.PrefetchHead(h);
        PrefetchFace(mesh_, h);
        break;
      case 1:
        lists_.PrefetchList(h);
        front_.PrefetchCorners(h);
        break;
      case 2:
        ForEachExit(h, [&](HalfEdge exit) { lists_.PrefetchHead(exit); });
        break;
      default:
        ForEachExit(h, [&](HalfEdge exit) { lists_.PrefetchCursor(exit); });
    }
  }

  uint64_t created() const { return created_; }
  // Windows that came to a half-edge, and that were compared there.
  uint64_t steps() const { return steps_; }
  uint64_t pending() const { return pending_; }
  uint64_t windows() const { return lists_.size(); }
  uint64_t peak_windows() const { return lists_.peak_size(); }
  uint64_t bytes() const {
    return lists_.bytes() + listed_.capacity() * sizeof(HalfEdge) +
           due_.capacity() * sizeof(ListedWindow) + crossing_counts_.bytes();
  }

 private:
  // What goes on across an edge of very many faces.
  struct Wide {
    uint32_t pseudo_source;
    Origin origin;
    Interval interval;
  };

  // Faces beyond an edge of very many that are entered at once.
  static constexpr size_t kSpreadAtATime = 256;

  // Sweeps come when the lists have doubled, so each window pays for one visit;
  // below this many windows there is little to gain.
  static constexpr uint64_t kLeastSweep = 16384;

  // With a strict queue each window crosses by itself; otherwise those of a
  // half-edge cross together.
  static constexpr uint64_t kWindowsAtATime = Queue::kStrict ? 64 : 1;

  static constexpr double kAnyLabel = std::numeric_limits<double>::max();
  static constexpr size_t kAll = std::numeric_limits<size_t>::max();

  // Whether windows may cross faces together.
  static constexpr bool kTogether =
      !Queue::kStrict && std::is_same_v<Origin, geodesic::Origin>;

  // The first windows with labels up to `due`, `most` at the most, go no
  // farther. Returns that none was propagated.
  uint32_t Drop(HalfEdge h, double due, size_t most) {
    lists_.TakeDue(h, due, most, [this](const ListedWindow&) { --pending_; });
    return 0;
  }

  // As Propagate: the first windows with labels up to `due`, `most` at the
  // most.
  uint32_t PropagateOneByOne(HalfEdge h, double due, size_t most) {
    due_.clear();  // copies: lists will move
    lists_.TakeDue(h, due, most, [this](const ListedWindow& listed) {
      due_.push_back(listed);
    });
    pending_ -= due_.size();
    winding_.Count(due_.size(), 0);
    uint32_t propagated = 0;
    for (const ListedWindow& listed : due_) {
      if (IsStale(h, listed)) continue;
      Cross(h, listed.window, listed.pseudo_source);
      ++propagated;
    }
    return propagated;
  }

  // All of them.
  uint32_t PropagateTogether(HalfEdge h) {
    WindowColumns& list = crossing_.list();
    list.size = 0;
    list.Reserve(lists_.size(h));
    lists_.TakeDue(h, kAnyLabel, kAll, [&](const ListedWindow& listed) {
      --pending_;
      if (IsStale(h, listed)) return;
      list.Set(list.size++, listed.window, listed.pseudo_source);
    });
    if (list.size == 0) return 0;
    winding_.Count(list.size, 0);
    crossing_.Cross(
        h,
        [this](uint32_t apex, double distance, const Arrival& arrival,
               const IncomingRay& ray) {
          front_.Relax(apex, distance, arrival, ray);
        },
        [this](HalfEdge side, Exit exit, WindowColumns& children,
               double label) {
          if (exit < kIrregularExit) {
            DropWinding(exit, children);
            InsertAll(exit, children, label);
            return;
          }
          for (size_t i = 0; i < children.size; ++i) {
            InsertBeyond(side, exit, children.pseudo_source[i],
                         children.OriginAt(i),
                         {children.begin[i], children.end[i]});
          }
        });
    return static_cast<uint32_t>(list.size);
  }

  void DropWinding(HalfEdge half_edge, WindowColumns& windows) {
    if (!crossing_counts_.IsMany(half_edge)) return;
    windows.KeepIf(0,
                   [&](size_t i) { return !Winds(half_edge, windows.At(i)); });
  }
  // Whether a window that enters the face of `half_edge` is known to come back
  // there (winding.h).
  bool Winds(HalfEdge half_edge, const Window& window) {
    if constexpr (std::is_same_v<Origin, geodesic::Origin>) {
      if (!crossing_counts_.IsMany(half_edge) || !winding_.MayLook())
        return false;
      uint64_t followed = 0;
      const bool comes_back = ComesBack(mesh_, half_edge, window, followed);
      winding_.Count(0, followed);
      return comes_back;
    } else {
      return false;
    }
  }

  // Adds windows that have trimmed each other; no label among them is below.
  void InsertAll(HalfEdge half_edge, const WindowColumns& windows,
                 double label) {
    for (size_t i = 0; i < windows.size;) {
      lists_.Seek(half_edge, windows.begin[i]);
      // Those that end before the next window there meet nobody.
      size_t last = windows.size;
      if (const ListedWindow* next = lists_.Next(half_edge)) {
        const double held_from = next->window.interval.begin;
        last = i;
        while (last < windows.size && windows.end[last] <= held_from) ++last;
      }
      if (last == i) {
        Contest(half_edge, windows.pseudo_source[i], windows.At(i));
        ++i;
        continue;
      }
      if (!lists_.has_room(half_edge)) listed_.push_back(half_edge);
      created_ += last - i;
      steps_ += last - i;
      pending_ += last - i;
      lists_.MakeRoom(half_edge, static_cast<uint32_t>(last - i));
      for (; i < last; ++i) {
        lists_.Add(half_edge, {windows.At(i), windows.pseudo_source[i]}, label);
        front_.Observe(half_edge, windows.At(i), windows.pseudo_source[i]);
      }
      Enqueue(half_edge, label);
    }
    if (lists_.size() >= next_sweep_) Sweep();
  }

  // Inserts a window that leaves its face across `side` in every face beyond.
  void InsertBeyond(HalfEdge side, Exit exit, uint32_t pseudo_source,
                    const Origin& origin, Interval interval) {
    const HalfEdgeFrame& frame = mesh_.frame(side);
    // What winds round faces without area would add it piece by piece.
    if (mesh_.HasCollapsedFaces() && SeesAllOfEdge(origin, interval, frame)) {
      interval = {0, frame.length};
    }
    if (exit < kIrregularExit) {
      Insert(exit, pseudo_source, origin, interval);
      return;
    }
    if (kTakesWideEdges && IsWideEdge(mesh_, side)) {
      OpenBeyond(side, pseudo_source, origin, interval);
      return;
    }
    front_.Cross(
        side, origin, interval,
        [&](HalfEdge half_edge, const Origin& seen, const Interval& through) {
          Insert(half_edge, pseudo_source, seen, through);
        });
  }

  // Adds a window, as far as it beats those on the half-edge already.
  void Insert(HalfEdge half_edge, uint32_t pseudo_source, const Origin& origin,
              const Interval& interval) {
    ++steps_;
    // This saves a third of the contests on real meshes, and costs less.
    const auto newer = front_.UsefulWindow(half_edge, origin, interval);
    if (!newer.has_value() || Winds(half_edge, *newer)) return;
    Contest(half_edge, pseudo_source, *newer);
  }

  // The same for one that paths through the edge's ends leave a chance.
  void Contest(HalfEdge half_edge, uint32_t pseudo_source,
               const Window& newer) {
    const Interval& interval = newer.interval;
    const Origin& origin = newer.origin;
    const double length = mesh_.frame(half_edge).length;
    if (!lists_.has_room(half_edge)) listed_.push_back(half_edge);
    lists_.Seek(half_edge, interval.begin);
    const double slack =
        mesh_.HasCollapsedFaces()
            ? kLoopTie * (length + newer.begin_distance + newer.end_distance)
            : 0;

    // The new window holds [held_from, ...) until an older one keeps a part.
    double held_from = interval.begin;
    const auto put_down = [&](double held_until) {
      const Interval held{held_from, held_until};
      if (IsLost(held, origin, length)) return;
      ListedWindow part{newer, pseudo_source};
      part.window.CutTo(held);
      const double label = part.window.Label();
      if (slack == 0 && JoinFragment(half_edge, part, label)) return;
      lists_.Add(half_edge, part, label);
      ++created_;
      ++pending_;
      front_.Observe(half_edge, part.window, pseudo_source);
      Enqueue(half_edge, label);
    };
    while (const ListedWindow* next = lists_.Next(half_edge)) {
      ++steps_;
      const Interval held = next->window.interval;
      if (held.begin >= interval.end) break;
      const Interval overlap{std::max(held.begin, interval.begin),
                             std::min(held.end, interval.end)};
      if (front_.MayChangeOverTwice()) {
        if (const auto at = SplitBeforeContest(next->window, newer, slack)) {
          put_down(overlap.begin);
          Insert(half_edge, pseudo_source, origin, {overlap.begin, *at});
          Insert(half_edge, pseudo_source, origin, {*at, interval.end});
          return;
        }
      }
      const Interval won = WonByNewer(next->window, newer, slack);
      if (won.width() <= 0) {
        put_down(overlap.begin);
        held_from = overlap.end;
        lists_.Pass(half_edge);
        continue;
      }
      const Origin older = next->window.origin;  // `next` may move from here on
      if (won.begin > overlap.begin) {
        put_down(overlap.begin);
        held_from = won.begin;
      }
      const Interval before{held.begin, won.begin};
      const Interval after{won.end, held.end};
      const bool keeps_before = !IsLost(before, older, length);
      const bool keeps_after = !IsLost(after, older, length);
      // Trimming only raises labels: the one a window is queued with stays a
      // lower bound.
      const double label = lists_.NextLabel(half_edge);
      if (label != kPropagated) pending_ += keeps_before + keeps_after - 1;
      if (keeps_before) {
        ListedWindow part = *lists_.Next(half_edge);
        part.window.CutTo(before);
        lists_.Add(half_edge, part, label);
        // Both ends of a window in the queue are left: it counts twice now.
        if (keeps_after && label != kPropagated) {
          ++created_;
          Enqueue(half_edge, label);
        }
      }
      if (!keeps_after) {
        lists_.RemoveNext(half_edge);
        continue;
      }
      put_down(won.end);
      held_from = overlap.end;
      lists_.Next(half_edge)->window.CutTo(after);
      if (overlap.end == interval.end) break;
      lists_.Pass(half_edge);
    }
    put_down(interval.end);
    if (lists_.size() >= next_sweep_) Sweep();
  }

  // Joins a window that would be added before the cursor to another piece of
  // it, if only one that is tied with it parts them (fragments.h). What has
  // been propagated stays.
  bool JoinFragment(HalfEdge half_edge, const ListedWindow& part,
                    double label) {
    if (lists_.before(half_edge) < 2) return false;
    ListedWindow& whole = lists_.Previous(half_edge, 1);
    double& whole_label = lists_.PreviousLabel(half_edge, 1);
    const double between_label = lists_.PreviousLabel(half_edge, 0);
    if (whole.pseudo_source != part.pseudo_source ||
        whole_label == kPropagated || between_label == kPropagated ||
        !AreFragments(whole.window, lists_.Previous(half_edge, 0).window,
                      part.window, mesh_.frame(half_edge).length)) {
      return false;
    }
    whole.window.interval.end = part.window.interval.end;
    whole.window.end_distance = part.window.end_distance;
    whole_label = std::min({whole_label, between_label, label});
    lists_.RemovePrevious(half_edge);
    --pending_;
    front_.Observe(half_edge, whole.window, whole.pseudo_source);
    Enqueue(half_edge, whole_label);
    return true;
  }

  // Sees to it that a window of `half_edge` with this label will be due.
  void Enqueue(HalfEdge half_edge, double label) {
    if constexpr (!Queue::kStrict) {
      if (label >= lists_.queued(half_edge)) return;
      lists_.set_queued(half_edge, label);
    }
    front_.queue().Push(half_edge, label);
  }

  void Cross(HalfEdge h, const Window& window, uint32_t pseudo_source) {
    const Interval& interval = window.interval;
    const Origin& origin = window.origin;
    const HalfEdgeFrame& frame = mesh_.frame(h);
    const PlanePoint apex = ApexOf(frame);
    const double crossing = CrossingTo(origin, apex);
    // The point of the interval nearest to the ray through the apex; paths
    // through it to the apex are real, and straight if the ray is in there.
    const double through = std::clamp(crossing, interval.begin, interval.end);
    if (std::abs(through - crossing) <= NearMiss(origin, frame, apex)) {
      front_.Relax(mesh_.Apex(h), PathToPlace(origin, through, crossing, apex),
                   {pseudo_source, h, origin.x, origin.depth},
                   RayPast(mesh_, h, origin, std::abs(through - crossing)));
    }
    const auto leave = [&](const auto& side) {
      if (side.exit == kNoHalfEdge || !side.IsReached(interval, crossing))
        return;
      InsertBeyond(side.half_edge, side.exit, pseudo_source,
                   Unfold(side, origin),
                   side.InExit(side.Hit(origin, interval, crossing)));
    };
    leave(FaceSide<kLeft>(mesh_, h));
    leave(FaceSide<kRight>(mesh_, h));
  }

  // Drops the lists of all edges that the wavefront has passed.
  void Sweep() {
    std::erase_if(listed_, [&](HalfEdge h) {
      if (!front_.IsPassed(h)) return false;
      // What is pending is queued: with a strict queue one by one.
      if (Queue::kStrict || lists_.queued(h) != kPropagated) {
        pending_ -= lists_.Pending(h);
      }
      lists_.Drop(h);
      return true;
    });
    next_sweep_ = std::max(lists_.size() / 4 * 5, kLeastSweep);
  }

  // Whether the pseudo-source has improved so much since that its newer window
  // has won all that this one held. If it has improved by less, the newer one
  // has tied and given way. The measure is a bound on the distances at the
  // edge, since windows tie by those; sigma may be much smaller, right beside a
  // source.
  bool IsStale(HalfEdge h, const ListedWindow& listed) const {
    const double improved = listed.window.origin.sigma -
                            front_.PseudoSourceDistance(listed.pseudo_source);
    return improved > 0 &&
           improved > kDominance * (listed.window.begin_distance +
                                    mesh_.frame(h).length);
  }

  template <typename Visit>
  void ForEachExit(HalfEdge h, Visit visit) const {
    const HalfEdgeFrame& frame = mesh_.frame(h);
    if (frame.left_exit < kIrregularExit) visit(frame.left_exit);
    if (frame.right_exit < kIrregularExit) visit(frame.right_exit);
  }

  Front& front_;
  const Mesh& mesh_;
  WindowLists<Origin> lists_;
  std::vector<HalfEdge> listed_;  // with a list, since the last sweep
  WideEdges<Wide> wide_;
  uint64_t next_sweep_ = kLeastSweep;  // when so many windows are in lists
  std::vector<ListedWindow> due_;      // of Propagate, kept for its memory
  CrossingCounter crossing_counts_;
  WindingWatch winding_;
  FaceCrossing<Front> crossing_;  // if kTogether
  uint64_t pending_ = 0;
  uint64_t created_ = 0;
  uint64_t steps_ = 0;
};

}  // namespace geodesic

#endif  // GEODESIC_SOLVER_RULES_MMP_RULE_H_
