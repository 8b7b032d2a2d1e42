// The oracles against each other, no solver involved: brute force has to find
// what the closed forms say.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/support/field_check.h"
#include "tests/support/meshes/curved_meshes.h"
#include "tests/support/meshes/developable_meshes.h"
#include "tests/support/meshes/mesh_edits.h"
#include "tests/support/meshes/planar_meshes.h"
#include "tests/support/meshes/polyhedra.h"
#include "tests/support/oracles/brute_force.h"
#include "tests/support/oracles/planar_domain.h"
#include "tests/support/oracles/strip_paths.h"
#include "tests/support/surface_points.h"
#include "tests/support/vec.h"

namespace geodesic::test {
namespace {

// Compares brute force with `distance(v, w)` from every vertex.
template <typename DistanceFunction>
void ExpectBruteForce(const NamedMesh& mesh, DistanceFunction distance) {
  const BruteForce brute_force(mesh.soup);
  for (uint32_t s = 0; s < mesh.soup.positions.size(); ++s) {
    std::vector<double> expected;
    for (uint32_t v = 0; v < mesh.soup.positions.size(); ++v) {
      expected.push_back(distance(s, v));
    }
    ASSERT_TRUE(FieldsAgree({mesh.name, {{VertexPoint{s}}}, "brute-force"},
                            expected, brute_force.Distances(s)));
  }
}

TEST(Oracles, BruteForceFindsStringsPulledTautInStrips) {
  for (const double height : {1e-6, 1e-2, 1.0, 3.0}) {
    for (const uint64_t seed : {1, 2, 3}) {
      const TriangleSoup soup = Strip(20, height, seed);
      std::vector<std::vector<double>> distances;
      for (uint32_t s = 0; s < soup.positions.size(); ++s) {
        distances.push_back(StripDistances(soup, s));
      }
      ExpectBruteForce({"strip", soup},
                       [&](uint32_t s, uint32_t v) { return distances[s][v]; });
    }
  }
}

TEST(Oracles, BruteForceFindsShortestPathsInPlanarDomains) {
  for (const double jitter : {0.0, 0.2}) {
    for (const Diagonals diagonals :
         {Diagonals::kParallel, Diagonals::kAlternating, Diagonals::kRandom}) {
      const GridOptions grid{.columns = 6,
                             .rows = 5,
                             .cell_width = 0.3,
                             .cell_height = 0.7,
                             .diagonals = diagonals,
                             .jitter = jitter};
      for (const GridOptions& options :
           {grid, WithHole(grid), LShape(grid), UShape(grid)}) {
        const PlanarDomain domain(options);
        const TriangleSoup soup = MakeGrid(options);
        std::vector<std::vector<double>> distances;
        for (const Point& p : soup.positions) {
          distances.push_back(domain.Distances(p, soup.positions));
        }
        ExpectBruteForce({"planar domain", soup}, [&](uint32_t s, uint32_t v) {
          return distances[s][v];
        });
      }
    }
  }
}

TEST(Oracles, BruteForceSeesThroughFacesWithoutArea) {
  const TriangleSoup grid = MakeGrid({.columns = 4, .rows = 4, .jitter = 0.1});
  const std::vector<NamedMesh> meshes = {
      {"grid with faces without area", InsertZeroAreaFaces(grid, 8, 3)},
      {"grid with doubled vertices", DoubleVertices(grid, 4, 4)},
      {"grid with needles", InsertNeedles(grid, 8, 5)}};
  for (const NamedMesh& mesh : meshes) {
    for (const TriangleSoup& soup : {mesh.soup, RotateAndShift(mesh.soup, 8)}) {
      ExpectBruteForce({mesh.name, soup}, [&](uint32_t s, uint32_t v) {
        return static_cast<double>(
            Distance(soup.positions[s], soup.positions[v]));
      });
    }
  }
}

// From a point a hair inside a face, a vertex that lies on its side beyond is
// seen along that side.
TEST(Oracles, BruteForceSeesAlongAnEdge) {
  const TriangleSoup soup = {
      {{0, 0, 0}, {2, 0, 0}, {0.3, 1.7, 0}, {1, 0, 0}, {0.8, -1, 0}},
      {{0, 1, 2}, {1, 0, 3}, {0, 4, 3}, {4, 1, 3}}};
  std::vector<SurfacePoint> points;
  for (const double inside : {1e-200, 1e-15, 1e-12, 4e-10, 1e-6}) {
    for (const double to : {1e-9, 1e-3, 0.3}) {
      points.push_back(FacePoint{0, {1 - to - inside, to, inside}});
    }
  }
  for (uint64_t seed = 1; seed <= 8; ++seed) {
    const TriangleSoup place = RotateAndShift(soup, seed);
    const BruteForce brute_force(place, points);
    for (const SurfacePoint& point : points) {
      const std::vector<double> got =
          brute_force.Distances(std::vector<Source>{{point}});
      for (uint32_t v = 0; v < place.positions.size(); ++v) {
        const double expected = static_cast<double>(
            Norm(PositionIn(place, point) - ToVec3(place.positions[v])));
        EXPECT_NEAR(got[v], expected, 1e-14) << v;
      }
    }
  }
}

// From a point a hair over a side, some ten thousand times shorter than the
// others, rays go into the face beyond as well.
TEST(Oracles, BruteForceLeavesThroughAShortSide) {
  const TriangleSoup soup = {
      {{1, 7e-6, 0}, {1, 1.4e-5, 0}, {1, 1.4e-5, 0.43}, {0.4, 1.4e-5, 0}},
      {{0, 1, 2}, {1, 0, 3}}};
  for (uint64_t seed = 1; seed <= 10; ++seed) {
    const TriangleSoup place = RotateAndShift(soup, seed);
    for (const double inside : {1e-200, 1e-18, 1e-16}) {
      // Alone: another point as near would see what this one does not.
      const SurfacePoint point = FacePoint{0, {0.776 - inside, 0.224, inside}};
      const std::vector<Source> sources = {{point}};
      EXPECT_NEAR(BruteForce(place, {point}).Distances(sources)[3],
                  static_cast<double>(Norm(PositionIn(place, point) -
                                           ToVec3(place.positions[3]))),
                  1e-14)
          << seed;
    }
  }
}

// A line that runs along an edge into a face without area does not reach what
// lies in that face before the edge, where the sheets are not joined.
TEST(Oracles, BruteForceReachesNothingBeforeAnEdge) {
  constexpr uint32_t kStart = 0, kCorner = 1;
  const std::vector<Point> positions = {{-2, 0, 0}, {0, 0, 0},  {1, 0, 0},
                                        {0, 1, 0},  {-1, 0, 0}, {-0.35, 0, 0},
                                        {0, -1, 0}};
  const TriangleSoup soup = {positions,
                             {{0, 1, 3},
                              {1, 2, 3},
                              // On the edge 4-2, with its other side below.
                              {2, 1, 5},
                              {1, 4, 5},
                              {4, 2, 5},
                              {4, 6, 2}}};
  for (uint64_t seed = 1; seed <= 30; ++seed) {
    const std::vector<double> got =
        BruteForce(RotateAndShift(soup, seed)).Distances(kStart);
    EXPECT_NEAR(got[kCorner], 2, 1e-14);
    EXPECT_NEAR(got[2], 3, 1e-14) << seed;
    EXPECT_NEAR(got[4], 3, 1e-14) << seed;
    EXPECT_NEAR(got[5], 2.35, 1e-14) << seed;
    EXPECT_NEAR(got[6], 3, 1e-14) << seed;
  }
}

TEST(Oracles, BruteForceUnfoldsFansPrismsAndFoldedSheets) {
  for (const double angle : {1.0, 3.0, 5.5, 6.283185307179586, 7.0, 11.0}) {
    for (const bool closed : {true, false}) {
      const Fan fan(
          {.spokes = 8, .rings = 3, .total_angle = angle, .closed = closed});
      ExpectBruteForce(
          {"fan of angle " + std::to_string(angle), fan.soup()},
          [&](uint32_t s, uint32_t v) { return fan.Distance(s, v); });
    }
  }
  const Prism prism({.sides = 7, .rows = 4});
  ExpectBruteForce({"prism", prism.soup()}, [&](uint32_t s, uint32_t v) {
    return prism.Distance(s, v);
  });
  const FoldedSheet sheet(6, 4, 5);
  ExpectBruteForce({"folded sheet", sheet.soup()}, [&](uint32_t s, uint32_t v) {
    return sheet.Distance(s, v);
  });
}

TEST(Oracles, BruteForceUnfoldsConvexPolyhedra) {
  for (const Polyhedron& polyhedron :
       {Tetrahedron(), Octahedron(), Icosahedron(), Box(1, 2, 0.5),
        Box(3, 1, 0.01)}) {
    TriangleSoup soup = SplitFaces(Triangulate(polyhedron), 6, 2);
    if (polyhedron.name == "tetrahedron") soup = SubdivideAtMidpoints(soup);
    ExpectBruteForce({polyhedron.name, soup}, [&](uint32_t s, uint32_t v) {
      return DistanceOnConvex(polyhedron, soup.positions[s], soup.positions[v]);
    });
  }
}

// The spider and the fly: from 1 below the ceiling to 1 above the floor of the
// opposite wall takes 40 in a 30 x 12 x 12 room (Dudeney 1903).
TEST(Oracles, ConvexDistanceSolvesSpiderAndFly) {
  EXPECT_NEAR(DistanceOnConvex(Box(30, 12, 12), {0, 6, 11}, {30, 6, 1}), 40,
              1e-13);
}

// From a box's corner to the opposite one: over the two faces whose sides add
// up to the longest side last.
TEST(Oracles, ConvexDistanceCrossesBoxCornerToCorner) {
  EXPECT_NEAR(DistanceOnConvex(Box(1, 2, 4), {0, 0, 0}, {1, 2, 4}), 5, 1e-14);
}

TEST(Oracles, BruteForceLeavesOtherPiecesOutOfReach) {
  const TriangleSoup piece = Triangulate(Tetrahedron());
  const TriangleSoup soup = AddIsolatedVertices(Join(piece, piece), 1);
  const std::vector<double> distances = BruteForce(soup).Distances(1);
  for (uint32_t v = 0; v < 4; ++v) EXPECT_LT(distances[v], 3) << v;
  for (uint32_t v = 4; v < 9; ++v) EXPECT_EQ(distances[v], HUGE_VAL) << v;
}

}  // namespace
}  // namespace geodesic::test
