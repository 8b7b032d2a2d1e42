#include "client/picture/rasterizer.h"

#include <algorithm>
#include <cmath>

namespace geodesic::client {
namespace {

// Twice the signed area of a triangle on the screen.
double Area2(const Vector3& a, const Vector3& b, const Vector3& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// A triangle with less than this, in samples squared, is seen edge-on.
constexpr double kLeastArea2 = 1e-12;

// The first sample whose middle is not before `position`.
int FirstSample(double position, int count) {
  return static_cast<int>(
      std::clamp(std::ceil(position - 0.5), 0.0, static_cast<double>(count)));
}

void DrawTriangle(const Vector3& a, const Vector3& b, const Vector3& c,
                  uint32_t triangle, VisibilityBuffer* buffer) {
  const double area2 = Area2(a, b, c);
  if (!(std::abs(area2) > kLeastArea2)) return;
  const int x_begin = FirstSample(std::min({a.x, b.x, c.x}), buffer->width);
  const int x_end = FirstSample(
      std::nextafter(std::max({a.x, b.x, c.x}), INFINITY), buffer->width);
  const int y_begin = FirstSample(std::min({a.y, b.y, c.y}), buffer->height);
  const int y_end = FirstSample(
      std::nextafter(std::max({a.y, b.y, c.y}), INFINITY), buffer->height);
  if (x_begin == x_end) return;

  // Corner weights are affine on the screen. These are their steps per sample.
  const double step_b = (c.y - a.y) / area2;
  const double step_c = -(b.y - a.y) / area2;
  // Along a common edge the weights of neighbours differ by rounding.
  constexpr double kSlack = -1e-9;
  for (int y = y_begin; y < y_end; ++y) {
    const Barycentric first = BarycentricAt(a, b, c, x_begin + 0.5, y + 0.5);
    for (int x = x_begin; x < x_end; ++x) {
      const double weight_b = first[1] + (x - x_begin) * step_b;
      const double weight_c = first[2] + (x - x_begin) * step_c;
      const double weight_a = 1 - weight_b - weight_c;
      if (weight_a < kSlack || weight_b < kSlack || weight_c < kSlack) continue;
      const auto depth =
          static_cast<float>(weight_a * a.z + weight_b * b.z + weight_c * c.z);
      VisibleSample& sample = buffer->At(x, y);
      if (depth > sample.depth) sample = {depth, triangle};
    }
  }
}

}  // namespace

bool IsOnScreen(const Vector3& point, const VisibilityBuffer& buffer) {
  return point.x >= 0 && point.x < buffer.width && point.y >= 0 &&
         point.y < buffer.height;
}

bool IsVisible(const Vector3& point, double tolerance,
               const VisibilityBuffer& buffer) {
  if (!IsOnScreen(point, buffer)) return false;
  const VisibleSample& sample =
      buffer.At(static_cast<int>(point.x), static_cast<int>(point.y));
  return point.z + tolerance >= sample.depth;
}

Barycentric BarycentricAt(const Vector3& a, const Vector3& b, const Vector3& c,
                          double x, double y) {
  const double area2 = Area2(a, b, c);
  const double weight_b =
      ((x - a.x) * (c.y - a.y) - (y - a.y) * (c.x - a.x)) / area2;
  const double weight_c =
      ((b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x)) / area2;
  return {1 - weight_b - weight_c, weight_b, weight_c};
}

VisibilityBuffer Rasterize(const std::vector<Vector3>& screen,
                           const std::vector<Triangle>& triangles, int width,
                           int height) {
  VisibilityBuffer buffer(width, height);
  for (uint32_t triangle = 0; triangle < triangles.size(); ++triangle) {
    const Triangle& corners = triangles[triangle];
    DrawTriangle(screen[corners[0]], screen[corners[1]], screen[corners[2]],
                 triangle, &buffer);
  }
  return buffer;
}

}  // namespace geodesic::client
