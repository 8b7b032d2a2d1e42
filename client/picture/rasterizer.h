// Finds the triangle that is visible at each sample of the screen.

#ifndef GEODESIC_CLIENT_PICTURE_RASTERIZER_H_
#define GEODESIC_CLIENT_PICTURE_RASTERIZER_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "client/picture/vector3.h"
#include "geodesic_client/mesh.h"

namespace geodesic::client {

inline constexpr uint32_t kNoTriangle = std::numeric_limits<uint32_t>::max();

struct VisibleSample {
  // Depth of the nearest triangle; it grows toward the viewer.
  float depth = -std::numeric_limits<float>::infinity();
  uint32_t triangle = kNoTriangle;
};

// Samples per pixel, across and down.
inline constexpr int kSamples = 2;

// Rows go from the top, samples from the left.
struct VisibilityBuffer {
  VisibilityBuffer(int w, int h)
      : width(w), height(h), samples(static_cast<size_t>(w) * h) {}

  VisibleSample& At(int x, int y) {
    return samples[static_cast<size_t>(y) * width + x];
  }
  const VisibleSample& At(int x, int y) const {
    return samples[static_cast<size_t>(y) * width + x];
  }

  int width;
  int height;
  std::vector<VisibleSample> samples;
};

// False also if x or y is NaN.
bool IsOnScreen(const Vector3& point, const VisibilityBuffer& buffer);

// Whether nothing is in front of a point by more than `tolerance` samples.
// False off the screen.
bool IsVisible(const Vector3& point, double tolerance,
               const VisibilityBuffer& buffer);

// The weights of a triangle's corners at a point of the screen. Their sum is 1,
// and inside the triangle all are >= 0.
using Barycentric = std::array<double, 3>;

// REQUIRES: the triangle has area on the screen.
Barycentric BarycentricAt(const Vector3& a, const Vector3& b, const Vector3& c,
                          double x, double y);

// Draws `triangles` with the corners `screen` (x and y in samples, z toward the
// viewer) into a buffer of the given size. Samples are taken at the middle of
// their square. An edge belongs to both of its triangles, so no seam shows.
// Triangles without area on the screen are not drawn. Linear in the triangles
// and the samples they cover.
VisibilityBuffer Rasterize(const std::vector<Vector3>& screen,
                           const std::vector<Triangle>& triangles, int width,
                           int height);

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_PICTURE_RASTERIZER_H_
