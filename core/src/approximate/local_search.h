// The vertices around a vertex, with their exact distances, at a cost that goes
// with what is covered.

#ifndef GEODESIC_APPROXIMATE_LOCAL_SEARCH_H_
#define GEODESIC_APPROXIMATE_LOCAL_SEARCH_H_

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "geodesic/mesh.h"
#include "solver/goal.h"
#include "solver/queues/queue.h"
#include "solver/rules/anchor_seeding.h"
#include "solver/rules/expansion.h"
#include "solver/rules/front.h"
#include "solver/rules/hub.h"
#include "solver/windows/window.h"
#include "solver/work_meter.h"
#include "surface/anchors.h"

namespace geodesic {

// Windows made by Rule, in the order of Queue. For one thread.
template <template <typename> typename Rule, typename Queue>
class LocalSearch {
 public:
  // The mesh outlives it.
  LocalSearch(const Mesh& mesh, const Tuning& tuning)
      : mesh_(mesh),
        queue_(tuning),
        front_(mesh, Query{.trace = true}, queue_, nullptr, NearGoal()),
        rule_(MakeRule(front_)),
        hubs_(front_, rule_) {}

  // A vertex and its distance in the scaled unit.
  struct Near {
    uint32_t vertex;
    double distance;
    bool is_direct;  // no path bends at a vertex on the way
  };

  // The `count` vertices nearest to v, or all that paths lead to if there are
  // fewer, v not among them; at a tie the lower number is nearer. Nothing once
  // is_stopped(), which is asked now and then, says so.
  template <typename IsStopped>
  std::span<const Near> Around(uint32_t v, uint32_t count,
                               IsStopped is_stopped) {
    front_.Restart(query_);
    front_.goal().set_limit(std::numeric_limits<double>::infinity());
    DirectSink sink(front_, rule_);
    AddAnchor(front_, {VertexPoint{v}, VertexPoint{v}, false, 0, 0}, sink);
    near_.clear();
    bool was_stopped = false;
    uint64_t steps = 0;
    while (!hubs_.empty() || queue_.SettledRadius() <= front_.goal().limit()) {
      const uint64_t taken = Step();
      if (taken == 0) break;
      LowerLimit(count);
      steps += taken;
      if (steps >= kStopPeriod) {
        steps = 0;
        was_stopped = is_stopped();
        if (was_stopped) break;
      }
    }
    if (!was_stopped) Collect(v, count);
    Clear();
    return near_;
  }

  uint64_t bytes() const {
    return front_.bytes() + rule_.bytes() + queue_.bytes() + hubs_.bytes();
  }

 private:
  using FrontType = Front<Queue, Origin, NearGoal>;
  using RuleType = Rule<FrontType>;
  static constexpr bool kTogether =
      requires(RuleType & rule, std::span<const uint32_t> ids) {
    rule.Propagate(ids);
  };
  // Steps between two questions whether to stop: some tenths of a millisecond.
  static constexpr uint64_t kStopPeriod = 1024;

  static RuleType MakeRule(FrontType& front) {
    if constexpr (kTogether) {
      return RuleType(front, 1);
    } else {
      return RuleType(front);
    }
  }

  // Propagates what the queue gives next. Returns how many steps that were: 0
  // if nothing is left.
  uint64_t Step() {
    const uint64_t before = rule_.steps();
    if (!hubs_.empty()) {
      const uint64_t faces = hubs_.GoOn();
      return std::max(faces, rule_.steps() - before);
    }
    uint64_t steps = 1;
    if constexpr (kTogether) {
      PopTogether(queue_, rule_.most_together(), together_);
      if (together_.empty()) return 0;
      std::erase_if(together_, [this](uint32_t id) { return hubs_.Take(id); });
      for (const uint32_t id : together_) steps += StepsOf(mesh_, id);
      rule_.Propagate(together_);
    } else {
      const uint32_t id = queue_.Pop();
      if (id == kNothing) return 0;
      steps = StepsOf(mesh_, id);
      if (hubs_.Take(id)) return 1;
      if (id & kVertexEvent) {
        const uint32_t v = id & ~kVertexEvent;
        DirectSink sink(front_, rule_);
        if (front_.TakeEvent(v)) Expand(front_, v, sink);
      } else {
        rule_.Propagate(id);
      }
    }
    return std::max(steps, rule_.steps() - before);
  }

  // To the distance of the vertex that is the last wanted so far. Distances
  // only become smaller, so nothing beyond it is ever wanted.
  void LowerLimit(uint32_t count) {
    const std::span<const uint32_t> reached = front_.reached_list();
    // The source is among them.
    if (reached.size() <= count || reached.size() == reached_before_) return;
    reached_before_ = reached.size();
    distances_.clear();
    for (const uint32_t v : reached) {
      distances_.push_back(front_.distance(v));
    }
    std::nth_element(distances_.begin(), distances_.begin() + count,
                     distances_.end());
    front_.goal().set_limit(std::min(front_.goal().limit(), distances_[count]));
  }

  void Collect(uint32_t v, uint32_t count) {
    for (const uint32_t w : front_.reached_list()) {
      if (w == v || front_.distance(w) > front_.goal().limit()) continue;
      near_.push_back(
          {w, front_.distance(w), front_.arrivals()[w].pseudo_source == v});
    }
    std::ranges::sort(near_, [](const Near& a, const Near& b) {
      return a.distance != b.distance ? a.distance < b.distance
                                      : a.vertex < b.vertex;
    });
    if (near_.size() > count) near_.resize(count);
  }

  void Clear() {
    if constexpr (kTogether) {
      rule_.Clear();
      queue_.Clear();
    } else {
      for (uint32_t id; (id = queue_.Pop()) != kNothing;) {
        if (!(id & kVertexEvent)) rule_.Drop(id);
      }
      queue_.Restart();
      rule_.Clear();
    }
    hubs_.Clear();
    reached_before_ = 0;
  }

  const Mesh& mesh_;
  const Query query_{.trace = true};
  Queue queue_;
  FrontType front_;
  RuleType rule_;
  Hubs<FrontType, RuleType> hubs_;
  std::vector<uint32_t> together_;
  std::vector<double> distances_;  // scratch
  size_t reached_before_ = 0;
  std::vector<Near> near_;
};

}  // namespace geodesic

#endif  // GEODESIC_APPROXIMATE_LOCAL_SEARCH_H_
