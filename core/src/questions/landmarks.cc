#include "geodesic/landmarks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <variant>

#include "geodesic/computation.h"
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

// That a distance may have: one less than kApart.
constexpr double kMostSteps = 0xfffe;

// The first landmark leaves so much room for larger distances from others.
constexpr double kRoom = 1.25;

// Whether distances differ along each edge by its length at the most, up to
// `rounding`.
bool AgreeWithEdges(const Mesh& mesh, std::span<const double> distances,
                    double scale, double rounding) {
  for (HalfEdge h = 0; h < mesh.half_edge_count(); ++h) {
    const double from = distances[mesh.From(h)] * scale;
    const double to = distances[mesh.To(h)] * scale;
    if (std::abs(from - to) > mesh.frame(h).length + rounding) return false;
  }
  return true;
}

// Of those that are finite.
double Farthest(std::span<const double> distances) {
  double farthest = 0;
  for (const double distance : distances) {
    if (std::isfinite(distance)) farthest = std::max(farthest, distance);
  }
  return farthest;
}

}  // namespace

Landmarks::Landmarks(const Mesh& mesh)
    : scale_(std::ldexp(1.0, -mesh.scale_exponent())),
      next_(FirstOf(mesh)),
      rows_(mesh.vertex_count()) {}

Landmarks::Landmarks(const Mesh& mesh, uint32_t count, double step,
                     std::vector<Row> rows)
    : scale_(std::ldexp(1.0, -mesh.scale_exponent())),
      count_(count),
      step_(step),
      rows_(std::move(rows)) {}

uint64_t Landmarks::PlannedBytes(const Mesh& mesh) {
  return mesh.vertex_count() * sizeof(Row);
}

uint64_t Landmarks::PlannedMakingBytes(const Mesh& mesh) {
  const absl::StatusOr<ValidQuery> query =
      ValidQuery::Make({.sources = {{VertexPoint{0}}}}, mesh);
  return (query.ok() ? PlannedSolverBytes(mesh, *query) : 0) +
         mesh.vertex_count() * sizeof(double);
}

void Landmarks::Add(const Mesh& mesh, std::span<const double> distances) {
  const double farthest = Farthest(distances) * scale_;
  const double step = count_ > 0 ? step_ : kRoom * farthest / kMostSteps;
  if (step == 0 ||
      !AgreeWithEdges(mesh, distances, scale_, kLandmarkRounding * step / 2)) {
    next_.reset();
    return;
  }
  step_ = step;
  while (farthest > kMostSteps * step_) DoubleStep();
  for (size_t v = 0; v < rows_.size(); ++v) {
    const double steps = std::floor(distances[v] * scale_ / step_);
    rows_[v].steps[count_] =
        steps < kApart ? static_cast<uint16_t>(steps) : kApart;
  }
  ++count_;
  next_ = count_ < kMost ? FarthestVertex() : std::nullopt;
}

void Landmarks::DoubleStep() {
  step_ *= 2;
  for (Row& row : rows_) {
    for (uint16_t& steps : row.steps) {
      if (steps != kApart) steps /= 2;
    }
  }
}

std::optional<uint32_t> Landmarks::FarthestVertex() const {
  std::optional<uint32_t> farthest;
  uint16_t most = 0;
  for (uint32_t v = 0; v < rows_.size(); ++v) {
    const Steps& steps = rows_[v].steps;
    const uint16_t nearest =
        *std::min_element(steps.begin(), steps.begin() + count_);
    if (nearest == kApart || nearest <= most) continue;
    most = nearest;
    farthest = v;
  }
  return farthest;
}

Landmarks::Place Landmarks::PlaceOf(const SurfacePoint& point,
                                    const Mesh& mesh) const {
  Place place;
  if (count_ == 0) return place;
  // The place is in whole steps from `low` to `high`, and a vertex may be a
  // step farther than its own number says.
  const auto narrow = [&](const Steps& steps, double beside) {
    for (uint32_t l = 0; l < kMost; ++l) {
      const double low = std::max(std::floor(steps[l] - beside) - 1, 0.0);
      const double high =
          std::min<double>(std::ceil(steps[l] + beside) + 1, kApart);
      place.before[l] = std::max(place.before[l], static_cast<uint16_t>(low));
      place.beyond[l] = std::min(place.beyond[l], static_cast<uint16_t>(high));
    }
    place.is_apart = place.is_apart || steps[0] == kApart;
  };
  place.beyond.fill(kApart);
  if (const auto* vertex = std::get_if<VertexPoint>(&point)) {
    narrow(rows_[vertex->vertex].steps, 0);
    return place;
  }
  const FacePoint in_face = FirstFaceAround(mesh, point);
  for (uint32_t corner = 0; corner < 3; ++corner) {
    narrow(rows_[mesh.triangle(in_face.face)[corner]].steps,
           DistanceToCorner(mesh, in_face, corner) / step_);
  }
  return place;
}

double Landmarks::LowerBound(uint32_t v, const Place& place) const {
  const Steps& steps = rows_[v].steps;
  // The landmarks are all in one part.
  if ((steps[0] == kApart) != place.is_apart) {
    return std::numeric_limits<double>::infinity();
  }
  uint16_t most = 0;
  for (uint32_t l = 0; l < kMost; ++l) {
    const uint16_t before =
        place.before[l] > steps[l] ? place.before[l] - steps[l] : 0;
    const uint16_t beyond =
        steps[l] > place.beyond[l] ? steps[l] - place.beyond[l] : 0;
    most = std::max({most, before, beyond});
  }
  return most > 0 ? (most - kLandmarkRounding) * step_ : 0;
}

absl::StatusOr<Landmarks> MakeLandmarks(const Mesh& mesh, uint32_t count,
                                        const SolveOptions& options,
                                        Checkpoint& checkpoint) {
  Landmarks landmarks(mesh);
  while (!landmarks.HasEnough(count)) {
    const absl::StatusOr<DistanceField> field =
        Solve(mesh, Query{.sources = {{VertexPoint{*landmarks.next()}}}},
              options, checkpoint);
    if (!field.ok()) return field.status();
    landmarks.Add(mesh, field->distances);
  }
  return landmarks;
}

}  // namespace geodesic
