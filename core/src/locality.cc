#include "locality.h"

#include <algorithm>
#include <utility>

namespace geodesic {
namespace {

// Cells along the longest side of the box around the mesh.
constexpr double kCells = 65536;

// Puts two empty bits after each of the 16 bits of x.
uint64_t Spread(uint64_t x) {
  x = (x | x << 16) & 0x0000ff0000ff;
  x = (x | x << 8) & 0x00f00f00f00f;
  x = (x | x << 4) & 0x0c30c30c30c3;
  return (x | x << 2) & 0x249249249249;
}

// Where along the curve a point of the unit cube lies.
uint64_t AlongCurve(const Point& point) {
  uint64_t key = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double cell = std::clamp(point[axis] * kCells, 0.0, kCells - 1);
    key |= Spread(static_cast<uint64_t>(cell)) << axis;
  }
  return key;
}

}  // namespace

std::vector<uint32_t> FacesAlongCurve(const TriangleSoup& soup) {
  Point low = soup.positions[0], high = low;
  for (const Point& p : soup.positions) {
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], p[axis]);
      high[axis] = std::max(high[axis], p[axis]);
    }
  }
  // In sixteenths: no difference and no sum of three of them overflows.
  double longest = 0;
  for (int axis = 0; axis < 3; ++axis) {
    longest = std::max(longest, high[axis] / 16 - low[axis] / 16);
  }
  std::vector<std::pair<uint64_t, uint32_t>> keys(soup.triangles.size());
  for (uint32_t face = 0; face < keys.size(); ++face) {
    Point centroid = {};
    for (const uint32_t v : soup.triangles[face]) {
      for (int axis = 0; axis < 3 && longest > 0; ++axis) {
        const double along = soup.positions[v][axis] / 16 - low[axis] / 16;
        centroid[axis] += along / longest / 3;
      }
    }
    keys[face] = {AlongCurve(centroid), face};
  }
  std::ranges::sort(keys);
  std::vector<uint32_t> faces(keys.size());
  for (size_t i = 0; i < keys.size(); ++i) faces[i] = keys[i].second;
  return faces;
}

}  // namespace geodesic
