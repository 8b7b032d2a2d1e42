// The loop that drives a rule with a queue: every algorithm is this loop.

#ifndef GEODESIC_SOLVER_PROPAGATION_H_
#define GEODESIC_SOLVER_PROPAGATION_H_

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <deque>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "absl/strings/str_cat.h"
#include "geodesic/checkpoint.h"
#include "geodesic/computation.h"
#include "geodesic/distance_field.h"
#include "geodesic/mesh.h"
#include "geodesic/valid_query.h"
#include "geodesic_types/algorithms.h"
#include "geodesic_types/field_path.h"
#include "mesh/file_unit.h"
#include "solver/queues/queue.h"
#include "solver/rules/anchor_seeding.h"
#include "solver/rules/edge_relaxation.h"
#include "solver/rules/expansion.h"
#include "solver/rules/front.h"
#include "solver/rules/hub.h"
#include "solver/windows/window_observer.h"
#include "solver/work_meter.h"
#include "surface/anchors.h"

namespace geodesic {

// Solves the query with windows made by Rule, in the order of Queue.
// OriginType: MixedOrigin if the query has curves. Accuracy: WithinTolerance if
// the query has a tolerance, which takes the merging rule.
template <template <typename> typename Rule, WindowQueue Queue,
          typename OriginType = Origin, typename Accuracy = Exact>
class Propagation final : public Computation {
 public:
  Propagation(const Mesh& mesh, const ValidQuery& query, const Tuning& tuning,
              WindowObserver* observer)
      : algorithm_(query->algorithm),
        traces_(query->trace),
        next_source_(static_cast<uint32_t>(query->sources.size())),
        pending_anchors_(PendingAnchors(query)),
        queue_(tuning),
        front_(mesh, *query, queue_, observer, {}, AccuracyOf(*query)),
        rule_(MakeRule(front_, tuning)),
        hubs_(front_, rule_) {}

  absl::Status Advance(const Reach& reach, Checkpoint& checkpoint) override {
    if (!(reach.radius >= 0)) {
      return absl::InvalidArgumentError(
          absl::StrCat("reach.radius ", reach.radius, " is not a number >= 0"));
    }
    asked_radius_ = std::max(asked_radius_, reach.radius);
    const auto start = std::chrono::steady_clock::now();
    absl::Status status = Run(reach, checkpoint);
    if constexpr (kThreads) rule_.ReleaseThreads();
    statistics_.solve_seconds +=
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start)
            .count();
    return status;
  }

  DistanceField Field() const override {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    DistanceField field{.settled_radius = std::max(certified_radius_, 0.0),
                        .algorithm = algorithm_,
                        .statistics = statistics_};
    const auto certified = [&](double length) {
      const double distance = ToFileUnit(mesh(), length);
      return distance <= certified_radius_ ? distance : kInfinity;
    };
    const std::span<const double> distances = front_.distances();
    field.distances.resize(distances.size());
    std::ranges::transform(distances, field.distances.begin(), certified);
    const Targets& targets = front_.targets();
    for (size_t t = 0; t < targets.size(); ++t) {
      field.target_distances.push_back(
          certified(targets.Distance(t, distances)));
    }
    if constexpr (Accuracy::kMerges) MoveToAnswers(field);
    if (traces_) {
      field.arrivals.assign(front_.arrivals().begin(), front_.arrivals().end());
      for (size_t v = 0; v < field.arrivals.size(); ++v) {
        if (std::isinf(field.distances[v])) field.arrivals[v] = {};
      }
      for (size_t t = 0; t < targets.size(); ++t) {
        field.target_arrivals.push_back(
            std::isinf(field.target_distances[t])
                ? Arrival{}
                : targets.ArrivalAt(t, distances, field.arrivals));
      }
    }
    mesh().SpreadToJoined(field.distances);
    if constexpr (Accuracy::kMerges) {
      mesh().SpreadToJoined(field.certified_errors);
    }
    if (traces_) mesh().SpreadToJoined(field.arrivals);
    field.statistics.iterations = queue_.iterations();
    field.statistics.windows_created = rule_.created();
    field.statistics.peak_windows = rule_.peak_windows();
    field.statistics.mean_wavefront =
        wavefront_samples_ == 0
            ? 0
            : wavefront_sum_ / static_cast<double>(wavefront_samples_);
    return field;
  }

