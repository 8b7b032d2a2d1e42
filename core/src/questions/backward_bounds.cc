#include "questions/backward_bounds.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geodesic/query.h"
#include "solver/queues/queue.h"
#include "solver/rules/anchor_seeding.h"
#include "solver/start_computation.h"
#include "surface/anchors.h"
#include "tolerances.h"

namespace geodesic {
namespace {

// Tighter bounds cost more windows than they save, looser ones save none.
constexpr double kTolerance = 1e-3;

constexpr SolveOptions kOptions{.bucket_width = 16, .max_batch = 64};

// As MergedComputation: more come of windows that wind.
constexpr uint64_t kMostByVertex = 48;
constexpr uint64_t kFew = 4096;

// By how much a bound from landmarks may differ along an edge by more than its
// length: distances and bounds are whole steps, each rounded down.
constexpr double kLandmarkSteps = 4;

}  // namespace

BackwardBounds::BackwardBounds(const Mesh& mesh)
    : queue_(*TuningFor(mesh, kOptions)),
      front_(mesh, Query{}, queue_, nullptr, Goal(mesh),
             WithinTolerance(kTolerance)),
      rule_(front_),
      hubs_(front_, rule_) {}

absl::Status BackwardBounds::Find(const BoundedWay& way,
                                  const Landmarks* landmarks,
                                  absl::FunctionRef<absl::Status()> poll) {
  rule_.Clear();
  hubs_.Clear();
  queue_.Clear();
  front_.Restart({.targets = {way.source}});
  Goal& goal = front_.goal();
  goal.Aim(way.source, landmarks);
  goal.set_orders_by_label(true);
  // What leads to a vertex within the limit is within it as well, if bounds
  // agree along edges.
  const double steps_off =
      landmarks != nullptr ? kLandmarkSteps * landmarks->step() : 0;
  covered_ = way.longest * (1 + kGoalMargin);
  goal.set_limit(covered_ * (1 + kGoalMargin) + steps_off);
  longest_ = std::numeric_limits<double>::infinity();
  has_bounds_ = false;
  windows_ = 0;
  DirectSink sink(front_, rule_);
  AddAnchor(front_, {.begin = way.target, .end = way.target}, sink);
  uint64_t steps = 0;
  for (;;) {
    if (!hubs_.empty()) {
      steps += hubs_.GoOn();
    } else {
      PopTogether(queue_, rule_.most_together(), together_);
      if (together_.empty()) break;
      steps += together_.size();
      std::erase_if(together_, [this](uint32_t id) { return hubs_.Take(id); });
      const uint64_t windows = rule_.Propagate(together_);
      windows_ += windows;
      steps += windows;
    }
    if (steps < kWorkBetweenPolls) continue;
    steps = 0;
    if (absl::Status status = poll(); !status.ok()) return status;
    if (windows_ > kMostByVertex * front_.reached() + kFew) return poll();
  }
  has_bounds_ = true;
  const double found = FoundAtSource();
  if (std::isfinite(found)) {
    longest_ = found + front_.AccountOf(front_.targets().AccountHolder(
                           0, front_.distances()));
  }
  return poll();
}

double BackwardBounds::FoundAtSource() const {
  return front_.targets().Distance(0, front_.distances());
}

double BackwardBounds::shortest() const {
  return std::min(FoundAtSource(), covered_) * (1 - kGoalMargin);
}

double BackwardBounds::Bound(uint32_t v) const {
  // A vertex that no path within the limit leads through may not be reached, or
  // not by the shortest way.
  const double beyond = covered_ - front_.goal().Bound(v);
  const double bound = std::min(front_.distance(v), beyond);
  return bound * (1 - kGoalMargin);
}

}  // namespace geodesic
