#include "tests/support/oracles/planar_domain.h"

#include <algorithm>
#include <cstdint>
#include <limits>

namespace geodesic::test {
namespace {

constexpr Real kInfinity = std::numeric_limits<Real>::infinity();

// Narrows [t0, t1] to where low < p + t * d < high.
void ClipToSlab(Real p, Real d, Real low, Real high, Real& t0, Real& t1) {
  if (d == 0) {
    if (p <= low || p >= high) t1 = -kInfinity;
    return;
  }
  const Real a = (low - p) / d, b = (high - p) / d;
  t0 = std::max(t0, std::min(a, b));
  t1 = std::min(t1, std::max(a, b));
}

}  // namespace

PlanarDomain::PlanarDomain(const GridOptions& options) {
  const auto inside = [&](uint32_t x, uint32_t y) {
    return x > 0 && x < options.columns && y > 0 && y < options.rows;
  };
  // Rounded as MakeGrid rounds its coordinates.
  const auto to_x = [&](double x) -> Real { return x * options.cell_width; };
  const auto to_y = [&](double y) -> Real { return y * options.cell_height; };
  for (const CellRect& r : options.removed) {
    // An obstacle that reaches the rim goes on beyond it, so that no path
    // slips along the rim.
    obstacles_.push_back({to_x(r.x0 == 0 ? -1.0 : r.x0),
                          to_y(r.y0 == 0 ? -1.0 : r.y0),
                          to_x(r.x1 == options.columns ? r.x1 + 1.0 : r.x1),
                          to_y(r.y1 == options.rows ? r.y1 + 1.0 : r.y1)});
    for (const uint32_t x : {r.x0, r.x1}) {
      for (const uint32_t y : {r.y0, r.y1}) {
        if (inside(x, y)) corners_.push_back({to_x(x), to_y(y)});
      }
    }
  }
}

// Whether the segment misses the inside of every obstacle. A segment that
// grazes a corner may count as blocked through rounding; the path by way of
// that corner then has the same length.
bool PlanarDomain::Visible(Vec2 a, Vec2 b) const {
  const Vec2 d = b - a;
  return std::none_of(obstacles_.begin(), obstacles_.end(), [&](const Rect& r) {
    Real t0 = 0, t1 = 1;
    ClipToSlab(a.x, d.x, r.x0, r.x1, t0, t1);
    ClipToSlab(a.y, d.y, r.y0, r.y1, t0, t1);
    return t0 < t1;
  });
}

std::vector<double> PlanarDomain::Distances(
    const Point& source, std::span<const Point> targets) const {
  const Vec2 s{source[0], source[1]};
  // Bellman-Ford over the corners; there are few.
  std::vector<Real> corner_distance;
  for (const Vec2& c : corners_) {
    corner_distance.push_back(Visible(s, c) ? Norm(c - s) : kInfinity);
  }
  for (size_t round = 0; round < corners_.size(); ++round) {
    for (size_t i = 0; i < corners_.size(); ++i) {
      for (size_t j = 0; j < corners_.size(); ++j) {
        if (!Visible(corners_[i], corners_[j])) continue;
        corner_distance[j] =
            std::min(corner_distance[j],
                     corner_distance[i] + Norm(corners_[i] - corners_[j]));
      }
    }
  }
  std::vector<double> distances;
  for (const Point& target : targets) {
    const Vec2 t{target[0], target[1]};
    Real best = Visible(s, t) ? Norm(t - s) : kInfinity;
    for (size_t i = 0; i < corners_.size(); ++i) {
      if (!Visible(corners_[i], t)) continue;
      best = std::min(best, corner_distance[i] + Norm(corners_[i] - t));
    }
    distances.push_back(static_cast<double>(best));
  }
  return distances;
}

}  // namespace geodesic::test
