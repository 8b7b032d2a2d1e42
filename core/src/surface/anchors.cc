#include "surface/anchors.h"

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

}  // namespace geodesic
