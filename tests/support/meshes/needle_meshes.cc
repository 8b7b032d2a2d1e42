#include "tests/support/meshes/needle_meshes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

namespace geodesic::test {

TriangleSoup NeedleRows(Random& random) {
  const uint32_t rows = 2 + random.Below(4), columns = 2 + random.Below(5);
  TriangleSoup soup;
  double y = 0;
  for (uint32_t row = 0; row <= rows; ++row) {
    const bool is_rim = row == 0 || row == rows;
    const double uneven = random.Below(2) * random.OfAnySize(1e-10, 1e-5);
    for (uint32_t column = 0; column <= columns; ++column) {
      soup.positions.push_back({column + random.Uniform(-0.9, 0.9),
                                y + uneven * random.Uniform(0, 1),
                                is_rim ? random.Uniform(-1, 1) : 0});
    }
    y += row == 0 || row == rows - 1 ? 1 : random.OfAnySize(1e-10, 1e-3);
  }
  for (uint32_t row = 0; row < rows; ++row) {
    for (uint32_t column = 0; column < columns; ++column) {
      const uint32_t a = row * (columns + 1) + column, b = a + 1;
      const uint32_t d = a + columns + 1, c = d + 1;
      if (random.Below(2) == 0) {
        soup.triangles.push_back({a, b, c});
        soup.triangles.push_back({a, c, d});
      } else {
        soup.triangles.push_back({a, b, d});
        soup.triangles.push_back({b, c, d});
      }
    }
  }
  return soup;
}

TriangleSoup NeedleBook(Random& random) {
  const uint32_t columns = 1 + random.Below(3);
  TriangleSoup soup;
  for (uint32_t i = 0; i <= columns; ++i) {
    soup.positions.push_back({i + random.Uniform(-0.2, 0.2), 0, 0});
  }
  const auto add = [&](Triangle face) {
    if (random.Below(2) == 0) std::swap(face[0], face[1]);
    soup.triangles.push_back(face);
  };
  for (uint32_t pages = 2 + random.Below(5); pages > 0; --pages) {
    const auto rim = static_cast<uint32_t>(soup.positions.size());
    const double angle =
        random.Below(3) == 0 ? 0 : random.Uniform(0, 2 * std::numbers::pi);
    const double height =
        random.Below(2) == 0 ? 1 : random.OfAnySize(1e-12, 0.1);
    for (uint32_t i = 0; i <= columns; ++i) {
      const double y = height * random.Uniform(0.5, 1.5);
      soup.positions.push_back({i + random.Uniform(-0.7, 0.7),
                                y * std::cos(angle), y * std::sin(angle)});
    }
    uint32_t layers = 1;
    layers += random.Below(3) == 0;
    layers += random.Below(6) == 0;
    for (; layers > 0; --layers) {
      for (uint32_t i = 0; i < columns; ++i) {
        add({i, i + 1, rim + i});
        add({i + 1, rim + i + 1, rim + i});
      }
    }
  }
  return soup;
}

SurfacePoint PointBesideCorner(const Mesh& mesh, Random& random) {
  const uint32_t face = random.Below(mesh.face_count());
  const double near = random.OfAnySize(1e-13, 1e-4);
  double a = random.Uniform(0, 1), b = (1 - a) * random.Uniform(0, 1);
  switch (random.Below(4)) {
    case 0:
      return VertexPoint{random.Below(mesh.vertex_count())};
    case 1:
      break;
    case 2:  // beside an edge
      a *= 1 - near;
      b = 1 - near - a;
      break;
    default:
      a = 1 - near - near * a;
      b = near * random.Uniform(0, 1);
  }
  std::array<double, 3> weights = {a, b, 1 - a - b};
  std::rotate(weights.begin(), weights.begin() + random.Below(3),
              weights.end());
  return FacePoint{face, weights};
}

}  // namespace geodesic::test
