#include "anchors.h"

namespace geodesic {

Query WithCanonicalPoints(Query query, const Mesh& mesh) {
  for (Source& source : query.sources) {
    source.point = Canonicalize(source.point, mesh);
  }
  for (CurveSource& curve : query.curves) {
    for (SurfacePoint& point : curve.points) point = Canonicalize(point, mesh);
  }
  for (SurfacePoint& target : query.targets) {
    target = Canonicalize(target, mesh);
  }
  return query;
}

std::vector<Anchor> AnchorsOf(const Query& query) {
  std::vector<Anchor> anchors;
  uint32_t number = 0;
  for (const Source& source : query.sources) {
    anchors.push_back(
        {source.point, source.point, false, source.offset, number++});
  }
  for (const CurveSource& curve : query.curves) {
    for (const SurfacePoint& point : curve.points) {
      anchors.push_back({point, point, false, curve.offset, number});
    }
    for (size_t i = 1; i < curve.points.size(); ++i) {
      if (curve.points[i - 1] == curve.points[i]) continue;
      anchors.push_back(
          {curve.points[i - 1], curve.points[i], true, curve.offset, number});
    }
    ++number;
  }
  return anchors;
}

}  // namespace geodesic
