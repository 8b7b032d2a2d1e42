#include "tests/support/oracles/edge_paths.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <sstream>
#include <utility>

namespace geodesic::test {

std::vector<Real> EdgeDistances(const TriangleSoup& soup, uint32_t source) {
  std::vector<std::vector<uint32_t>> neighbours(soup.positions.size());
  for (const Triangle& t : soup.triangles) {
    for (int i = 0; i < 3; ++i) {
      neighbours[t[i]].push_back(t[(i + 1) % 3]);
      neighbours[t[i]].push_back(t[(i + 2) % 3]);
    }
  }
  std::vector<Real> distances(soup.positions.size(),
                              std::numeric_limits<Real>::infinity());
  using Entry = std::pair<Real, uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  distances[source] = 0;
  queue.emplace(0, source);
  while (!queue.empty()) {
    const auto [distance, v] = queue.top();
    queue.pop();
    if (distance > distances[v]) continue;
    for (const uint32_t w : neighbours[v]) {
      const Real through =
          distance + Distance(soup.positions[v], soup.positions[w]);
      if (through >= distances[w]) continue;
      distances[w] = through;
      queue.emplace(through, w);
    }
  }
  return distances;
}

std::optional<std::string> BreachOfEdgeLaw(const Mesh& mesh,
                                           std::span<const double> distances,
                                           double tolerance) {
  const double slack = 4 * CoordinateRounding(mesh.positions());
  double worst = 0;
  std::optional<std::string> breach;
  for (uint32_t face = 0; face < mesh.face_count(); ++face) {
    const Triangle& corners = mesh.triangle(face);
    for (int i = 0; i < 6; ++i) {
      const uint32_t u = corners[i % 3], v = corners[(i + 1 + i / 3) % 3];
      if (std::isinf(distances[u])) continue;
      const double along =
          distances[u] + static_cast<double>(Distance(mesh.positions()[u],
                                                      mesh.positions()[v]));
      const double above = distances[v] - along * (1 + tolerance) - slack;
      if (!(above > worst)) continue;
      worst = above;
      std::ostringstream text;
      text.precision(17);
      text << "vertex " << v << " is at " << distances[v]
           << ", but the edge from vertex " << u << " leads there in " << along;
      breach = text.str();
    }
  }
  return breach;
}

}  // namespace geodesic::test
