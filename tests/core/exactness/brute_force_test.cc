// Every algorithm against brute force on small meshes of every kind. A case
// computes its reference once, so the algorithms are a loop inside the test.

#include "tests/support/oracles/brute_force.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "absl/strings/str_cat.h"
#include "tests/core/exactness/every_algorithm.h"
#include "tests/support/meshes/curved_meshes.h"
#include "tests/support/meshes/developable_meshes.h"
#include "tests/support/meshes/mesh_edits.h"
#include "tests/support/meshes/planar_meshes.h"
#include "tests/support/meshes/polyhedra.h"
#include "tests/support/random.h"
#include "tests/support/surface_points.h"

namespace geodesic::test {
namespace {

// Compares `fields` fields of random sources, the last of them of three
// sources with offsets.
void ExpectBruteForce(const NamedMesh& named, uint32_t fields, uint64_t seed,
                      double slack = 0) {
  const auto mesh = BuildOrFail(named);
  const BruteForce brute_force(named.soup);
  Random random(seed);
  const auto any_vertex = [&] { return random.Below(mesh->vertex_count()); };
  for (uint32_t i = 0; i < fields; ++i) {
    std::vector<Source> sources = {{VertexPoint{any_vertex()}}};
    if (i + 1 == fields) {
      sources.push_back({VertexPoint{any_vertex()}, random.Uniform(0, 0.5)});
      sources.push_back({VertexPoint{any_vertex()}, random.Uniform(0, 0.5)});
    }
    ExpectFromAll(kAlgorithms, named.name, *mesh, {.sources = sources},
                  brute_force.Distances(sources), slack);
  }
}

// A test of the oracle: where a curve ends on an edge it is in the faces on
// both sides of it, and from beyond it would be seen edge-on.
TEST(BruteForceComparison, CurvesThatEndOnEdges) {
  const TriangleSoup soup = {{{0, 0, 0},
                              {0.54510429528898252, 0.83836824084497719, 0},
                              {-0.40572261451500352, 0.91399625823693054, 0},
                              {-0.98742657502499154, 0.1580783316410406, 0}},
                             {{0, 1, 2}, {0, 2, 3}}};
  const FacePoint node{
      1, {8.7052580812239745e-10, 0.99999999870099854, 4.2847566226357701e-10}};
  const EdgePoint end{2, 0, 0.045761953606791902};
  const Source curve{Curve{{FacePoint{0, {0.001, 0.159, 0.84}}, end}}};
  const BruteForce brute_force(soup, {node}, {curve});
  // In the plane, straight to the curve's end.
  const Point from = PositionOf(node, *BuildOrFail({"two faces", soup}));
  const Point to = PositionOf(end, *BuildOrFail({"two faces", soup}));
  EXPECT_NEAR(brute_force.DistancesFromAll({})[4],
              std::hypot(to[0] - from[0], to[1] - from[1]), 1e-15);
}

TEST(BruteForceComparison, Icospheres) {
  for (uint32_t levels = 0; levels <= 2; ++levels) {
    ExpectBruteForce({"icosphere", Icosphere(levels)}, 6, levels);
  }
}

TEST(BruteForceComparison, UvSpheres) {
  ExpectBruteForce({"sphere by meridians", UvSphere(12, 8)}, 8, 1);
  ExpectBruteForce({"sphere of thin bands", UvSphere(30, 4)}, 8, 2);
}

TEST(BruteForceComparison, Tori) {
  ExpectBruteForce({"torus", Torus({})}, 8, 1);
  ExpectBruteForce({"anisotropic torus", Torus({.around = 5, .across = 30})}, 8,
                   2);
  ExpectBruteForce({"noisy torus", Torus({.noise = 0.3})}, 8, 3);
}

// Right angles, ties and saddles, as machine parts have them, and the reflex
// corners of flat domains.
TEST(BruteForceComparison, PlatesAndDomains) {
  for (const Diagonals diagonals :
       {Diagonals::kParallel, Diagonals::kAlternating, Diagonals::kRandom}) {
    for (const double jitter : {0.0, 0.2}) {
      const GridOptions grid{
          .columns = 6, .rows = 5, .diagonals = diagonals, .jitter = jitter};
      for (const double thickness : {1.0, 0.1}) {
        ExpectBruteForce(
            {"plate with a hole", MakePlate(WithHole(grid), thickness)}, 6, 1);
        ExpectBruteForce({"U plate", MakePlate(UShape(grid), thickness)}, 6, 2);
      }
      for (const GridOptions& domain :
           {WithHole(grid), LShape(grid), UShape(grid)}) {
        ExpectBruteForce({"domain", MakeGrid(domain)}, 6, 3);
      }
    }
  }
}

// Two copies of one disc in one plane, joined along their rim.
TEST(BruteForceComparison, DiscsBackToBack) {
  constexpr uint32_t kSpokes = 10, kRings = 3;
  const TriangleSoup above = Fan({.spokes = kSpokes,
                                  .rings = kRings,
                                  .total_angle = 2 * std::numbers::pi})
                                 .soup();
  const uint32_t first_on_rim = 1 + kSpokes * (kRings - 1);
  const uint32_t vertices = static_cast<uint32_t>(above.positions.size());
  TriangleSoup soup = above;
  for (uint32_t v = 0; v < first_on_rim; ++v) {
    soup.positions.push_back(above.positions[v]);
  }
  const auto below = [&](uint32_t v) {
    return v < first_on_rim ? vertices + v : v;
  };
  for (const Triangle& t : above.triangles) {
    soup.triangles.push_back({below(t[0]), below(t[2]), below(t[1])});
  }
  ExpectBruteForce({"discs back to back", soup}, 10, 1);
}

// Random small meshes: `make(seed)` makes one, and the seed draws the sources.
struct MeshMaker {
  const char* name;
  TriangleSoup (*make)(uint64_t seed);
  // Whether vertices lie so close together that the rounding of their
  // coordinates shows.
  bool up_to_rounding = false;
};

class RandomMeshes : public testing::TestWithParam<MeshMaker> {};

TEST_P(RandomMeshes, AgreeWithBruteForce) {
  const auto& [name, make, up_to_rounding] = GetParam();
  for (uint64_t seed = 0; seed < 100; ++seed) {
    const TriangleSoup soup = make(seed);
    ExpectBruteForce({absl::StrCat(name, " ", seed), soup}, 3, seed,
                     up_to_rounding ? CoordinateRounding(soup.positions) : 0);
  }
}

TriangleSoup AnyTerrain(uint64_t seed) {
  Random random(seed);
  return Terrain(3 + random.Below(4), 3 + random.Below(4),
                 random.Below(2) ? 0.3 : 2.0, seed);
}
// Heights of a few steps on a regular grid: coplanar faces and ties next to
// folds.
TriangleSoup SteppedTerrain(uint64_t seed) {
  Random random(seed);
  TriangleSoup soup =
      MakeGrid({.columns = 5, .rows = 5, .diagonals = Diagonals::kAlternating});
  for (Point& p : soup.positions) p[2] = random.Below(3) == 0 ? 1 : 0;
  return soup;
}

INSTANTIATE_TEST_SUITE_P(
    Makers, RandomMeshes,
    testing::Values(
        MeshMaker{"Terrain", AnyTerrain},
        MeshMaker{"FlippedTerrain",
                  [](uint64_t seed) {
                    return FlipEdges(Terrain(4, 5, 1, seed), 40, seed);
                  }},
        // A needle in a needle has sides of 1e-12.
        MeshMaker{"Needles",
                  [](uint64_t seed) {
                    return InsertNeedles(Terrain(3, 4, 0.5, seed), 8, seed);
                  },
                  true},
        MeshMaker{
            "FlippedTorus",
            [](uint64_t seed) {
              return FlipEdges(
                  Torus({.around = 6, .across = 5, .noise = 0.4, .seed = seed}),
                  15, seed);
            }},
        MeshMaker{"ZeroAreaFaces",
                  [](uint64_t seed) {
                    return InsertZeroAreaFaces(
                        DoubleVertices(Terrain(4, 4, 0.5, seed), 2, seed), 5,
                        seed);
                  },
                  true},
        MeshMaker{"SteppedTerrain", SteppedTerrain},
        MeshMaker{"Edited",
                  [](uint64_t seed) { return EditedMesh(seed, false); }},
        MeshMaker{"DegenerateEdited",
                  [](uint64_t seed) { return EditedMesh(seed, true); }, true}),
    [](const auto& tested) { return tested.param.name; });

// From there paths to the vertices at that place improve by roundings, which
// are a large part of them and nothing beside the way to any other.
TEST(BruteForceComparison, PointsRightBesideDoubledVertices) {
  for (uint64_t seed = 1; seed <= 12; ++seed) {
    std::vector<uint32_t> doubled;
    const TriangleSoup soup = DoubleVertices(
        RotateAndShift(BoxGrid(1, 2, 1.5, 2, 2, 2), seed), 3, seed, &doubled);
    const auto mesh = BuildOrFail({"doubled vertices", soup});
    const std::vector<SurfacePoint> points =
        PointsBeside(soup, doubled, 2.6e-10);
    const BruteForce brute_force(soup, points);
    for (const SurfacePoint& point : points) {
      const std::vector<Source> sources = {{point}};
      std::vector<double> expected = brute_force.Distances(sources);
      expected.resize(mesh->vertex_count());
      ExpectFromAll(kAlgorithms, "doubled vertices", *mesh,
                    {.sources = sources}, expected,
                    4 * CoordinateRounding(soup.positions));
    }
  }
}

// Vertices some 1e-12 above an edge, as turned edges and noise put them: what
// they see behind it they see through a gap no wider.
TEST(BruteForceComparison, VerticesRightBesideEdges) {
  for (uint64_t seed = 1; seed <= 24; ++seed) {
    TriangleSoup soup = FlipEdges(
        Fan({.spokes = 6, .rings = 3, .total_angle = 1.25}).soup(), 12, seed);
    Random random(seed);
    for (Point& p : soup.positions) {
      for (double& c : p) c += random.Uniform(-2e-12, 2e-12);
    }
    const auto mesh = BuildOrFail({"fan", soup});
    const BruteForce brute_force(soup);
    for (uint32_t s = 0; s < mesh->vertex_count(); ++s) {
      ExpectFromAll(kAlgorithms, "fan", *mesh, {.sources = {{VertexPoint{s}}}},
                    brute_force.Distances(s));
    }
  }
}

class BruteForceOnRealMesh : public RealMesh {};

TEST_P(BruteForceOnRealMesh, Agrees) { ExpectBruteForce(named_, 12, 1); }

INSTANTIATE_TEST_SUITE_P(Meshes, BruteForceOnRealMesh,
                         testing::Values("cgal_double-torus-example.off",
                                         "cgal_eight.off",
                                         "cgal_icosahedron.off",
                                         "cgal_joint.off", "cgal_pipe.off"),
                         MeshTestName);

// Half a minute. CGAL 5.5 is off by 3e-4 at three vertices of this mesh.
INSTANTIATE_TEST_SUITE_P(DISABLED_Meshes, BruteForceOnRealMesh,
                         testing::Values("cgal_oblong.off"), MeshTestName);

}  // namespace
}  // namespace geodesic::test
