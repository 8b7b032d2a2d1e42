#include "tests/support/oracles/planar_oracles.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <set>
#include <utility>

namespace geodesic::test {

namespace {

using Place = std::array<double, 2>;

double Cross(const Place& a, const Place& b, const Place& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

Place At(const TriangleSoup& soup, uint32_t v) {
  return {soup.positions[v][0], soup.positions[v][1]};
}

}  // namespace

SurfacePoint Locate(const TriangleSoup& soup, const Place& p) {
  constexpr double kOn = 1e-13;
  for (uint32_t f = 0; f < soup.triangles.size(); ++f) {
    const Triangle& t = soup.triangles[f];
    const Place a = At(soup, t[0]), b = At(soup, t[1]), c = At(soup, t[2]);
    const double area = Cross(a, b, c);
    std::array<double, 3> w = {Cross(p, b, c) / area, Cross(p, c, a) / area,
                               Cross(p, a, b) / area};
    if (*std::min_element(w.begin(), w.end()) < -kOn) continue;
    for (double& weight : w) {
      if (std::abs(weight) < kOn) weight = 0;
    }
    const double sum = w[0] + w[1] + w[2];
    for (double& weight : w) weight /= sum;
    return FacePoint{f, w};
  }
  std::abort();  // the curve leaves the mesh
}

double DistanceTo(const PlanarCurve& curve, const Point& p) {
  double least = std::numeric_limits<double>::infinity();
  for (size_t i = 0; i < curve.corners.size(); ++i) {
    const Place& a = curve.corners[i];
    const Place& b = curve.corners[std::min(i + 1, curve.corners.size() - 1)];
    const double dx = b[0] - a[0], dy = b[1] - a[1];
    const double squared = dx * dx + dy * dy;
    const double t =
        squared == 0
            ? 0
            : std::clamp(((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / squared,
                         0.0, 1.0);
    least =
        std::min(least, std::hypot(p[0] - a[0] - t * dx, p[1] - a[1] - t * dy));
  }
  return curve.offset + least;
}

Source OnMesh(const TriangleSoup& soup, const PlanarCurve& curve) {
  constexpr double kSame = 1e-12;
  Curve on_mesh;
  on_mesh.points.push_back(Locate(soup, curve.corners[0]));
  for (size_t i = 1; i < curve.corners.size(); ++i) {
    const Place &p = curve.corners[i - 1], &q = curve.corners[i];
    const double dx = q[0] - p[0], dy = q[1] - p[1];
    // Which part of the way from p to q.
    const auto along = [&](const Place& at) {
      return ((at[0] - p[0]) * dx + (at[1] - p[1]) * dy) / (dx * dx + dy * dy);
    };
    std::set<std::pair<double, std::pair<uint32_t, uint32_t>>> crossings;
    for (const Triangle& t : soup.triangles) {
      for (int side = 0; side < 3; ++side) {
        const auto [from, to] = std::minmax(t[side], t[(side + 1) % 3]);
        const Place u = At(soup, from), w = At(soup, to);
        const double a = Cross(p, q, u), b = Cross(p, q, w);
        if ((a > kSame && b > kSame) || (a < -kSame && b < -kSame)) continue;
        if (std::abs(a) <= kSame && std::abs(b) <= kSame) {
          // Along the edge: its ends are corners of the way.
          crossings.insert({along(u), {from, from}});
          crossings.insert({along(w), {to, to}});
          continue;
        }
        const double t_edge = a / (a - b);
        const Place x = {u[0] + t_edge * (w[0] - u[0]),
                         u[1] + t_edge * (w[1] - u[1])};
        const bool at_from = t_edge < kSame, at_to = 1 - t_edge < kSame;
        crossings.insert({along(x), {at_to ? to : from, at_from ? from : to}});
      }
    }
    double last = 0;
    for (const auto& [s, edge] : crossings) {
      if (s <= last + kSame || s >= 1 - kSame) continue;
      last = s;
      if (edge.first == edge.second) {
        on_mesh.points.push_back(VertexPoint{edge.first});
        continue;
      }
      const double a = Cross(p, q, At(soup, edge.first));
      const double b = Cross(p, q, At(soup, edge.second));
      on_mesh.points.push_back(EdgePoint{edge.first, edge.second, a / (a - b)});
    }
    on_mesh.points.push_back(Locate(soup, q));
  }
  return {std::move(on_mesh), curve.offset};
}

}  // namespace geodesic::test