  absl::Status AddSource(const Source& source) override {
    if (!std::isinf(certified_radius_) || traces_) {
      return absl::FailedPreconditionError(
          "sources can be added to a computation that is complete and keeps no "
          "trace");
    }
    if (IsCurve(source)) {
      return InvalidField("sources[0].curve",
                          "sources[0].curve cannot be added: name a point");
    }
    const absl::StatusOr<ValidQuery> added = ValidQuery::Make(
        {.sources = {source}, .algorithm = algorithm_}, mesh());
    if (!added.ok()) return added.status();
    for (Anchor& anchor : AnchorsOf(*added)) {
      anchor.source = next_source_++;
      pending_anchors_.push_back(anchor);
    }
    queue_.Restart();
    rule_.Restart();
    certified_radius_ = -1;
    return absl::OkStatus();
  }

  uint64_t bytes() const override {
    return front_.bytes() + rule_.bytes() + queue_.bytes() + hubs_.bytes();
  }
  // For what a queue has recorded about the run.
  const Queue& queue() const { return queue_; }

 private:
  // To look whether so many are certified takes far less than what is done
  // between two polls.
  static constexpr uint64_t kTargetsByPoll = 256;

  using FrontType = Front<Queue, OriginType, NoGoal, Accuracy>;
  using RuleType = Rule<FrontType>;
  // Whether the rule handles many ids of the queue together.
  static constexpr bool kTogether =
      requires(RuleType & rule, std::span<const uint32_t> ids) {
    rule.Propagate(ids);
  };
  // Whether it shares its work among threads.
  static constexpr bool kThreads =
      std::is_constructible_v<RuleType, FrontType&, uint32_t>;

  // Distances are lower bounds so far.
  void MoveToAnswers(DistanceField& field) const {
    const auto move = [&](double& distance, double account) {
      if (std::isinf(distance) || distance == 0) return 0.0f;
      const double open = ToFileUnit(mesh(), account);
      const float error = RoundedUp((1 - kAnswerInAccount) * open / distance +
                                    Accuracy::kMargin);
      distance += kAnswerInAccount * open;
      if (distance > asked_radius_ && std::isfinite(certified_radius_)) {
        distance = std::numeric_limits<double>::infinity();
        return 0.0f;
      }
      field.certified_error =
          std::max(field.certified_error, static_cast<double>(error));
      return error;
    };
    field.certified_errors.reserve(field.distances.size());
    for (uint32_t v = 0; v < field.distances.size(); ++v) {
      field.certified_errors.push_back(
          move(field.distances[v], front_.AccountOf(v)));
    }
    const Targets& targets = front_.targets();
    for (size_t t = 0; t < targets.size(); ++t) {
      const uint32_t holder = targets.AccountHolder(t, front_.distances());
      field.target_certified_errors.push_back(
          move(field.target_distances[t], front_.AccountOf(holder)));
    }
  }

  static std::deque<Anchor> PendingAnchors(const ValidQuery& query) {
    const std::vector<Anchor> anchors = AnchorsOf(query);
    return {anchors.begin(), anchors.end()};
  }

  static Accuracy AccuracyOf(const Query& query) {
    if constexpr (Accuracy::kMerges) {
      return Accuracy(query.tolerance);
    } else {
      return {};
    }
  }
  static RuleType MakeRule(FrontType& front, const Tuning& tuning) {
    if constexpr (kThreads) {
      return RuleType(front, tuning.threads);
    } else {
      return RuleType(front);
    }
  }

  absl::Status Run(const Reach& reach, Checkpoint& checkpoint) {
    if (absl::Status status = Poll(checkpoint); !status.ok()) return status;
    if (absl::Status status = Seed(checkpoint); !status.ok()) return status;
    const double radius = std::ldexp(reach.radius, -mesh().scale_exponent());
    uint64_t steps = 0;
    while (SettledRadius() <= radius) {
      const uint64_t taken = Take();
      if (taken == 0) {
        if (RelaxAlongEdges(front_, std::numeric_limits<double>::infinity())) {
          queue_.Restart();
          rule_.Restart();
          steps = kWorkBetweenPolls;  // that took long
          continue;
        }
        if (absl::Status status = CheckComplete(); !status.ok()) return status;
        certified_radius_ = std::numeric_limits<double>::infinity();
        return Poll(checkpoint);
      }
      steps += taken;
      if (steps >= kWorkBetweenPolls) {
        steps = 0;
        if (absl::Status status = Poll(checkpoint); !status.ok()) {
          CertifyUpTo(reach.radius);
          return status;
        }
        if (HasTargets(reach.targets)) break;
      }
    }
    if (mesh().HasThinFaces()) {
      absl::Status status =
          MendUpTo(std::min(radius, SettledRadius()), checkpoint);
      if (!status.ok()) return status;
    }
    CertifyUpTo(reach.radius);
    return Poll(checkpoint);
  }

