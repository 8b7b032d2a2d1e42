#include "geodesic/sampling.h"

#include <memory>
#include <optional>

#include "geodesic/computation.h"
#include "tolerances.h"

namespace geodesic {
namespace {

// The vertex of greatest distance, the lowest of those that tie; none if all
// vertices with faces are at distance 0.
std::optional<FarthestSample> Farthest(const Mesh& mesh,
                                       const DistanceField& field) {
  std::optional<FarthestSample> farthest;
  double to_beat = 0;
  for (uint32_t v = 0; v < mesh.vertex_count(); ++v) {
    const double distance = field.distances[v];
    if (!(distance > to_beat) || mesh.Outgoing(v).empty()) continue;
    farthest = {v, distance};
    to_beat = distance * (1 + kTiedSamples);
  }
  return farthest;
}

}  // namespace

absl::StatusOr<std::vector<FarthestSample>> SampleFarthestPoints(
    const Mesh& mesh, const ValidQuery& query, uint32_t count,
    const SolveOptions& options, Checkpoint& checkpoint) {
  absl::StatusOr<std::unique_ptr<Computation>> computation =
      StartComputation(mesh, query.DistancesAlone(), options);
  if (!computation.ok()) return computation.status();
  std::vector<FarthestSample> samples;
  while (samples.size() < count) {
    if (absl::Status status = (*computation)->Advance({}, checkpoint);
        !status.ok()) {
      return status;
    }
    const std::optional<FarthestSample> sample =
        Farthest(mesh, (*computation)->Field());
    if (!sample.has_value()) break;
    samples.push_back(*sample);
    if (absl::Status status =
            (*computation)->AddSource({VertexPoint{sample->vertex}});
        !status.ok()) {
      return status;
    }
  }
  return samples;
}

}  // namespace geodesic
