#include "mesh/locality.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <utility>

#include "mesh/large_pages.h"

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

// A face, and the upper bits of where along the curve it lies.
struct Place {
  uint32_t upper_key;
  uint32_t face;
};
constexpr int kLowerBits = 16;

// Sorts by upper key, equal ones in the order in which they are: digit by
// digit, the last first.
void SortByUpperKey(std::vector<Place>& places) {
  constexpr int kKeyBits = 32, kDigitBits = 11;
  constexpr size_t kDigits = size_t{1} << kDigitBits;
  constexpr int kRounds = (kKeyBits + kDigitBits - 1) / kDigitBits;
  const auto digit = [](const Place& place, int round) {
    return place.upper_key >> round * kDigitBits & (kDigits - 1);
  };
  std::array<std::array<uint32_t, kDigits + 1>, kRounds> next = {};
  for (const Place& place : places) {
    for (int round = 0; round < kRounds; ++round) {
      ++next[round][digit(place, round) + 1];
    }
  }
  std::vector<Place> sorted = MakeLargeVector<Place>(places.size());
  for (int round = 0; round < kRounds; ++round) {
    std::partial_sum(next[round].begin(), next[round].end(),
                     next[round].begin());
    for (const Place& place : places) {
      sorted[next[round][digit(place, round)]++] = place;
    }
    places.swap(sorted);
  }
}

// Sorts those with equal upper keys, which are few unless faces crowd in a
// corner of the box: by the lower bits, then by number.
void SortTies(std::vector<Place>& places,
              const std::vector<uint16_t>& lower_keys) {
  for (auto begin = places.begin(); begin != places.end();) {
    const auto end = std::find_if(begin + 1, places.end(), [&](const Place& p) {
      return p.upper_key != begin->upper_key;
    });
    if (end - begin > 1) {
      std::sort(begin, end, [&](const Place& a, const Place& b) {
        return std::pair(lower_keys[a.face], a.face) <
               std::pair(lower_keys[b.face], b.face);
      });
    }
    begin = end;
  }
}

}  // namespace

Box BoxAround(std::span<const Point> points) {
  Box box{points[0], points[0]};
  for (const Point& p : points) {
    for (int axis = 0; axis < 3; ++axis) {
      box.low[axis] = std::min(box.low[axis], p[axis]);
      box.high[axis] = std::max(box.high[axis], p[axis]);
    }
  }
  return box;
}

std::vector<uint32_t> FacesAlongCurve(const TriangleSoup& soup) {
  const auto [low, high] = BoxAround(soup.positions);
  // In sixteenths: no difference and no sum of three of them overflows.
  double longest = 0;
  for (int axis = 0; axis < 3; ++axis) {
    longest = std::max(longest, high[axis] / 16 - low[axis] / 16);
  }
  // A third of each vertex's place in the box, which is the unit cube then.
  std::vector<Point> thirds = MakeLargeVector<Point>(soup.positions.size());
  for (size_t v = 0; v < thirds.size() && longest > 0; ++v) {
    for (int axis = 0; axis < 3; ++axis) {
      const double along = soup.positions[v][axis] / 16 - low[axis] / 16;
      thirds[v][axis] = along / longest / 3;
    }
  }
  std::vector<Place> places = MakeLargeVector<Place>(soup.triangles.size());
  std::vector<uint16_t> lower_keys(places.size());
  for (uint32_t face = 0; face < places.size(); ++face) {
    Point centroid = {};
    for (const uint32_t v : soup.triangles[face]) {
      for (int axis = 0; axis < 3; ++axis) centroid[axis] += thirds[v][axis];
    }
    const uint64_t key = AlongCurve(centroid);
    places[face] = {static_cast<uint32_t>(key >> kLowerBits), face};
    lower_keys[face] = static_cast<uint16_t>(key);
  }
  SortByUpperKey(places);
  SortTies(places, lower_keys);
  std::vector<uint32_t> faces = MakeLargeVector<uint32_t>(places.size());
  for (size_t i = 0; i < places.size(); ++i) faces[i] = places[i].face;
  return faces;
}

}  // namespace geodesic
