#include "questions/paths/face_plane.h"

#include <cmath>

#include "mesh/scaled_difference.h"

namespace geodesic {

Point Normalized(const Point& v) {
  const double length = std::hypot(v[0], v[1], v[2]);
  if (length == 0) return {};
  return {v[0] / length, v[1] / length, v[2] / length};
}

Point DirectionBetween(const Mesh& mesh, uint32_t from, uint32_t to) {
  const ScaledDifference difference(mesh.scale_exponent());
  return Normalized(difference(mesh.positions()[from], mesh.positions()[to]));
}

Point DirectionInSpace(const Mesh& mesh, HalfEdge h,
                       const PlanePoint& direction) {
  const Point along = DirectionBetween(mesh, mesh.From(h), mesh.To(h));
  const Point to_apex = DirectionBetween(mesh, mesh.From(h), mesh.Apex(h));
  // Upright on `along`, even where the face is so thin that the way to the apex
  // hardly differs from it.
  const Point normal = Normalized(Cross(along, to_apex));
  const Point up = Cross(normal, along);
  Point in_space;
  for (int i = 0; i < 3; ++i) {
    in_space[i] = direction.x * along[i] + direction.y * up[i];
  }
  return Normalized(in_space);
}

}  // namespace geodesic
