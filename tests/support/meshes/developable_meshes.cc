#include "tests/support/meshes/developable_meshes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/support/meshes/planar_meshes.h"
#include "tests/support/random.h"

namespace geodesic::test {
namespace {

constexpr double kPi = std::numbers::pi;

// Unit vectors for the spokes, with `sector` between neighbours: they go round
// the z axis in equal steps, alternately up and down where equal steps alone
// would be too narrow.
std::vector<Point> SpokeDirections(const FanOptions& options, uint32_t count) {
  const double sector = options.total_angle / options.spokes;
  const double turn =
      options.closed ? 2 * kPi : std::min(options.total_angle, 2 * kPi);
  const double step = turn / options.spokes;
  // All at one height: chord = 2 sin(sector/2) = 2 rho sin(step/2).
  double rho = std::sin(sector / 2) / std::sin(step / 2);
  const bool zigzag = rho > 1;
  if (zigzag) rho = std::cos(sector / 2) / std::cos(step / 2);
  const double height = std::sqrt(std::max(0.0, 1 - rho * rho));
  std::vector<Point> directions;
  for (uint32_t i = 0; i < count; ++i) {
    directions.push_back({rho * std::cos(i * step), rho * std::sin(i * step),
                          zigzag && i % 2 == 1 ? -height : height});
  }
  return directions;
}

}  // namespace

Fan::Fan(const FanOptions& options) : options_(options) {
  const uint32_t count = options.spokes + (options.closed ? 0 : 1);
  const std::vector<Point> directions = SpokeDirections(options, count);
  soup_.positions.push_back({0, 0, 0});
  radius_.push_back(0);
  angle_.push_back(0);
  for (uint32_t ring = 1; ring <= options.rings; ++ring) {
    for (uint32_t i = 0; i < count; ++i) {
      const Point& d = directions[i];
      soup_.positions.push_back({ring * d[0], ring * d[1], ring * d[2]});
      radius_.push_back(ring);
      angle_.push_back(options.total_angle * i / options.spokes);
    }
  }
  for (uint32_t ring = 1; ring <= options.rings; ++ring) {
    for (uint32_t i = 0; i < options.spokes; ++i) {
      const uint32_t outer = 1 + (ring - 1) * count, inner = outer - count;
      const uint32_t next = (i + 1) % count;
      if (ring == 1) {
        soup_.triangles.push_back({0, outer + i, outer + next});
      } else {
        soup_.triangles.push_back({inner + i, outer + i, outer + next});
        soup_.triangles.push_back({inner + i, outer + next, inner + next});
      }
    }
  }
}

double Fan::Distance(uint32_t v, uint32_t w) const {
  double angle = std::abs(angle_[v] - angle_[w]);
  if (options_.closed) angle = std::min(angle, options_.total_angle - angle);
  const double r = radius_[v], s = radius_[w];
  if (angle >= kPi) return r + s;
  // sqrt(r^2 + s^2 - 2 r s cos(angle)) without cancellation.
  const double half_sine = std::sin(angle / 2);
  return std::hypot(r - s, 2 * std::sqrt(r * s) * half_sine);
}

Prism::Prism(const PrismOptions& options) : options_(options) {
  const double radius =
      options.side_length / (2 * std::sin(kPi / options.sides));
  for (uint32_t y = 0; y <= options.rows; ++y) {
    for (uint32_t i = 0; i < options.sides; ++i) {
      const double angle = 2 * kPi * i / options.sides;
      soup_.positions.push_back({radius * std::cos(angle),
                                 radius * std::sin(angle),
                                 y * options.row_height});
    }
  }
  for (uint32_t y = 0; y < options.rows; ++y) {
    for (uint32_t i = 0; i < options.sides; ++i) {
      const uint32_t next = (i + 1) % options.sides;
      const uint32_t a = y * options.sides + i, b = y * options.sides + next;
      const uint32_t c = b + options.sides, d = a + options.sides;
      soup_.triangles.push_back({a, b, c});
      soup_.triangles.push_back({a, c, d});
    }
  }
}

double Prism::Distance(uint32_t v, uint32_t w) const {
  const uint32_t n = options_.sides;
  const uint32_t steps = v % n > w % n ? v % n - w % n : w % n - v % n;
  const double across = std::min(steps, n - steps) * options_.side_length;
  const double up = std::abs(static_cast<double>(v / n) - w / n);
  return std::hypot(across, up * options_.row_height);
}

FoldedSheet::FoldedSheet(uint32_t columns, uint32_t rows, uint64_t seed) {
  Random random(seed);
  soup_ = MakeGrid({.columns = columns,
                    .rows = rows,
                    .cell_width = 0.7,
                    .diagonals = Diagonals::kRandom,
                    .seed = seed});
  flat_ = soup_.positions;
  // Column i becomes the point (x, z) of a polyline with steps of one width.
  std::vector<Point> profile = {{0, 0, 0}};
  for (uint32_t i = 0; i < columns; ++i) {
    const double slope = random.Uniform(-1.5, 1.5);
    const Point& last = profile.back();
    profile.push_back(
        {last[0] + 0.7 * std::cos(slope), 0, last[2] + 0.7 * std::sin(slope)});
  }
  for (size_t v = 0; v < flat_.size(); ++v) {
    const Point& p = profile[v % (columns + 1)];
    soup_.positions[v] = {p[0], flat_[v][1], p[2]};
  }
}

double FoldedSheet::Distance(uint32_t v, uint32_t w) const {
  return std::hypot(flat_[v][0] - flat_[w][0], flat_[v][1] - flat_[w][1]);
}

}  // namespace geodesic::test
