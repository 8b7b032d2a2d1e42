// Parallel Chen-Han: windows that have crossed as many faces cross the next one
// together, in all threads, and nothing orders them.
//
// Ying, Xin, He: Parallel Chen-Han (PCH) algorithm for discrete geodesics. ACM
// TOG 33(1), 2014.
//
//   Ying et al.     here
//   level           what one call of Propagate is given
//   propagation     Meet, then Leave: sweeps over a level in all threads
//   vertex updates  between the two, in one thread and in order
//
// Whether a window has one child or two is decided when the whole level has met
// its apexes, so a level's better windows count for all of it. What comes of a
// sweep is applied in the order of the windows, not of the threads: the bits do
// not depend on their number. Distances are exact like those of every order
// (Xu et al. 2015, Proposition 1); but without a queue most windows are made
// before better ones are known, so their number, and memory, have no useful
// bound. The filter of Xin and Wang takes out those that prove useless in time.

#ifndef GEODESIC_SOLVER_RULES_PCH_RULE_H_
#define GEODESIC_SOLVER_RULES_PCH_RULE_H_

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "geodesic/distance_field.h"
#include "geodesic/mesh.h"
#include "solver/queues/queue.h"
#include "solver/rules/chen_han_crossing.h"
#include "solver/rules/expansion.h"
#include "solver/rules/front.h"
#include "solver/rules/shadow_fan.h"
#include "solver/thread_team.h"
#include "solver/windows/window.h"
#include "solver/windows/window_pool.h"

namespace geodesic {

// REQUIRES: the front's origins are points.
template <typename Front>
class PchRule {
 public:
  // Of a level, between two polls: a few hundredths of a second.
  static constexpr size_t most_together() { return size_t{1} << 16; }

  PchRule(Front& front, uint32_t threads)
      : front_(front),
        mesh_(front.mesh()),
        threads_(threads),
        best_(front.mesh().half_edge_count()) {}

  // Adds a pseudo-source's window over what it sees of a half-edge.
  void Open(HalfEdge half_edge, uint32_t pseudo_source, const Origin& origin,
            const Interval& interval) {
    if (interval.width() > 0) {
      Add({interval, origin, half_edge, pseudo_source});
    }
  }

  // Sources were added: windows of other anchors may have been the best.
  void Restart() { std::ranges::fill(best_, BestAtApex()); }

  // Ends the threads; the next level starts others.
  void ReleaseThreads() { team_.reset(); }

  // Takes a level, or a part of one, across its faces, and expands its vertices
  // (numbers with kVertexEvent). Returns how many windows were propagated.
  uint64_t Propagate(std::span<const uint32_t> ids) {
    level_.clear();
    for (const uint32_t id : ids) {
      if (id & kVertexEvent) continue;
      level_.push_back(pool_[id]);
      pool_.Free(id);
    }
    DirectSink sink(front_, *this);
    for (const uint32_t id : ids) {
      const uint32_t v = id & ~kVertexEvent;
      if ((id & kVertexEvent) && front_.TakeEvent(v)) Expand(front_, v, sink);
    }
    Sweep([this](Share& share) { Meet(share); });
    uint64_t propagated = 0;
    for (Share& share : shares_) {
      for (const Relaxation& r : share.relaxations) {
        front_.Relax(r.vertex, r.distance, r.arrival, r.ray);
      }
      propagated += share.met.size();
      for (const Met& met : share.met) RememberBest(met);
    }
    Sweep([this](Share& share) { Leave(share); });
    for (Share& share : shares_) {
      for (const ChenHanWindow& child : share.children) Add(child);
    }
    return propagated;
  }

  uint64_t created() const { return created_; }
  // What was done.
  uint64_t steps() const { return created_; }
  uint64_t pending() const { return pool_.live(); }
  uint64_t peak_windows() const { return pool_.peak(); }
  uint64_t bytes() const {
    uint64_t bytes = pool_.bytes() + level_.capacity() * sizeof(ChenHanWindow) +
                     best_.capacity() * sizeof(BestAtApex);
    for (const Share& share : shares_) {
      bytes += share.met.capacity() * sizeof(Met) +
               share.relaxations.capacity() * sizeof(Relaxation) +
               share.children.capacity() * sizeof(ChenHanWindow);
    }
    return bytes;
  }

