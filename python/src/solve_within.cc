#include "solve_within.h"

#include <algorithm>
#include <limits>
#include <memory>

namespace geodesic::python {

absl::StatusOr<DistanceField> SolveWithin(const Mesh& mesh,
                                          const ValidQuery& query,
                                          const Reach& reach, uint32_t threads,
                                          Checkpoint& checkpoint) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  absl::StatusOr<std::unique_ptr<Computation>> computation =
      StartComputation(mesh, query, {.threads = threads});
  if (!computation.ok()) return computation.status();
  if (absl::Status status = (*computation)->Advance(reach, checkpoint);
      !status.ok()) {
    return status;
  }
  DistanceField field = (*computation)->Field();
  if (reach.radius == kInfinity) return field;
  const auto cut = [&](double& distance) {
    if (distance > reach.radius) distance = kInfinity;
  };
  std::ranges::for_each(field.distances, cut);
  std::ranges::for_each(field.target_distances, cut);
  field.settled_radius = std::min(field.settled_radius, reach.radius);
  return field;
}

}  // namespace geodesic::python
