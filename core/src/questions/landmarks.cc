#include "geodesic/landmarks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <variant>

#include "geodesic/solve.h"
#include "mesh/scaled_difference.h"
#include "surface/surface_location.h"
#include "tolerances.h"

namespace geodesic {
namespace {

// The vertices of the part of the mesh that has most of them, by faces that
// share a vertex. O(V + F).
std::vector<uint32_t> LargestPart(const Mesh& mesh) {
  std::vector<uint32_t> largest;
  std::vector<bool> is_seen(mesh.vertex_count());
  size_t left = mesh.vertex_count();
  for (uint32_t v = 0; v < mesh.vertex_count() && largest.size() < left; ++v) {
    if (is_seen[v]) continue;
    std::vector<uint32_t> part = {v};
    is_seen[v] = true;
    for (size_t i = 0; i < part.size(); ++i) {
      for (const HalfEdge side : mesh.Outgoing(part[i])) {
        for (const uint32_t w : mesh.TriangleOf(side)) {
          if (is_seen[w]) continue;
          is_seen[w] = true;
          part.push_back(w);
        }
      }
    }
    left -= part.size();
    if (part.size() > largest.size()) largest = std::move(part);
  }
  return largest;
}

// A vertex at one end of the largest part; any end is as good a beginning.
std::optional<uint32_t> FirstOf(const Mesh& mesh) {
  const std::vector<uint32_t> part = LargestPart(mesh);
  if (part.size() < 2) return std::nullopt;
  const ScaledDifference difference(mesh.scale_exponent());
  const std::span<const Point> positions = mesh.positions();
  return *std::ranges::max_element(part, {}, [&](uint32_t v) {
    return Norm(difference(positions[part[0]], positions[v]));
  });
}

// Whether distances differ along each edge by its length at the most, up to the
// rounding that bounds allow for.
bool AgreeWithEdges(const Mesh& mesh, std::span<const double> distances,
                    double scale) {
  for (HalfEdge h = 0; h < mesh.half_edge_count(); ++h) {
    const double from = distances[mesh.From(h)] * scale;
    const double to = distances[mesh.To(h)] * scale;
    if (std::abs(from - to) >
        mesh.frame(h).length + kLandmarkRounding * std::max(from, to) / 2) {
      return false;
    }
  }
  return true;
}

}  // namespace

Landmarks::Landmarks(const Mesh& mesh)
    : scale_(std::ldexp(1.0, -mesh.scale_exponent())),
      next_(FirstOf(mesh)),
      rows_(mesh.vertex_count()) {}

Landmarks::Landmarks(const Mesh& mesh, uint32_t count, std::vector<Row> rows)
    : scale_(std::ldexp(1.0, -mesh.scale_exponent())),
      count_(count),
      rows_(std::move(rows)) {}

uint64_t Landmarks::PlannedBytes(const Mesh& mesh) {
  return mesh.vertex_count() * sizeof(Row);
}

void Landmarks::Add(const Mesh& mesh, std::span<const double> distances) {
  if (!AgreeWithEdges(mesh, distances, scale_)) {
    next_.reset();
    return;
  }
  for (size_t v = 0; v < rows_.size(); ++v) {
    rows_[v].distances[count_] = static_cast<float>(distances[v] * scale_);
  }
  ++count_;
  next_ = count_ < kMost ? Farthest() : std::nullopt;
}

std::optional<uint32_t> Landmarks::Farthest() const {
  std::optional<uint32_t> farthest;
  float most = 0;
  for (uint32_t v = 0; v < rows_.size(); ++v) {
    const auto& distances = rows_[v].distances;
    const float nearest =
        *std::min_element(distances.begin(), distances.begin() + count_);
    if (std::isinf(nearest) || nearest <= most) continue;
    most = nearest;
    farthest = v;
  }
  return farthest;
}

Landmarks::Place Landmarks::PlaceOf(const SurfacePoint& point,
                                    const Mesh& mesh) const {
  Place place;
  if (const auto* vertex = std::get_if<VertexPoint>(&point)) {
    place.low = place.high = rows_[vertex->vertex].distances;
    return place;
  }
  place.low.fill(0);
  place.high.fill(std::numeric_limits<float>::infinity());
  const FacePoint in_face = FacesAround(mesh, point)[0];
  for (uint32_t corner = 0; corner < 3; ++corner) {
    const auto beside = static_cast<float>(
        DistanceToCorner(mesh, in_face, corner) * (1 + 2 * kLandmarkRounding));
    const Row& row = rows_[mesh.triangle(in_face.face)[corner]];
    for (uint32_t l = 0; l < kMost; ++l) {
      // Rounding goes with these, and the difference may be far smaller.
      const float low = row.distances[l] * (1 - kLandmarkRounding);
      const float high = row.distances[l] * (1 + kLandmarkRounding);
      place.low[l] = std::max(place.low[l], low - beside);
      place.high[l] = std::min(place.high[l], high + beside);
    }
  }
  return place;
}

double Landmarks::LowerBound(uint32_t v, const Place& place) const {
  const Row& row = rows_[v];
  // A landmark in another part of the mesh is infinitely far from both, and
  // tells nothing: NaN is not greater.
  std::array<float, kMost> bounds;
  for (uint32_t l = 0; l < kMost; ++l) {
    const float distance = row.distances[l];
    const float before = place.low[l] * (1 - kLandmarkRounding) -
                         distance * (1 + kLandmarkRounding);
    const float beyond = distance * (1 - kLandmarkRounding) -
                         place.high[l] * (1 + kLandmarkRounding);
    const float bound = before > 0 ? before : 0;
    bounds[l] = beyond > bound ? beyond : bound;
  }
  // By halves, for which processors have instructions.
  for (uint32_t half = kMost / 2; half > 0; half /= 2) {
    for (uint32_t l = 0; l < half; ++l) {
      bounds[l] = bounds[l + half] > bounds[l] ? bounds[l + half] : bounds[l];
    }
  }
  return bounds[0];
}

absl::StatusOr<Landmarks> MakeLandmarks(const Mesh& mesh, uint32_t count,
                                        const SolveOptions& options,
                                        Checkpoint& checkpoint) {
  Landmarks landmarks(mesh);
  while (landmarks.count() < count && landmarks.next().has_value()) {
    const absl::StatusOr<DistanceField> field =
        Solve(mesh, Query{.sources = {{VertexPoint{*landmarks.next()}}}},
              options, checkpoint);
    if (!field.ok()) return field.status();
    landmarks.Add(mesh, field->distances);
  }
  return landmarks;
}

}  // namespace geodesic