  // Relaxes what windows have missed up to `limit`, and propagates what comes
  // of it as far as all was settled.
  absl::Status MendUpTo(double limit, Checkpoint& checkpoint) {
    uint64_t steps = 0;
    while (RelaxAlongEdges(front_, limit)) {
      if (absl::Status status = Poll(checkpoint); !status.ok()) return status;
      const double settled = SettledRadius();
      while (SettledRadius() <= settled) {
        const uint64_t taken = Take();
        if (taken == 0) break;
        steps += taken;
        if (steps < kWorkBetweenPolls) continue;
        steps = 0;
        if (absl::Status status = Poll(checkpoint); !status.ok()) return status;
      }
    }
    return absl::OkStatus();
  }

  absl::Status Seed(Checkpoint& checkpoint) {
    DirectSink sink(front_, rule_);
    uint64_t steps = 0;
    while (HasToSpread() || !pending_anchors_.empty()) {
      if (steps >= kWorkBetweenPolls) {
        steps = 0;
        if (absl::Status status = Poll(checkpoint); !status.ok()) return status;
      }
      if (HasToSpread()) {
        steps += Spread();
        continue;
      }
      const uint64_t before = rule_.steps();
      const uint64_t faces = AddAnchor(front_, pending_anchors_.front(), sink);
      pending_anchors_.pop_front();
      steps += kStepsOfAnchor + std::max(faces, rule_.steps() - before);
    }
    return absl::OkStatus();
  }

  // Everything that is settled, but nothing beyond `radius`.
  void CertifyUpTo(double radius) {
    certified_radius_ =
        std::max(certified_radius_,
                 std::min(radius, ToFileUnit(mesh(), SettledRadius())));
  }

  // Propagates what the queue gives next. Returns how many steps that were: 0
  // if nothing is left.
  uint64_t Take() {
    uint64_t taken = 0;
    if (HasToSpread()) {
      taken = Spread();
    } else if constexpr (kTogether) {
      taken = StepTogether();
    } else {
      taken = Step();
    }
    statistics_.peak_wavefront =
        std::max(statistics_.peak_wavefront, rule_.pending());
    return taken;
  }

  // Whether something goes on that was taken from the queue and left halfway.
  bool HasToSpread() const {
    if (!hubs_.empty()) return true;
    if constexpr (ToldOfWideEdges<RuleType>) {
      return rule_.HasToSpread();
    } else {
      return false;
    }
  }
  // REQUIRES: HasToSpread(). Returns how many steps that were, at least one.
  uint64_t Spread() {
    const uint64_t before = rule_.steps();
    if constexpr (ToldOfWideEdges<RuleType>) {
      if (rule_.HasToSpread()) {
        rule_.Spread();
        return std::max<uint64_t>(1, rule_.steps() - before);
      }
    }
    const uint64_t faces = hubs_.GoOn();
    return std::max(faces, rule_.steps() - before);
  }

  // The next one.
  uint64_t Step() {
    taken_from_ = queue_.SettledRadius();
    const uint32_t id = queue_.Pop();
    if (id == kNothing) return 0;
    PrefetchUpcoming();
    if (id & kVertexEvent) {
      ++statistics_.pseudo_source_events;
      if (hubs_.Take(id)) return 1;
      const uint32_t v = id & ~kVertexEvent;
      DirectSink sink(front_, rule_);
      if (!front_.TakeEvent(v)) return 1;
      const uint64_t before = rule_.steps();
      const uint64_t faces = Expand(front_, v, sink);
      return std::max({StepsOf(mesh(), id), faces, rule_.steps() - before});
    }
    const uint64_t before = rule_.steps();
    const uint64_t windows = rule_.Propagate(id);
    statistics_.windows_propagated += windows;
    return std::max({uint64_t{1}, windows, rule_.steps() - before});
  }

