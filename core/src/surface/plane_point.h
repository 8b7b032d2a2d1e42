// A place or a way in the plane of a face.

#ifndef GEODESIC_SURFACE_PLANE_POINT_H_
#define GEODESIC_SURFACE_PLANE_POINT_H_

#include <algorithm>
#include <cmath>

namespace geodesic {

// In the frame of one of the face's half-edges (Mesh::frame), in the mesh's
// scaled unit.
struct PlanePoint {
  double x = 0;
  double y = 0;
};

inline PlanePoint operator-(const PlanePoint& a, const PlanePoint& b) {
  return {a.x - b.x, a.y - b.y};
}
inline double Dot(const PlanePoint& a, const PlanePoint& b) {
  return a.x * b.x + a.y * b.y;
}
inline double Cross(const PlanePoint& a, const PlanePoint& b) {
  return a.x * b.y - a.y * b.x;
}
inline double Norm(const PlanePoint& a) { return std::sqrt(Dot(a, a)); }
// As complex numbers: one turned and stretched by the other.
inline PlanePoint Product(const PlanePoint& a, const PlanePoint& b) {
  return {a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x};
}

// A place that is so far from (0, 0) and (length, 0), above; where there is
// none, on the line between them.
inline PlanePoint PlaceOver(double length, double from_begin, double from_end) {
  const double x =
      (length + (from_begin - from_end) * (from_begin + from_end) / length) / 2;
  return {x, std::sqrt(std::max(from_begin * from_begin - x * x, 0.0))};
}

}  // namespace geodesic

#endif  // GEODESIC_SURFACE_PLANE_POINT_H_
