#include "surface/straight_line.h"

#include <algorithm>
#include <variant>

#include "surface/surface_location.h"

namespace geodesic {

SpacePoint InSpace(const Mesh& mesh, const SurfacePoint& point) {
  if (const auto* vertex = std::get_if<VertexPoint>(&point)) {
    return {.vertex = vertex->vertex};
  }
  const FacePoint within = FacesAround(mesh, point)[0];
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

}  // namespace geodesic
