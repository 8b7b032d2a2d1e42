#include "surface/straight_line.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include "surface/surface_location.h"

namespace geodesic {

SpacePoint InSpace(const Mesh& mesh, const SurfacePoint& point) {
  if (const auto* vertex = std::get_if<VertexPoint>(&point)) {
    return {.vertex = vertex->vertex};
  }
  const FacePoint within = FirstFaceAround(mesh, point);
  const Triangle& corners = mesh.triangle(within.face);
  const auto nearest =
      std::ranges::max_element(within.weights) - within.weights.begin();
  const ScaledDifference difference(mesh.scale_exponent());
  SpacePoint place{.vertex = corners[nearest]};
  for (int corner = 0; corner < 3; ++corner) {
    const Vector side = difference(mesh.positions()[place.vertex],
                                   mesh.positions()[corners[corner]]);
    for (int i = 0; i < 3; ++i) {
      place.beyond[i] += within.weights[corner] * side[i];
    }
  }
  return place;
}

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
