// Vectors in the plane and in space, in long double: what the oracles compute
// with.

#ifndef GEODESIC_TESTS_SUPPORT_VEC_H_
#define GEODESIC_TESTS_SUPPORT_VEC_H_

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "geodesic/triangle_soup.h"

namespace geodesic::test {

using Real = long double;

struct Vec2 {
  Real x = 0, y = 0;
};

inline Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
inline Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
inline Vec2 operator*(Real s, Vec2 a) { return {s * a.x, s * a.y}; }
inline Real Dot(Vec2 a, Vec2 b) { return a.x * b.x + a.y * b.y; }
inline Real Cross(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }
inline Real Norm(Vec2 a) { return std::hypot(a.x, a.y); }
// `a` turned left by a right angle.
inline Vec2 Perpendicular(Vec2 a) { return {-a.y, a.x}; }

struct Vec3 {
  Real x = 0, y = 0, z = 0;
};

inline Vec3 ToVec3(const Point& p) { return {p[0], p[1], p[2]}; }
inline Vec3 operator+(Vec3 a, Vec3 b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vec3 operator-(Vec3 a, Vec3 b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vec3 operator*(Real s, Vec3 a) { return {s * a.x, s * a.y, s * a.z}; }
inline Real Dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec3 Cross(Vec3 a, Vec3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Real Norm(Vec3 a) { return std::hypot(a.x, a.y, a.z); }

inline Real Distance(const Point& a, const Point& b) {
  return Norm(ToVec3(a) - ToVec3(b));
}

// The rounding of the largest coordinate: distances between points that lie so
// close together are known no better.
inline double CoordinateRounding(std::span<const Point> points) {
  double largest = 0;
  for (const Point& p : points) {
    for (const double c : p) largest = std::max(largest, std::abs(c));
  }
  return largest * std::numeric_limits<double>::epsilon();
}

}  // namespace geodesic::test

#endif  // GEODESIC_TESTS_SUPPORT_VEC_H_
