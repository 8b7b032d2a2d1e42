#include <algorithm>
#include <vector>

#include "bench/stress/answers.h"
#include "bench/stress/laws.h"
#include "tests/support/brute_force.h"
#include "tests/support/surface_points.h"

namespace geodesic::stress {

void CheckBruteForce(const Scene& scene, test::Random& random, Report& report) {
  constexpr uint64_t kMostWindows = 300'000;  // a second at most
  const test::BruteForce brute_force(scene.soup, scene.points, {},
                                     kMostWindows);
  if (!brute_force.is_complete()) return;
  const double size = scene.rounding * 0x1p52;
  for (uint32_t count = 1; count <= 4; ++count) {
    Query query{.targets = scene.points};
    for (uint32_t i = 0; i < count; ++i) {
      // Some just short of dominated by those before.
      const SurfacePoint point = DrawPoint(scene, random);
      double offset = size * random.Uniform(0, 0.5);
      if (i == 0) offset = 0;
      if (i > 0 && random.Below(2) == 0) {
        const std::vector<double> so_far = brute_force.Distances(query.sources);
        const size_t number =
            std::ranges::find(scene.points, point) - scene.points.begin();
        const double there = so_far[scene.soup.positions.size() + number];
        if (there < size * 100) offset = there * random.Uniform(0.8, 1.01);
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

}  // namespace geodesic::stress
