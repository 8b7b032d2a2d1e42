#include "tests/stress/path_check.h"

#include <cmath>

#include "tests/stress/answers.h"
#include "tests/support/queries.h"
#include "tests/support/surface_points.h"
#include "tests/support/vec.h"

namespace geodesic::stress {

using test::Name;
using test::Real;

void CheckPath(const Scene& scene, const Query& query,
               const absl::StatusOr<GeodesicPath>& path,
               const SurfacePoint& target, double distance, Report& report) {
  if (!report.Check(path.ok(), "a path is found", path.status(), " to ",
                    Name(target), ", ", Name(query))) {
    return;
  }
  if (std::isinf(distance)) {
    report.Check(path->points.empty(), "no path leads to what is not reached",
                 Name(target), ", ", Name(query));
    return;
  }
  bool is_on_surface = !path->points.empty();
  Real length = 0;
  for (size_t i = 1; i < path->points.size(); ++i) {
    is_on_surface =
        is_on_surface &&
        test::HaveCommonFace(scene.soup, path->points[i - 1], path->points[i]);
    length += Norm(test::PositionIn(scene.soup, path->points[i]) -
                   test::PositionIn(scene.soup, path->points[i - 1]));
  }
  if (!report.Check(is_on_surface, "a path keeps to the surface", "to ",
                    Name(target), ", ", Name(query))) {
    return;
  }
  const double slack =
      scene.rounding * 4 * static_cast<double>(path->points.size());
  const Source& source = query.sources[path->source];
  const double offset = source.offset;
  report.Check(AreEqual(distance, offset + static_cast<double>(length), slack),
               "a path is as long as the distance", offset, " + ",
               static_cast<double>(length), " for ", distance, " to ",
               Name(target), ", ", Name(query));
  report.Check(AreEqual(distance, offset + path->length, slack),
               "a path knows its length", path->length, ", ", Name(query));
  const auto apart = [&](const SurfacePoint& a, const SurfacePoint& b) {
    return static_cast<double>(Norm(test::PositionIn(scene.soup, a) -
                                    test::PositionIn(scene.soup, b)));
  };
  report.Check(apart(path->points.back(), target) <= slack,
               "a path ends at its target", Name(target), ", ", Name(query));
  if (!IsCurve(source)) {
    report.Check(apart(path->points.front(), test::PointOf(source)) <= slack,
                 "a path starts at its source", Name(target), ", ",
                 Name(query));
  }
}

}  // namespace geodesic::stress
