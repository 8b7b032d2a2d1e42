// A polygon as it looks from above its plane.

#ifndef GEODESIC_POLYGONS_FLAT_POLYGON_H_
#define GEODESIC_POLYGONS_FLAT_POLYGON_H_

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

#include "geodesic/triangle_soup.h"
#include "tolerances.h"

namespace geodesic {

// A place in the plane, or the way from one to another.
struct Flat {
  double x = 0;
  double y = 0;

  friend Flat operator-(const Flat& a, const Flat& b) {
    return {a.x - b.x, a.y - b.y};
  }
  friend bool operator==(const Flat& a, const Flat& b) = default;
  // From left to right, and upwards where they are above each other.
  friend bool operator<(const Flat& a, const Flat& b) {
    return a.x != b.x ? a.x < b.x : a.y < b.y;
  }
};

inline double Dot(const Flat& a, const Flat& b) {
  return a.x * b.x + a.y * b.y;
}

// Above 0 if `b` points to the left of `a`, below if to the right, 0 if it
// points along the line: if the tip of the shorter is no farther from the line
// of the longer than `slack`.
inline double Turn(const Flat& a, const Flat& b,
                   double slack = kStraightCorner) {
  const double cross = a.x * b.y - a.y * b.x;
  const double longest = std::max(Dot(a, a), Dot(b, b));
  return cross * cross <= slack * slack * longest ? 0 : cross;
}

// The corners of a polygon seen from the side to which it turns left, in a unit
// in which its largest coordinate lies in [1, 2).
class FlatPolygon {
 public:
  // `corners` are vertices of `positions`; both must stay. `unit` is what
  // coordinates are multiplied with, `normal` of length 1.
  FlatPolygon(const Point* positions, std::span<const uint32_t> corners,
              double unit, const std::array<double, 3>& normal);

  uint32_t size() const { return static_cast<uint32_t>(corners_.size()); }
  uint32_t vertex(uint32_t corner) const { return corners_[corner]; }
  uint32_t Next(uint32_t corner) const {
    return corner + 1 == size() ? 0 : corner + 1;
  }
  uint32_t Previous(uint32_t corner) const {
    return (corner == 0 ? size() : corner) - 1;
  }

  // Where a corner lies; the same for all corners at one vertex.
  Flat At(uint32_t corner) const {
    const std::array<double, 3> way = FromFirst(corner);
    return {way[0] * x_[0] + way[1] * x_[1] + way[2] * x_[2],
            way[0] * y_[0] + way[1] * y_[1] + way[2] * y_[2]};
  }

  // The squared distance of two corners in space, without regard to order.
  double SquaredDistance(uint32_t a, uint32_t b) const {
    double sum = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double part = positions_[corners_[a]][axis] * unit_ -
                          positions_[corners_[b]][axis] * unit_;
      sum += part * part;
    }
    return sum;
  }

 private:
  std::array<double, 3> FromFirst(uint32_t corner) const {
    const Point& point = positions_[corners_[corner]];
    return {point[0] * unit_ - first_[0], point[1] * unit_ - first_[1],
            point[2] * unit_ - first_[2]};
  }

  const Point* const positions_;
  const std::span<const uint32_t> corners_;
  const double unit_;
  Point first_;
  std::array<double, 3> x_;
  std::array<double, 3> y_;
};

inline FlatPolygon::FlatPolygon(const Point* positions,
                                std::span<const uint32_t> corners, double unit,
                                const std::array<double, 3>& normal)
    : positions_(positions), corners_(corners), unit_(unit) {
  for (int axis = 0; axis < 3; ++axis) {
    first_[axis] = positions[corners[0]][axis] * unit;
  }
  // Duff et al., "Building an orthonormal basis, revisited" (2017).
  const auto [x, y, z] = normal;
  const double sign = std::copysign(1.0, z);
  const double a = -1 / (sign + z);
  const double b = x * y * a;
  const std::array<double, 3> u = {1 + sign * x * x * a, sign * b, -sign * x};
  const std::array<double, 3> v = {b, sign + y * y * a, -y};
  // Turned by an angle that no drawing has, so that hardly any side is upright:
  // of those, rounding would say which end is on the left.
  const double cosine = std::cos(1.0);
  const double sine = std::sin(1.0);
  for (int axis = 0; axis < 3; ++axis) {
    x_[axis] = cosine * u[axis] + sine * v[axis];
    y_[axis] = cosine * v[axis] - sine * u[axis];
  }
}

}  // namespace geodesic

#endif  // GEODESIC_POLYGONS_FLAT_POLYGON_H_
