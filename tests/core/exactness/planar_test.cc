// Planar meshes against Euclid and the visibility graph. A regular grid is the
// hardest of them: rays run along edges and through vertices everywhere.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "tests/core/exactness/every_algorithm.h"
#include "tests/support/meshes/planar_meshes.h"
#include "tests/support/oracles/planar_domain.h"
#include "tests/support/random.h"
#include "tests/support/vec.h"

namespace geodesic::test {
namespace {

class PlanarMeshes : public EveryAlgorithm {};

TEST_P(PlanarMeshes, RegularGrid) {
  for (const Diagonals diagonals :
       {Diagonals::kParallel, Diagonals::kAlternating, Diagonals::kRandom}) {
    // Unit cells have exact coordinates; the others do not.
    for (const double cell_width : {1.0, 0.3}) {
      const TriangleSoup soup = MakeGrid({.columns = 30,
                                          .rows = 24,
                                          .cell_width = cell_width,
                                          .diagonals = diagonals});
      const uint32_t middle = 12 * 31 + 15;
      ExpectEuclid({"regular grid", soup}, {0, 30, 15, middle, 31 * 7 + 3});
    }
  }
}

TEST_P(PlanarMeshes, JitteredGrid) {
  for (const uint64_t seed : {1, 2, 3}) {
    const TriangleSoup soup = MakeGrid({.columns = 30,
                                        .rows = 24,
                                        .diagonals = Diagonals::kRandom,
                                        .jitter = 0.24,
                                        .seed = seed});
    ExpectEuclid({"jittered grid", soup}, SpreadVertices(soup, 5));
  }
}

TEST_P(PlanarMeshes, LargeRegularGrid) {
  const TriangleSoup soup = MakeGrid({.columns = 100, .rows = 100});
  if (!IsTestedOn(GetParam().algorithm, soup.triangles.size())) {
    GTEST_SKIP() << GetParam().name << " is tested on smaller meshes only";
  }
  ExpectEuclid({"large regular grid", soup}, {50 * 101 + 37});
}

// Their windows wait at the same half-edges, as many lists as there are
// sources.
TEST_P(PlanarMeshes, HundredsOfSourcesInOnePlace) {
  const NamedMesh named{"grid", MakeGrid({.columns = 12, .rows = 10})};
  const std::shared_ptr<const Mesh> mesh = BuildOrFail(named);
  const std::vector<Point>& positions = named.soup.positions;
  Random random(11);
  const uint32_t face = 5 * 24 + 11;
  const Triangle& corners = named.soup.triangles[face];
  const auto at = [&](uint32_t v) { return ToVec3(positions[v]); };
  using Placed = std::pair<SurfacePoint, Vec3>;
  const auto on_edge = [&](uint32_t from, uint32_t to) -> Placed {
    const double t = random.Uniform(0, 1);
    return {EdgePoint{from, to, t}, at(from) + t * (at(to) - at(from))};
  };
  const auto in_face = [&]() -> Placed {
    const double u = random.Uniform(0, 0.5), v = random.Uniform(0, 0.5);
    return {
        FacePoint{face, {u, v, 1 - u - v}},
        u * at(corners[0]) + v * at(corners[1]) + (1 - u - v) * at(corners[2])};
  };
  const std::vector<std::function<Placed()>> places = {
      [&] { return on_edge(corners[0], corners[1]); },
      [&] { return on_edge(0, 1); }, in_face};
  for (const auto& place : places) {
    for (const double most_offset : {0.0, 0.01}) {
      std::vector<Source> sources;
      std::vector<double> expected(positions.size(),
                                   std::numeric_limits<double>::infinity());
      for (int i = 0; i < 300; ++i) {
        const auto [point, from] = place();
        const double offset = random.Uniform(0, most_offset);
        sources.push_back({point, offset});
        for (uint32_t v = 0; v < positions.size(); ++v) {
          const Real distance = offset + Norm(at(v) - from);
          expected[v] = std::min(expected[v], static_cast<double>(distance));
        }
      }
      ExpectField("sources in one place", *mesh, sources, expected);
    }
  }
}

// Around reflex corners, in regular grids and jittered ones.
TEST_P(PlanarMeshes, HolesAndNotches) {
  for (const double jitter : {0.0, 0.2}) {
    const GridOptions grid{.columns = 18,
                           .rows = 15,
                           .cell_width = 0.3,
                           .diagonals = Diagonals::kAlternating,
                           .jitter = jitter};
    GridOptions two_holes = grid;
    two_holes.removed = {{3, 3, 6, 12}, {9, 2, 14, 9}};
    const std::vector<std::pair<std::string, GridOptions>> domains = {
        {"grid with a hole", WithHole(grid)},
        {"L shape", LShape(grid)},
        {"U shape", UShape(grid)},
        {"grid with two holes", two_holes}};
    for (const auto& [name, options] : domains) {
      const PlanarDomain domain(options);
      const NamedMesh named{name, MakeGrid(options)};
      const std::shared_ptr<const Mesh> mesh = BuildOrFail(named);
      for (const uint32_t s : SpreadVertices(named.soup, 7)) {
        ExpectField(
            name, *mesh, {{VertexPoint{s}}},
            domain.Distances(named.soup.positions[s], named.soup.positions));
      }
    }
  }
}

// Along a side that is straight but for noise, vertices in a row cast shadows
// too thin for distances to tell who is nearest there.
TEST_P(PlanarMeshes, RaggedSides) {
  for (uint64_t seed = 1; seed <= 700; ++seed) {
    Random random(seed);
    TriangleSoup soup = MakeGrid({.columns = 20,
                                  .rows = 1 + static_cast<uint32_t>(seed % 3),
                                  .diagonals = Diagonals::kRandom,
                                  .seed = seed});
    const double noise = std::pow(10, -6 - 0.5 * static_cast<double>(seed % 7));
    for (Point& position : soup.positions) {
      for (double& c : position) c += random.Uniform(-noise, noise);
    }
    const auto mesh = BuildOrFail({"grid", soup});
    const uint32_t source = random.Below(mesh->vertex_count());
    const std::vector<double> field = SolveOn(*mesh, {{VertexPoint{source}}});
    for (uint32_t v = 0; v < mesh->vertex_count(); ++v) {
      // Bends are as small as the noise, detours as its square.
      ASSERT_NEAR(field[v],
                  static_cast<double>(
                      Distance(soup.positions[source], soup.positions[v])),
                  1e-9)
          << "seed " << seed << ", from " << source << " to " << v;
    }
  }
}

// On a plate that is all but flat, many vertices cast shadows, and paths by way
// of several of them tie over whole intervals. Seed 120 and those that follow
// it left vertices behind gaps of 1e-8 once.
TEST_P(PlanarMeshes, Plates) {
  for (const uint64_t seed :
       {1, 2, 3, 4, 5, 6, 7, 120, 12916, 13084, 13546, 13784}) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> height(-3e-4, 3e-4);
    TriangleSoup soup = MakeGrid({.columns = 12,
                                  .rows = 12,
                                  .diagonals = Diagonals::kRandom,
                                  .seed = seed});
    for (Point& position : soup.positions) position[2] = height(random);
    const auto mesh = BuildOrFail({"grid", soup});
    for (uint32_t source = 0; source < mesh->vertex_count(); source += 2) {
      const std::vector<double> field = SolveOn(*mesh, {{VertexPoint{source}}});
      for (uint32_t v = 0; v < mesh->vertex_count(); ++v) {
        const Point& a = soup.positions[source];
        const Point& b = soup.positions[v];
        const double flat = std::hypot(a[0] - b[0], a[1] - b[1]);
        // A detour over slopes of 1e-3 is longer by half their square.
        ASSERT_GE(field[v], flat);
        ASSERT_LE(field[v], flat * (1 + 1e-5))
            << "seed " << seed << ", from " << source << " to " << v;
      }
    }
  }
}

GEODESIC_TEST_EVERY_ALGORITHM(PlanarMeshes);

}  // namespace
}  // namespace geodesic::test