  // All whose order the queue knows already.
  uint64_t StepTogether() {
    taken_from_ = queue_.SettledRadius();
    PopTogether(queue_, rule_.most_together(), together_);
    if (together_.empty()) return 0;
    for (const uint32_t id : together_) {
      statistics_.pseudo_source_events += (id & kVertexEvent) != 0;
    }
    std::erase_if(together_, [this](uint32_t id) { return hubs_.Take(id); });
    uint64_t steps = 1;
    for (const uint32_t id : together_) steps += StepsOf(mesh(), id);
    const uint64_t before = rule_.steps();
    const uint64_t windows = rule_.Propagate(together_);
    statistics_.windows_propagated += windows;
    return std::max({steps, windows, rule_.steps() - before});
  }

  absl::Status Poll(Checkpoint& checkpoint) {
    statistics_.peak_solver_bytes =
        std::max(statistics_.peak_solver_bytes, bytes());
    wavefront_sum_ += static_cast<double>(rule_.pending());
    ++wavefront_samples_;
    // Before the sources are seeded an empty queue settles nothing.
    const double settled =
        pending_anchors_.empty() ? ToFileUnit(mesh(), SettledRadius()) : 0;
    return checkpoint.Poll({
        .settled_radius =
            std::isinf(certified_radius_) ? certified_radius_ : settled,
        .vertices_reached = front_.reached(),
        .vertices = mesh().vertex_count(),
        .live_windows = rule_.pending(),
        .windows_propagated = statistics_.windows_propagated,
        .solver_bytes = bytes(),
        .distances = front_.distances(),
        .unit = ToFileUnit(mesh(), 1),
    });
  }

  // Whether every vertex of a component with a source was reached.
  absl::Status CheckComplete() const {
    const std::optional<uint32_t> missing = FindGap(front_);
    if (!missing.has_value()) return absl::OkStatus();
    return absl::InternalError(absl::StrCat(
        "vertex ", *missing, " was not reached by ",
        std::string(AlgorithmName(algorithm_)),
        ", though a neighbour was: a defect of the solver. Another algorithm "
        "may give the answer; please report the mesh and the query"));
  }

  bool HasTargets(uint64_t wanted) {
    const size_t count = front_.targets().size();
    if (wanted > count || next_target_count_-- > 0) return false;
    // Counting is rare enough to cost little beside the windows in between.
    next_target_count_ = count / kTargetsByPoll;
    const double settled = SettledRadius();
    uint64_t certified = 0;
    for (size_t t = 0; t < count; ++t) {
      certified += front_.targets().Distance(t, front_.distances()) <= settled;
    }
    return certified >= wanted;
  }

  void PrefetchUpcoming() const {
    for (size_t stage = 0; stage < rule_.kPrefetchAhead.size(); ++stage) {
      const uint32_t id = queue_.Upcoming(rule_.kPrefetchAhead[stage]);
      if (!(id & kVertexEvent)) rule_.Prefetch(id, stage);
    }
  }

  const Mesh& mesh() const { return front_.mesh(); }
  // Every distance up to here is final. What is pending, and all that comes of
  // it, is no nearer than its label says, less what is spent on merges.
  double SettledRadius() const {
    const double settled = HasToSpread()
                               ? std::min(taken_from_, queue_.SettledRadius())
                               : queue_.SettledRadius();
    if constexpr (Accuracy::kMerges) {
      return settled / (1 + front_.accuracy().share());
    } else {
      return settled;
    }
  }

  const Algorithm algorithm_;
  const bool traces_;
  uint32_t next_source_;
  std::deque<Anchor> pending_anchors_;  // not yet in the front
  Queue queue_;
  FrontType front_;
  RuleType rule_;
  std::vector<uint32_t> together_;  // of one step
  Hubs<FrontType, RuleType> hubs_;
  double taken_from_ = 0;  // what was settled when they were taken
  SolveStatistics statistics_;
  double wavefront_sum_ = 0;
  uint64_t wavefront_samples_ = 0;
  uint64_t next_target_count_ = 0;  // polls until targets are counted again
  double certified_radius_ = -1;    // in the unit of the file
  double asked_radius_ = 0;         // the largest of Advance, in that unit
};

}  // namespace geodesic

#endif  // GEODESIC_SOLVER_PROPAGATION_H_
