#include "tests/support/edge_dijkstra.h"

#include <functional>
#include <limits>
#include <queue>
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

}  // namespace geodesic::test
