// Counts work and asks a checkpoint each time when enough of it was done.

#ifndef GEODESIC_SOLVER_WORK_METER_H_
#define GEODESIC_SOLVER_WORK_METER_H_

#include <cstdint>

#include "absl/functional/function_ref.h"
#include "absl/status/status.h"
#include "geodesic/checkpoint.h"
#include "geodesic/distance_field.h"
#include "geodesic/mesh.h"
#include "solver/queues/queue.h"

namespace geodesic {

// For one thread.
//
//   WorkMeter meter(poll);
//   while (meter.Do()) ...  // one step
//   if (!meter.status().ok()) return meter.status();
class WorkMeter {
 public:
  // `poll` asks the checkpoint and outlives the meter.
  explicit WorkMeter(absl::FunctionRef<absl::Status()> poll) : poll_(poll) {}
  WorkMeter(const WorkMeter&) = delete;
  WorkMeter& operator=(const WorkMeter&) = delete;

  // Counts so many steps, each a microsecond at the most. False from when it
  // was told to stop.
  bool Do(uint64_t steps = 1) {
    steps_ += steps;
    if (steps_ >= kWorkBetweenPolls && status_.ok()) {
      steps_ = 0;
      status_ = poll_();
    }
    return status_.ok();
  }

  // What the checkpoint said.
  const absl::Status& status() const { return status_; }

 private:
  const absl::FunctionRef<absl::Status()> poll_;
  uint64_t steps_ = 0;
  absl::Status status_;
};

// The steps of an event that a queue gives: of a vertex its faces.
inline uint64_t StepsOf(const Mesh& mesh, uint32_t id) {
  return 1 + (id & kVertexEvent ? mesh.Outgoing(id & ~kVertexEvent).size() : 0);
}

// What is said while more is made of a field that is there.
inline Progress ProgressOf(const DistanceField& field) {
  return {.settled_radius = field.settled_radius,
          .vertices_reached = field.distances.size(),
          .vertices = field.distances.size(),
          .windows_propagated = field.statistics.windows_propagated,
          .distances = field.distances};
}

}  // namespace geodesic

#endif  // GEODESIC_SOLVER_WORK_METER_H_
