// Differences of points in a mesh's scaled unit (Mesh::scale_exponent).

#ifndef GEODESIC_MESH_SCALED_DIFFERENCE_H_
#define GEODESIC_MESH_SCALED_DIFFERENCE_H_

#include <array>
#include <cmath>

#include "geodesic/triangle_soup.h"

namespace geodesic {

using Vector = std::array<double, 3>;

inline double Dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Vector Cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
          a[0] * b[1] - a[1] * b[0]};
}

inline double Norm(const Vector& a) { return std::sqrt(Dot(a, a)); }

// Quarters first: no difference of doubles then overflows, and none loses a bit
// above the subnormal range.
class ScaledDifference {
 public:
  explicit ScaledDifference(int scale_exponent)
      : factor_(std::ldexp(1.0, 2 - scale_exponent)) {}

  Vector operator()(const Point& from, const Point& to) const {
    return {(to[0] / 4 - from[0] / 4) * factor_,
            (to[1] / 4 - from[1] / 4) * factor_,
            (to[2] / 4 - from[2] / 4) * factor_};
  }

 private:
  double factor_;
};

}  // namespace geodesic

#endif  // GEODESIC_MESH_SCALED_DIFFERENCE_H_