 private:
  // Windows that a thread takes at a time: some tens of microseconds.
  static constexpr size_t kShare = 256;

  struct Met {
    ChenHanWindow window;
    ApexMeeting meeting;
  };
  struct Relaxation {
    uint32_t vertex;
    double distance;
    Arrival arrival;
    IncomingRay ray;
  };
  // A part of a level, and what came of it.
  struct Share {
    std::span<const ChenHanWindow> windows;
    std::vector<Met> met;  // the useful ones
    std::vector<Relaxation> relaxations;
    std::vector<ChenHanWindow> children;
  };

  // Calls do_share for every share of the level, in all threads.
  template <typename DoShare>
  void Sweep(DoShare do_share) {
    const size_t count = (level_.size() + kShare - 1) / kShare;
    shares_.resize(count);
    if (count > 1 && threads_ > 1 && !team_.has_value())
      team_.emplace(threads_);
    std::atomic<size_t> next = 0;
    const auto work = [&](uint32_t) {
      for (size_t i; (i = next.fetch_add(1)) < count;) {
        const size_t first = i * kShare;
        shares_[i].windows = std::span(level_).subspan(
            first, std::min(kShare, level_.size() - first));
        do_share(shares_[i]);
      }
    };
    if (count > 1 && team_.has_value()) {
      team_->Run(work);
    } else {
      work(0);
    }
  }

  // Takes the windows to their apexes, with the distances before the level.
  void Meet(Share& share) {
    share.met.clear();
    share.relaxations.clear();
    for (const ChenHanWindow& window : share.windows) {
      const HalfEdge h = window.half_edge;
      // Useless by now, as in ch_rule.h.
      if (Exceeds(window.origin.sigma,
                  front_.PseudoSourceDistance(window.pseudo_source)) ||
          front_.EndsAreNearer(Window::Over(window.interval, window.origin),
                               mesh_.frame(h).length, mesh_.From(h),
                               mesh_.To(h))) {
        continue;
      }
      share.met.push_back(
          {window,
           MeetApex(
               front_, window,
               [&](uint32_t vertex, double distance, const Arrival& arrival,
                   const IncomingRay& ray) {
                 share.relaxations.push_back({vertex, distance, arrival, ray});
               })});
    }
  }

  void RememberBest(const Met& met) {
    BestAtApex& best = best_[met.window.half_edge];
    if (met.meeting.distance < best.distance &&
        !front_.MayBePassedBy(met.window.pseudo_source)) {
      best = {met.meeting.distance, met.meeting.lean};
    }
  }

  // Makes the children, with the distances after the level.
  void Leave(Share& share) {
    share.children.clear();
    for (const Met& met : share.met) {
      const ChenHanWindow& window = met.window;
      const auto emit = [&](HalfEdge half_edge, const Window& child) {
        share.children.push_back(
            {child.interval, child.origin, half_edge, window.pseudo_source});
      };
      const double at = met.meeting.crossing;
      const BestAtApex& best = best_[window.half_edge];
      const bool is_through =
          at > window.interval.begin && at < window.interval.end;
      if (is_through ? met.meeting.goes_left(best)
                     : at >= window.interval.end) {
        LeaveAcross<kLeft, true>(front_, window, at, emit);
      }
      if (is_through ? met.meeting.goes_right(best)
                     : at <= window.interval.begin) {
        LeaveAcross<kRight, true>(front_, window, at, emit);
      }
    }
  }

  void Add(const ChenHanWindow& window) {
    ++created_;
    const Window whole = Window::Over(window.interval, window.origin);
    front_.Observe(window.half_edge, whole, window.pseudo_source);
    front_.queue().Push(pool_.Allocate(window), whole.Label());
  }

  Front& front_;
  const Mesh& mesh_;
  const uint32_t threads_;
  std::optional<ThreadTeam> team_;
  WindowPool<ChenHanWindow> pool_;
  std::vector<BestAtApex> best_;      // by half-edge
  std::vector<ChenHanWindow> level_;  // that crosses now
  std::vector<Share> shares_;         // of the level
  uint64_t created_ = 0;
};

}  // namespace geodesic

#endif  // GEODESIC_SOLVER_RULES_PCH_RULE_H_
