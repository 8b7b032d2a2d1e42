#include "tests/support/edge_law.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "tests/support/vec.h"

namespace geodesic::test {

std::optional<std::string> BreachOfEdgeLaw(const Mesh& mesh,
                                           std::span<const double> distances,
                                           double tolerance) {
  double largest = 0;
  for (const Point& p : mesh.positions()) {
    for (const double c : p) largest = std::max(largest, std::abs(c));
  }
  const double slack = 4 * largest * std::numeric_limits<double>::epsilon();
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
