#include "solver/targets.h"

#include <algorithm>
#include <cmath>

namespace geodesic {

Targets::Targets(const Mesh& mesh, std::span<const SurfacePoint> targets)
    : mesh_(&mesh), targets_(targets.size()) {
  for (uint32_t t = 0; t < targets.size(); ++t) {
    Target& target = targets_[t];
    if (const auto* vertex = std::get_if<VertexPoint>(&targets[t])) {
      target.vertex = vertex->vertex;
      continue;
    }
    // For a point on an edge any face will do: whatever leads to the point from
    // another one is a window into this.
    target.point = FirstFaceAround(mesh, targets[t]);
    uint32_t& first =
        first_in_slot_.try_emplace(mesh.FirstSide(target.point.face) / 3, kNone)
            .first->second;
    target.next = first;
    first = t;
  }
}

Targets::ThroughCorner Targets::NearestCorner(
    const Target& target, std::span<const double> distances) const {
  ThroughCorner best{kNone, std::numeric_limits<double>::infinity()};
  for (uint32_t corner = 0; corner < 3; ++corner) {
    const uint32_t v = mesh_->triangle(target.point.face)[corner];
    const double distance =
        distances[v] + DistanceToCorner(*mesh_, target.point, corner);
    if (distance < best.distance) best = {v, distance};
  }
  return best;
}

double Targets::Distance(size_t t,
                         std::span<const double> vertex_distances) const {
  const Target& target = targets_[t];
  if (target.vertex != kNone) return vertex_distances[target.vertex];
  return std::min(target.distance,
                  NearestCorner(target, vertex_distances).distance);
}

uint32_t Targets::AccountHolder(
    size_t t, std::span<const double> vertex_distances) const {
  const Target& target = targets_[t];
  if (target.vertex != kNone) return target.vertex;
  const ThroughCorner corner = NearestCorner(target, vertex_distances);
  return corner.distance < target.distance ? corner.vertex
                                           : target.arrival.pseudo_source;
}

Arrival Targets::ArrivalAt(size_t t, std::span<const double> vertex_distances,
                           std::span<const Arrival> vertex_arrivals) const {
  const Target& target = targets_[t];
  if (target.vertex != kNone) return vertex_arrivals[target.vertex];
  const ThroughCorner corner = NearestCorner(target, vertex_distances);
  // At a tie straight on: the corner may be one that paths only pass by.
  if (corner.distance < target.distance * (1 - kDominance)) {
    return {.pseudo_source = corner.vertex};
  }
  return target.arrival;
}

}  // namespace geodesic
