// A place or a way in the plane of a face.

#ifndef GEODESIC_SURFACE_PLANE_POINT_H_
#define GEODESIC_SURFACE_PLANE_POINT_H_

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

}  // namespace geodesic

#endif  // GEODESIC_SURFACE_PLANE_POINT_H_
