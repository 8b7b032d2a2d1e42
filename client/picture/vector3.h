// Vectors of three doubles, for the geometry of pictures.

#ifndef GEODESIC_CLIENT_PICTURE_VECTOR3_H_
#define GEODESIC_CLIENT_PICTURE_VECTOR3_H_

#include <cmath>

namespace geodesic::client {

struct Vector3 {
  double x = 0;
  double y = 0;
  double z = 0;
};

inline Vector3 operator+(const Vector3& a, const Vector3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vector3 operator-(const Vector3& a, const Vector3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vector3 operator*(double s, const Vector3& a) {
  return {s * a.x, s * a.y, s * a.z};
}
inline double Dot(const Vector3& a, const Vector3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Vector3 Cross(const Vector3& a, const Vector3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double Length(const Vector3& a) { return std::sqrt(Dot(a, a)); }

// Leaves the zero vector as it is.
inline Vector3 Normalized(const Vector3& a) {
  const double length = Length(a);
  return length > 0 ? (1 / length) * a : a;
}

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_PICTURE_VECTOR3_H_
