#include "geodesic/settled_vertices.h"

#include <algorithm>
#include <limits>
#include <tuple>

namespace geodesic {

std::vector<SettledVertex> SettledVertices::Collect(const Progress& progress) {
  given_.resize(progress.distances.size());
  std::vector<SettledVertex> settled;
  // Before the wavefront moves not even the sources have their distances.
  if (progress.settled_radius <= 0) return settled;
  for (uint32_t v = 0; v < progress.distances.size(); ++v) {
    const double distance = progress.distances[v] * progress.unit;
    if (!given_[v] && distance <= progress.settled_radius &&
        distance < std::numeric_limits<double>::infinity()) {
      given_[v] = true;
      settled.push_back({v, distance});
    }
  }
  for (const auto& [vertex, into] : mesh_->reading().joined) {
    if (given_[vertex] || !given_[into]) continue;
    given_[vertex] = true;
    settled.push_back({vertex, progress.distances[into] * progress.unit});
  }
  std::ranges::sort(settled, {}, [](const SettledVertex& vertex) {
    return std::tie(vertex.distance, vertex.vertex);
  });
  return settled;
}

}  // namespace geodesic
