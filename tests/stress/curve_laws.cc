#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/stress/answers.h"
#include "tests/stress/laws.h"
#include "tests/support/surface_points.h"
#include "tests/support/vec.h"

namespace geodesic::stress {
namespace {

// `count` + 1 points from one place of a face to another.
std::vector<SurfacePoint> Between(const test::Place& a, const test::Place& b,
                                  int count) {
  std::vector<SurfacePoint> points;
  for (int i = 0; i <= count; ++i) {
    FacePoint point{.face = a.face};
    for (int c = 0; c < 3; ++c) {
      point.weights[c] = static_cast<double>(
          ((count - i) * a.weights[c] + i * b.weights[c]) / count);
    }
    points.push_back(point);
  }
  return points;
}

// Points along the curve, in each of the faces in which it runs (there are
// several where a face is given twice), and how far apart at the most.
std::vector<SurfacePoint> Along(const Scene& scene, const Curve& curve,
                                double* apart) {
  constexpr int kPieces = 16;
  std::vector<SurfacePoint> all = {curve.points[0]};
  *apart = 0;
  for (size_t i = 1; i < curve.points.size(); ++i) {
    const std::vector<test::Place> ends =
        test::PlacesOf(scene.soup, curve.points[i]);
    for (const test::Place& begin :
         test::PlacesOf(scene.soup, curve.points[i - 1])) {
      const auto end = std::ranges::find(ends, begin.face, &test::Place::face);
      if (end == ends.end()) continue;
      const std::vector<SurfacePoint> piece = Between(begin, *end, kPieces);
      all.insert(all.end(), piece.begin(), piece.end());
      *apart = std::max(
          *apart, static_cast<double>(
                      Norm(test::PositionIn(scene.soup, curve.points[i]) -
                           test::PositionIn(scene.soup, curve.points[i - 1]))) /
                      kPieces);
    }
  }
  return all;
}

}  // namespace

void CheckCurveLaws(const Scene& scene, test::Random& random, Report& report) {
  const Source source = DrawCurve(scene, random);
  Query query{.sources = {source},
              .targets = scene.points,
              .algorithm = DrawAlgorithm(scene, random)};
  const std::vector<double> curve = AllDistances(*scene.mesh, query, report);
  double apart = 0;
  Query points{.targets = scene.points,
               .algorithm = DrawAlgorithm(scene, random)};
  for (const SurfacePoint& point :
       Along(scene, std::get<Curve>(source.place), &apart)) {
    points.sources.push_back({point, source.offset});
  }
  const std::vector<double> nearest = AllDistances(*scene.mesh, points, report);
  if (curve.size() != nearest.size()) return;
  const double slack = 16 * scene.rounding;
  report.CheckAll(
      curve.size(),
      [&](size_t i) {
        return curve[i] <= nearest[i] * (1 + kTolerance) + slack;
      },
      "a curve is as near as its points", Name(query));
  report.CheckAll(
      curve.size(),
      [&](size_t i) {
        return curve[i] >= (nearest[i] - apart / 2) * (1 - kTolerance) - slack;
      },
      "a curve is its points", Name(query));
}

}  // namespace geodesic::stress
