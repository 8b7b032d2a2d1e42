#include "solve_within.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

namespace geodesic::python {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// How far a field goes that stops after some of its targets: the search may
// have gone on a little, by an amount that is nobody's business.
double RadiusOfTargets(const DistanceField& field, const Reach& reach) {
  std::vector<double> distances = field.target_distances;
  if (reach.targets == 0 || reach.targets > distances.size()) return kInfinity;
  const auto last =
      distances.begin() + static_cast<std::ptrdiff_t>(reach.targets - 1);
  std::ranges::nth_element(distances, last);
  return *last;
}

// What lies beyond is not reached, and nothing leads there.
void CutAt(double radius, DistanceField& field) {
  if (std::isinf(radius)) return;
  bool was_cut = false;
  const auto cut = [&](std::vector<double>& distances,
                       std::vector<Arrival>& arrivals) {
    for (size_t i = 0; i < distances.size(); ++i) {
      if (distances[i] <= radius) continue;
      was_cut |= !std::isinf(distances[i]);
      distances[i] = kInfinity;
      if (!arrivals.empty()) arrivals[i] = {};
    }
  };
  cut(field.distances, field.arrivals);
  cut(field.target_distances, field.target_arrivals);
  if (was_cut || !std::isinf(field.settled_radius)) {
    field.settled_radius = std::min(field.settled_radius, radius);
  }
}

}  // namespace

absl::StatusOr<DistanceField> SolveWithin(const Mesh& mesh,
                                          const ValidQuery& query,
                                          const Reach& reach, uint32_t threads,
                                          Checkpoint& checkpoint) {
  absl::StatusOr<std::unique_ptr<Computation>> computation =
      StartComputation(mesh, query, {.threads = threads});
  if (!computation.ok()) return computation.status();
  if (absl::Status status = (*computation)->Advance(reach, checkpoint);
      !status.ok()) {
    return status;
  }
  DistanceField field = (*computation)->Field();
  CutAt(std::min(reach.radius, RadiusOfTargets(field, reach)), field);
  return field;
}

}  // namespace geodesic::python
