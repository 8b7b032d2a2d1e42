// What a shortest path must be.

#ifndef GEODESIC_TESTS_STRESS_PATH_CHECK_H_
#define GEODESIC_TESTS_STRESS_PATH_CHECK_H_

#include "absl/status/statusor.h"
#include "geodesic/path.h"
#include "geodesic/query.h"
#include "geodesic/surface_point.h"
#include "tests/stress/report.h"
#include "tests/stress/scene.h"

namespace geodesic::stress {

// On the surface, from the source to the target, as long as the distance: then
// it is a shortest path.
void CheckPath(const Scene& scene, const Query& query,
               const absl::StatusOr<GeodesicPath>& path,
               const SurfacePoint& target, double distance, Report& report);

}  // namespace geodesic::stress

#endif  // GEODESIC_TESTS_STRESS_PATH_CHECK_H_
