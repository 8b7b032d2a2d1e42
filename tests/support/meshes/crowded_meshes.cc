#include "tests/support/meshes/crowded_meshes.h"

#include <cmath>
#include <numbers>

namespace geodesic::test {

TriangleSoup Pages(uint32_t count) {
  TriangleSoup soup{.positions = {{0, 0, 0}, {1, 0, 0}}};
  for (uint32_t i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    soup.positions.push_back({0.5, std::cos(angle), std::sin(angle)});
    soup.triangles.push_back({0, 1, i + 2});
  }
  return soup;
}

TriangleSoup NeedleFan(uint32_t count) {
  TriangleSoup soup{.positions = {{0, 0, 0}}};
  for (uint32_t i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    soup.positions.push_back({std::cos(angle), std::sin(angle), 0});
    soup.triangles.push_back({0, i + 1, (i + 1) % count + 1});
  }
  return soup;
}

TriangleSoup FanInOnePoint(uint32_t count) {
  TriangleSoup soup = NeedleFan(count);
  for (Point& position : soup.positions) position = {0, 0, 0};
  return soup;
}

TriangleSoup FinnedStrip(uint32_t count) {
  TriangleSoup soup;
  for (uint32_t i = 0; i <= count; ++i) {
    const double x = i;
    soup.positions.push_back({x, 0, 0});
    soup.positions.push_back({x, 1, 0});
  }
  const auto add_fin = [&](uint32_t from, uint32_t to) {
    const Point& a = soup.positions[from];
    const Point& b = soup.positions[to];
    const auto top = static_cast<uint32_t>(soup.positions.size());
    soup.positions.push_back({(a[0] + b[0]) / 2, 0.5, 1});
    soup.triangles.push_back({from, to, top});
  };
  for (uint32_t i = 0; i < count; ++i) {
    const uint32_t a = 2 * i, b = a + 1, c = a + 2, d = a + 3;
    soup.triangles.push_back({a, c, b});
    soup.triangles.push_back({b, c, d});
    add_fin(b, c);
    if (i > 0) add_fin(a, b);
  }
  return soup;
}

TriangleSoup AllTriangles(uint32_t count) {
  TriangleSoup soup;
  for (uint32_t a = 0; a < count; ++a) {
    const double x = a;
    soup.positions.push_back(
        {x, 1e-3 * std::sin(7 * x), 1e-3 * std::cos(5 * x)});
    for (uint32_t b = 0; b < a; ++b) {
      for (uint32_t c = 0; c < b; ++c) soup.triangles.push_back({a, b, c});
    }
  }
  return soup;
}

}  // namespace geodesic::test
