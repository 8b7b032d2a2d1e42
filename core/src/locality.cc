#include "locality.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

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

// A face, and where along the curve it lies.
struct Place {
  uint64_t key;
  uint32_t face;
};

// Sorts by key, equal keys in the order in which they are: digit by digit, the
// last first.
void Sort(std::vector<Place>& places) {
  constexpr int kKeyBits = 48, kDigitBits = 12;
  constexpr size_t kDigits = size_t{1} << kDigitBits;
  std::vector<Place> sorted(places.size());
  for (int shift = 0; shift < kKeyBits; shift += kDigitBits) {
    const auto digit = [&](const Place& place) {
      return place.key >> shift & (kDigits - 1);
    };
    std::vector<uint32_t> next(kDigits + 1, 0);
    for (const Place& place : places) ++next[digit(place) + 1];
    std::partial_sum(next.begin(), next.end(), next.begin());
    for (const Place& place : places) sorted[next[digit(place)]++] = place;
    places.swap(sorted);
  }
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
  std::vector<Place> places(soup.triangles.size());
  for (uint32_t face = 0; face < places.size(); ++face) {
    Point centroid = {};
    for (const uint32_t v : soup.triangles[face]) {
      for (int axis = 0; axis < 3 && longest > 0; ++axis) {
        const double along = soup.positions[v][axis] / 16 - low[axis] / 16;
        centroid[axis] += along / longest / 3;
      }
    }
    places[face] = {AlongCurve(centroid), face};
  }
  Sort(places);
  std::vector<uint32_t> faces(places.size());
  for (size_t i = 0; i < places.size(); ++i) faces[i] = places[i].face;
  return faces;
}

}  // namespace geodesic
