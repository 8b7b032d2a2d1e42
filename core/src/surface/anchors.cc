#include "surface/anchors.h"

#include <algorithm>

#include "surface/surface_location.h"

namespace geodesic {
namespace {

void AddAnchors(const Curve& curve, double offset, uint32_t number,
                std::vector<Anchor>& anchors) {
  const std::vector<SurfacePoint>& points = curve.points;
  for (const SurfacePoint& point : points) {
    anchors.push_back({point, point, false, offset, number});
  }
  for (size_t i = 1; i < points.size(); ++i) {
    if (points[i - 1] == points[i]) continue;
    anchors.push_back({points[i - 1], points[i], true, offset, number});
  }
}

}  // namespace

std::vector<Anchor> AnchorsOf(const ValidQuery& query) {
  std::vector<Anchor> anchors;
  uint32_t number = 0;
  for (const auto& [place, offset] : query->sources) {
    if (const auto* point = std::get_if<SurfacePoint>(&place)) {
      anchors.push_back({*point, *point, false, offset, number});
    } else {
      AddAnchors(std::get<Curve>(place), offset, number, anchors);
    }
    ++number;
  }
  return anchors;
}

std::optional<FacePoint> FootOf(const Mesh& mesh, const Anchor& anchor,
                                HalfEdge h, const PlanePoint& place) {
  const std::optional<FacePoint> begin =
      WithinFace(mesh, anchor.begin, mesh.FaceOf(h));
  if (!begin.has_value() || !anchor.is_segment) return begin;
  const std::optional<FacePoint> end =
      WithinFace(mesh, anchor.end, mesh.FaceOf(h));
  if (!end.has_value()) return std::nullopt;
  const PlanePoint a = InFrame(mesh, *begin, h);
  const PlanePoint segment = InFrame(mesh, *end, h) - a;
  const double square = Dot(segment, segment);
  const double t =
      square > 0 ? std::clamp(Dot(place - a, segment) / square, 0.0, 1.0) : 0;
  FacePoint foot{.face = mesh.FaceOf(h)};
  for (int i = 0; i < 3; ++i) {
    foot.weights[i] = (1 - t) * begin->weights[i] + t * end->weights[i];
  }
  return foot;
}

}  // namespace geodesic
