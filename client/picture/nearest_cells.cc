#include "client/picture/nearest_cells.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace geodesic::client {
namespace {

double Between(const Point& p, const Point& q) {
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

}  // namespace

NearestCells::NearestCells(const MeshArrays& mesh,
                           std::span<const double> distances,
                           std::span<const uint32_t> nearest_sources)
    : mesh_(mesh), distances_(distances), nearest_sources_(nearest_sources) {
  // The second round uses the distances that the first round has found.
  for (int round = 0; round < 2; ++round) {
    for (const Triangle& triangle : mesh.triangles) Relax(triangle);
  }
}

void NearestCells::Relax(const Triangle& triangle) {
  for (int i = 0; i < 3; ++i) {
    const uint32_t v = triangle[i];
    const uint32_t a = triangle[(i + 1) % 3];
    const uint32_t b = triangle[(i + 2) % 3];
    for (const uint32_t source : {nearest_sources_[a], nearest_sources_[b]}) {
      if (source == nearest_sources_[v]) continue;
      const double distance = Unfolded(v, a, b, source);
      if (!std::isfinite(distance)) continue;
      const auto [known, is_new] = others_.try_emplace({v, source}, distance);
      known->second = std::min(known->second, distance);
    }
  }
}

double NearestCells::Distance(uint32_t vertex, uint32_t source) const {
  if (nearest_sources_[vertex] == source) return distances_[vertex];
  const auto known = others_.find({vertex, source});
  return known == others_.end() ? std::numeric_limits<double>::infinity()
                                : known->second;
}

double NearestCells::Unfolded(uint32_t vertex, uint32_t a, uint32_t b,
                              uint32_t source) const {
  const Point& v = mesh_.positions[vertex];
  const double from_a = Distance(a, source);
  const double from_b = Distance(b, source);
  const double va = Between(v, mesh_.positions[a]);
  const double vb = Between(v, mesh_.positions[b]);
  const double along_edges = std::min(from_a + va, from_b + vb);
  const double base = Between(mesh_.positions[a], mesh_.positions[b]);
  const double unit = std::max({from_a, from_b, va, vb, base});
  if (!std::isfinite(unit) || !(base > 0)) return along_edges;
  // In the plane, a is at 0, b on the x-axis, v above it, the source below.
  const double c = base / unit;
  const auto place = [c, unit](double to_a, double to_b) {
    to_a /= unit;
    to_b /= unit;
    const double x = (to_a * to_a - to_b * to_b + c * c) / (2 * c);
    return std::pair(x, std::sqrt(std::max(0.0, to_a * to_a - x * x)));
  };
  const auto [vx, vy] = place(va, vb);
  const auto [sx, sy] = place(from_a, from_b);
  // Where the straight line between v and the source crosses the side.
  const double crossing = vy + sy > 0 ? sx + (vx - sx) * sy / (vy + sy) : sx;
  if (!(crossing >= 0 && crossing <= c)) return along_edges;
  return std::min(along_edges, unit * std::hypot(vx - sx, vy + sy));
}

NearestCells::Nearest NearestCells::At(const Triangle& triangle,
                                       const Barycentric& weights) const {
  const std::array<uint32_t, 3> sources = {nearest_sources_[triangle[0]],
                                           nearest_sources_[triangle[1]],
                                           nearest_sources_[triangle[2]]};
  const bool is_mixed = sources[0] != sources[1] || sources[0] != sources[2];
  std::array<Nearest, 3> candidates;
  double largest = 0;
  for (int i = 0; i < 3; ++i) {
    candidates[i].source = sources[i];
    for (int corner = 0; corner < 3; ++corner) {
      const double d = Distance(triangle[corner], sources[i]);
      candidates[i].corner_distances[corner] = d;
      largest = std::max(largest, d);
    }
    if (!is_mixed) return candidates[0];
  }
  const auto square = [&](const Nearest& candidate) {
    const std::array<double, 3>& d = candidate.corner_distances;
    const double a = d[0] / largest;
    const double b = d[1] / largest;
    const double c = d[2] / largest;
    return weights[0] * a * a + weights[1] * b * b + weights[2] * c * c;
  };
  return *std::ranges::min_element(candidates, {}, square);
}

}  // namespace geodesic::client
