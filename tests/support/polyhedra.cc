#include "tests/support/polyhedra.h"

#include <array>
#include <cmath>
#include <map>
#include <numbers>

namespace geodesic::test {

Polyhedron Tetrahedron() {
  return {"tetrahedron",
          {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
          {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}};
}

Polyhedron Octahedron() {
  return {"octahedron",
          {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
          {{0, 2, 4},
           {2, 1, 4},
           {1, 3, 4},
           {3, 0, 4},
           {2, 0, 5},
           {1, 2, 5},
           {3, 1, 5},
           {0, 3, 5}}};
}

Polyhedron Icosahedron() {
  const double phi = std::numbers::phi;
  return {"icosahedron",
          {{-1, phi, 0},
           {1, phi, 0},
           {-1, -phi, 0},
           {1, -phi, 0},
           {0, -1, phi},
           {0, 1, phi},
           {0, -1, -phi},
           {0, 1, -phi},
           {phi, 0, -1},
           {phi, 0, 1},
           {-phi, 0, -1},
           {-phi, 0, 1}},
          {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
           {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
           {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
           {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}}};
}

Polyhedron Box(double a, double b, double c) {
  return {"box",
          {{0, 0, 0},
           {a, 0, 0},
           {a, b, 0},
           {0, b, 0},
           {0, 0, c},
           {a, 0, c},
           {a, b, c},
           {0, b, c}},
          {{0, 3, 2, 1},
           {4, 5, 6, 7},
           {0, 1, 5, 4},
           {1, 2, 6, 5},
           {2, 3, 7, 6},
           {3, 0, 4, 7}}};
}

TriangleSoup Triangulate(const Polyhedron& polyhedron) {
  TriangleSoup soup{.positions = polyhedron.vertices};
  for (const std::vector<uint32_t>& face : polyhedron.faces) {
    for (size_t i = 2; i < face.size(); ++i) {
      soup.triangles.push_back({face[0], face[i - 1], face[i]});
    }
  }
  return soup;
}

TriangleSoup BoxGrid(double a, double b, double c, uint32_t na, uint32_t nb,
                     uint32_t nc) {
  using GridPoint = std::array<uint32_t, 3>;
  const GridPoint counts = {na, nb, nc};
  const Point lengths = {a, b, c};
  TriangleSoup soup;
  std::map<GridPoint, uint32_t> numbers;
  const auto number = [&](const GridPoint& g) {
    const auto [it, is_new] =
        numbers.emplace(g, static_cast<uint32_t>(soup.positions.size()));
    if (is_new) {
      Point& p = soup.positions.emplace_back();
      for (int i = 0; i < 3; ++i) p[i] = lengths[i] * g[i] / counts[i];
    }
    return it->second;
  };
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (const bool far : {false, true}) {
      for (uint32_t i = 0; i < counts[u]; ++i) {
        for (uint32_t j = 0; j < counts[v]; ++j) {
          GridPoint g{};
          g[axis] = far ? counts[axis] : 0;
          std::array<uint32_t, 4> corners;
          for (int k = 0; k < 4; ++k) {
            g[u] = i + (k == 1 || k == 2 ? 1 : 0);
            g[v] = j + (k >= 2 ? 1 : 0);
            corners[far ? k : 3 - k] = number(g);
          }
          soup.triangles.push_back({corners[0], corners[1], corners[2]});
          soup.triangles.push_back({corners[0], corners[2], corners[3]});
        }
      }
    }
  }
  return soup;
}

}  // namespace geodesic::test
