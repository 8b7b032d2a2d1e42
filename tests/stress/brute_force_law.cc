#include <algorithm>
#include <vector>

#include "tests/stress/answers.h"
#include "tests/stress/laws.h"
#include "tests/support/oracles/brute_force.h"
#include "tests/support/surface_points.h"

namespace geodesic::stress {
namespace {

constexpr uint64_t kMostWindows = 300'000;  // a second at most

// With points, some of them just short of dominated by those before.
void CheckPoints(const Scene& scene, const test::BruteForce& brute_force,
                 test::Random& random, Report& report) {
  for (uint32_t count = 1; count <= 4; ++count) {
    Query query{.targets = scene.points};
    for (uint32_t i = 0; i < count; ++i) {
      const SurfacePoint point = DrawPoint(scene, random);
      double offset = i == 0 ? 0 : scene.size() * random.Uniform(0, 0.5);
      if (i > 0 && random.Below(2) == 0) {
        const std::vector<double> so_far = brute_force.Distances(query.sources);
        const size_t number =
            std::ranges::find(scene.points, point) - scene.points.begin();
        const double there = so_far[scene.soup.positions.size() + number];
        if (there < scene.size() * 100) {
          offset = there * random.Uniform(0.8, 1.01);
        }
      }
      query.sources.push_back({point, offset});
    }
    const std::vector<double> expected = brute_force.Distances(query.sources);
    for (const AlgorithmInfo& info : AlgorithmsFor(scene)) {
      query.algorithm = info.algorithm;
      CheckEqual("brute force", query, expected,
                 AllDistances(*scene.mesh, query, report), 4 * scene.rounding,
                 report);
    }
  }
}

// With curves, alone and beside a point.
void CheckCurves(const Scene& scene, test::Random& random, Report& report) {
  std::vector<Source> curves, points;
  for (uint32_t i = random.Below(2) + 1; i > 0; --i) {
    curves.push_back(DrawCurve(scene, random));
  }
  const test::BruteForce brute_force(scene.soup, scene.points, curves,
                                     kMostWindows);
  if (!brute_force.is_complete()) return;
  for (int i = 0; i < 2; ++i) {
    if (i == 1) {
      points = {
          {DrawPoint(scene, random), scene.size() * random.Uniform(0, 0.2)}};
    }
    Query query{.sources = curves, .targets = scene.points};
    query.sources.insert(query.sources.end(), points.begin(), points.end());
    const std::vector<double> expected = brute_force.DistancesFromAll(points);
    for (const AlgorithmInfo& info : AlgorithmsFor(scene)) {
      query.algorithm = info.algorithm;
      CheckEqual("brute force for curves", query, expected,
                 AllDistances(*scene.mesh, query, report), 4 * scene.rounding,
                 report);
    }
  }
}

}  // namespace

void CheckBruteForce(const Scene& scene, test::Random& random, Report& report) {
  const test::BruteForce brute_force(scene.soup, scene.points, {},
                                     kMostWindows);
  if (!brute_force.is_complete()) return;
  CheckPoints(scene, brute_force, random, report);
  CheckCurves(scene, random, report);
}

}  // namespace geodesic::stress
