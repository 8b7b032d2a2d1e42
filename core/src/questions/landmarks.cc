#include "geodesic/landmarks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <variant>

#include "geodesic/solve.h"
#include "surface/surface_location.h"
#include "tolerances.h"

namespace geodesic {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The vertex farthest from all landmarks; none if all are landmarks.
std::optional<uint32_t> Farthest(const std::vector<double>& nearest) {
  const auto is_nearer = [](double a, double b) {
    return (std::isinf(a) ? 0 : a) < (std::isinf(b) ? 0 : b);
  };
  const auto farthest = std::ranges::max_element(nearest, is_nearer);
  if (farthest == nearest.end() || std::isinf(*farthest) || *farthest == 0) {
    return std::nullopt;
  }
  return static_cast<uint32_t>(farthest - nearest.begin());
}

absl::StatusOr<std::vector<double>> FieldOf(uint32_t vertex, const Mesh& mesh,
                                            const SolveOptions& options,
                                            Checkpoint& checkpoint) {
  absl::StatusOr<DistanceField> field = Solve(
      mesh, Query{.sources = {{VertexPoint{vertex}}}}, options, checkpoint);
  if (!field.ok()) return field.status();
  return std::move(field->distances);
}

// The field of a vertex in the part of the mesh that has most vertices.
absl::StatusOr<std::vector<double>> FirstField(const Mesh& mesh,
                                               const SolveOptions& options,
                                               Checkpoint& checkpoint) {
  std::vector<double> largest;
  int64_t most = 0, left = mesh.vertex_count();
  std::vector<bool> is_seen(mesh.vertex_count());
  for (uint32_t v = 0; v < mesh.vertex_count() && most < left; ++v) {
    if (is_seen[v]) continue;
    absl::StatusOr<std::vector<double>> field =
        FieldOf(v, mesh, options, checkpoint);
    if (!field.ok()) return field.status();
    int64_t reached = 0;
    for (uint32_t w = 0; w < mesh.vertex_count(); ++w) {
      if (std::isinf((*field)[w])) continue;
      is_seen[w] = true;
      ++reached;
    }
    left -= reached;
    if (reached <= most) continue;
    most = reached;
    largest = *std::move(field);
  }
  return largest;
}

}  // namespace

Landmarks::Landmarks(const Mesh& mesh)
    : scale_(std::ldexp(1.0, -mesh.scale_exponent())),
      values_(mesh.vertex_count()) {}

uint64_t Landmarks::PlannedBytes(const Mesh& mesh) {
  return mesh.vertex_count() * sizeof(Row);
}

void Landmarks::Add(std::span<const double> distances) {
  for (size_t v = 0; v < values_.size(); ++v) {
    values_[v].distances[count_] = static_cast<float>(distances[v] * scale_);
  }
  ++count_;
}

Landmarks::Place Landmarks::PlaceOf(const SurfacePoint& point,
                                    const Mesh& mesh) const {
  Place place;
  if (const auto* vertex = std::get_if<VertexPoint>(&point)) {
    place.low = place.high = values_[vertex->vertex].distances;
    return place;
  }
  place.low.fill(0);
  place.high.fill(std::numeric_limits<float>::infinity());
  const FacePoint in_face = FacesAround(mesh, point)[0];
  for (uint32_t corner = 0; corner < 3; ++corner) {
    const auto beside = static_cast<float>(
        DistanceToCorner(mesh, in_face, corner) * (1 + kLandmarkRounding));
    const Row& row = values_[mesh.triangle(in_face.face)[corner]];
    for (uint32_t l = 0; l < kMost; ++l) {
      const float distance = row.distances[l];
      place.low[l] = std::max(place.low[l], distance - beside);
      place.high[l] = std::min(place.high[l], distance + beside);
    }
  }
  return place;
}

double Landmarks::LowerBound(uint32_t v, const Place& place) const {
  const Row& row = values_[v];
  // A landmark in another part of the mesh is infinitely far from both, and
  // tells nothing: NaN is not greater.
  float bound = 0;
  for (uint32_t l = 0; l < kMost; ++l) {
    const float distance = row.distances[l];
    const float before = place.low[l] * (1 - kLandmarkRounding) -
                         distance * (1 + kLandmarkRounding);
    const float beyond = distance * (1 - kLandmarkRounding) -
                         place.high[l] * (1 + kLandmarkRounding);
    bound = before > bound ? before : bound;
    bound = beyond > bound ? beyond : bound;
  }
  return bound;
}

absl::StatusOr<Landmarks> MakeLandmarks(const Mesh& mesh, uint32_t count,
                                        const SolveOptions& options,
                                        Checkpoint& checkpoint) {
  Landmarks landmarks(mesh);
  absl::StatusOr<std::vector<double>> field =
      FirstField(mesh, options, checkpoint);
  if (!field.ok()) return field.status();
  // The first landmark is as far from that vertex as can be.
  std::optional<uint32_t> next = Farthest(*field);
  std::vector<double> nearest(mesh.vertex_count(), kInfinity);
  while (next.has_value() &&
         landmarks.count() < std::min(count, Landmarks::kMost)) {
    field = FieldOf(*next, mesh, options, checkpoint);
    if (!field.ok()) return field.status();
    landmarks.Add(*field);
    for (uint32_t v = 0; v < nearest.size(); ++v) {
      nearest[v] = std::min(nearest[v], (*field)[v]);
    }
    next = Farthest(nearest);
  }
  return landmarks;
}

}  // namespace geodesic
