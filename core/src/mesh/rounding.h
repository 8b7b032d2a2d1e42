// How far apart places are that are one, since they were computed and written
// down twice.

#ifndef GEODESIC_MESH_ROUNDING_H_
#define GEODESIC_MESH_ROUNDING_H_

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

#include "geodesic/triangle_soup.h"

namespace geodesic {

// A unit of the last digit, in binary or in decimal, along each axis by the
// coordinates along that one.
class Rounding {
 public:
  // Of the places of some of a soup's vertices. REQUIRES: the soup has faces.
  Rounding(const TriangleSoup& soup, std::span<const uint32_t> vertices);

  // Between two places that are one, at the most.
  double distance() const { return std::ranges::max(along_); }
  // Whether two places may be one.
  bool Allows(const Point& a, const Point& b) const {
    return std::abs(a[0] - b[0]) <= along_[0] &&
           std::abs(a[1] - b[1]) <= along_[1] &&
           std::abs(a[2] - b[2]) <= along_[2];
  }

 private:
  Point along_{};
};

}  // namespace geodesic

#endif  // GEODESIC_MESH_ROUNDING_H_
