#include "questions/paths/anchor_foot.h"

#include <algorithm>

#include "surface/surface_location.h"

namespace geodesic {

std::optional<FacePoint> FootOf(const Mesh& mesh, const Anchor& anchor,
                                HalfEdge h, const PlanePoint& place) {
  const std::optional<FacePoint> begin =
      WithinFace(mesh, anchor.begin, mesh.FaceOf(h));
  if (!begin.has_value() || !anchor.is_segment) return begin;
  const std::optional<FacePoint> end =
      WithinFace(mesh, anchor.end, mesh.FaceOf(h));
  if (!end.has_value()) return std::nullopt;
  const PlanePoint a = InFrame(mesh, *begin, h), b = InFrame(mesh, *end, h);
  const double x = b.x - a.x, y = b.y - a.y;
  const double along = (place.x - a.x) * x + (place.y - a.y) * y;
  const double square = x * x + y * y;
  const double t = square > 0 ? std::clamp(along / square, 0.0, 1.0) : 0;
  FacePoint foot{.face = mesh.FaceOf(h)};
  for (int i = 0; i < 3; ++i) {
    foot.weights[i] = (1 - t) * begin->weights[i] + t * end->weights[i];
  }
  return foot;
}

}  // namespace geodesic
