#include "tests/integration/meshes.h"

#include <cmath>
#include <sstream>

namespace geodesic::client {

MeshArrays PlanarGrid(uint32_t n) {
  MeshArrays mesh;
  for (uint32_t j = 0; j <= n; ++j) {
    for (uint32_t i = 0; i <= n; ++i) {
      mesh.positions.push_back(
          {static_cast<double>(i) / n, static_cast<double>(j) / n, 0});
    }
  }
  for (uint32_t j = 0; j < n; ++j) {
    for (uint32_t i = 0; i < n; ++i) {
      const uint32_t a = i + j * (n + 1);
      const uint32_t b = a + n + 1;
      mesh.triangles.push_back({a, a + 1, b + 1});
      mesh.triangles.push_back({a, b + 1, b});
    }
  }
  return mesh;
}

MeshArrays HillyGrid(uint32_t n) {
  MeshArrays mesh = PlanarGrid(n);
  for (Point& point : mesh.positions) {
    point[2] = 0.05 * std::sin(23 * point[0]) * std::cos(19 * point[1]) +
               0.01 * std::sin(97 * point[0] + 61 * point[1]);
  }
  return mesh;
}

std::string OffText(const MeshArrays& mesh) {
  std::ostringstream text;
  text.precision(17);
  text << "OFF\n"
       << mesh.positions.size() << ' ' << mesh.triangles.size() << " 0\n";
  for (const Point& p : mesh.positions) {
    text << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
  }
  for (const Triangle& t : mesh.triangles) {
    text << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << '\n';
  }
  return text.str();
}

}  // namespace geodesic::client
