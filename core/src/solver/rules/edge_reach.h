// How far the farthest point is at the most: by way of the edges.

#ifndef GEODESIC_SOLVER_RULES_EDGE_REACH_H_
#define GEODESIC_SOLVER_RULES_EDGE_REACH_H_

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

#include "solver/rules/front.h"

namespace geodesic {

// No point of the surface that paths lead to is farther than this, given the
// vertices that `front` has reached: each has a way to it along edges to a
// corner of its face and from there no farther than a side of that face.
// O(n log n) (Dijkstra).
template <typename Front>
double EdgeReach(const Front& front) {
  const Mesh& mesh = front.mesh();
  using Reached = std::pair<double, uint32_t>;
  std::priority_queue<Reached, std::vector<Reached>, std::greater<>> next;
  std::vector<double> distances(mesh.vertex_count());
  for (uint32_t v = 0; v < mesh.vertex_count(); ++v) {
    distances[v] = front.distance(v);
    if (std::isfinite(distances[v])) next.emplace(distances[v], v);
  }
  double reach = 0;
  while (!next.empty()) {
    const double distance = next.top().first;
    const uint32_t v = next.top().second;
    next.pop();
    if (distance > distances[v]) continue;
    reach = std::max(reach, distance);
    const auto relax = [&](uint32_t to, double length) {
      reach = std::max(reach, distance + length);
      if (distance + length >= distances[to]) return;
      distances[to] = distance + length;
      next.emplace(distances[to], to);
    };
    for (HalfEdge h : mesh.Outgoing(v)) {
      relax(mesh.To(h), mesh.frame(h).length);
      relax(mesh.Apex(h), mesh.frame(Prev(h)).length);
    }
  }
  return reach;
}

}  // namespace geodesic

#endif  // GEODESIC_SOLVER_RULES_EDGE_REACH_H_
