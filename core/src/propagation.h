// The loop that drives a rule with a queue: every algorithm is this loop.

#ifndef GEODESIC_PROPAGATION_H_
#define GEODESIC_PROPAGATION_H_

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "absl/status/statusor.h"
#include "geodesic/checkpoint.h"
#include "geodesic/distance_field.h"
#include "geodesic/mesh.h"
#include "geodesic/query.h"
#include "rules/front.h"

namespace geodesic {

// Solves the query with windows made by Rule, in the order of Queue.
template <template <typename> typename Rule, WindowQueue Queue>
class Propagation {
 public:
  Propagation(const Mesh& mesh, const Query& query, const QueueTuning& tuning)
      : query_(query),
        queue_(tuning),
        front_(mesh, query, queue_),
        rule_(front_) {}

  absl::StatusOr<DistanceField> Run(Checkpoint& checkpoint);
  // For what a queue has recorded about the run.
  const Queue& queue() const { return queue_; }

 private:
  // Under a millisecond of work between two polls.
  static constexpr uint64_t kPollPeriod = 2048;

  void Seed();
  void Step(uint32_t id);
  absl::Status Poll(Checkpoint& checkpoint);
  void PrefetchUpcoming() const;
  double ToFileUnit(double length) const {
    return std::ldexp(length, front_.mesh().scale_exponent());
  }
  DistanceField Finish() &&;

  const Query& query_;
  Queue queue_;
  Front<Queue> front_;
  Rule<Queue> rule_;
  SolveStatistics statistics_;
  double wavefront_sum_ = 0;
  uint64_t wavefront_samples_ = 0;
};

template <template <typename> typename Rule, WindowQueue Queue>
absl::StatusOr<DistanceField> Propagation<Rule, Queue>::Run(
    Checkpoint& checkpoint) {
  if (absl::Status status = Poll(checkpoint); !status.ok()) return status;
  Seed();
  for (uint64_t steps = 1;; ++steps) {
    const uint32_t id = queue_.Pop();
    if (id == kNothing) break;
    PrefetchUpcoming();
    Step(id);
    if (steps % kPollPeriod == 0) {
      if (absl::Status status = Poll(checkpoint); !status.ok()) return status;
    }
  }
  if (absl::Status status = Poll(checkpoint); !status.ok()) return status;
  return std::move(*this).Finish();
}

template <template <typename> typename Rule, WindowQueue Queue>
void Propagation<Rule, Queue>::Seed() {
  for (const Source& source : query_.sources) {
    front_.Relax(source.vertex,
                 std::ldexp(source.offset, -front_.mesh().scale_exponent()));
  }
}

template <template <typename> typename Rule, WindowQueue Queue>
void Propagation<Rule, Queue>::Step(uint32_t id) {
  if (id & kVertexEvent) {
    const uint32_t v = id & ~kVertexEvent;
    ++statistics_.pseudo_source_events;
    front_.Expand(v, [&](HalfEdge half_edge, const Origin& origin) {
      rule_.Open(half_edge, v, origin);
    });
  } else {
    statistics_.windows_propagated += rule_.Propagate(id);
  }
  statistics_.peak_wavefront =
      std::max(statistics_.peak_wavefront, queue_.size());
}

template <template <typename> typename Rule, WindowQueue Queue>
absl::Status Propagation<Rule, Queue>::Poll(Checkpoint& checkpoint) {
  const uint64_t bytes = front_.bytes() + rule_.bytes() + queue_.bytes();
  statistics_.peak_solver_bytes =
      std::max(statistics_.peak_solver_bytes, bytes);
  wavefront_sum_ += static_cast<double>(queue_.size());
  ++wavefront_samples_;
  return checkpoint.Poll({
      .settled_radius = ToFileUnit(queue_.SettledRadius()),
      .vertices_reached = front_.reached(),
      .vertices = front_.mesh().vertex_count(),
      .live_windows = queue_.size(),
      .windows_propagated = statistics_.windows_propagated,
      .solver_bytes = bytes,
  });
}

template <template <typename> typename Rule, WindowQueue Queue>
void Propagation<Rule, Queue>::PrefetchUpcoming() const {
  for (size_t stage = 0; stage < rule_.kPrefetchAhead.size(); ++stage) {
    const uint32_t id = queue_.Upcoming(rule_.kPrefetchAhead[stage]);
    if (!(id & kVertexEvent)) rule_.Prefetch(id, stage);
  }
}

template <template <typename> typename Rule, WindowQueue Queue>
DistanceField Propagation<Rule, Queue>::Finish() && {
  statistics_.iterations = queue_.iterations();
  statistics_.windows_created = rule_.created();
  statistics_.peak_windows = rule_.peak_windows();
  statistics_.mean_wavefront =
      wavefront_sum_ / static_cast<double>(wavefront_samples_);
  DistanceField field{.distances = std::move(front_).TakeDistances(),
                      .algorithm = query_.algorithm,
                      .statistics = statistics_};
  for (double& distance : field.distances) distance = ToFileUnit(distance);
  return field;
}

}  // namespace geodesic

#endif  // GEODESIC_PROPAGATION_H_
