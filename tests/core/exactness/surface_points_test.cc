// Sources and targets anywhere on the surface, against Euclid, brute force and
// the same points made vertices.

#include "tests/support/surface_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "absl/strings/str_cat.h"
#include "tests/core/exactness/every_algorithm.h"
#include "tests/support/meshes/curved_meshes.h"
#include "tests/support/meshes/mesh_edits.h"
#include "tests/support/meshes/planar_meshes.h"
#include "tests/support/meshes/polyhedra.h"

namespace geodesic::test {
namespace {

// Points of every kind, some of them very near vertices and edges.
std::vector<SurfacePoint> ManyPoints(const TriangleSoup& soup, uint32_t count,
                                     Random& random) {
  std::vector<SurfacePoint> points;
  for (uint32_t i = 0; i < count; ++i) {
    points.push_back(RandomSurfacePoint(soup, random));
  }
  // Two of them in one face.
  if (const auto* in_face = std::get_if<FacePoint>(&points[0])) {
    points.push_back(FacePoint{in_face->face, {0.5, 0.25, 0.25}});
  }
  return points;
}

// On a plane: the least of Euclid's distances from the sources, of vertices and
// then of targets.
std::vector<double> EuclidFrom(const TriangleSoup& soup,
                               const std::vector<Source>& sources,
                               const std::vector<SurfacePoint>& targets) {
  std::vector<double> distances;
  const auto add = [&](const Vec3& p) {
    Real least = std::numeric_limits<Real>::infinity();
    for (const Source& source : sources) {
      least = std::min(
          least, source.offset + Norm(p - PositionIn(soup, PointOf(source))));
    }
    distances.push_back(static_cast<double>(least));
  };
  for (const Point& p : soup.positions) add(ToVec3(p));
  for (const SurfacePoint& t : targets) add(PositionIn(soup, t));
  return distances;
}

class SurfacePoints : public EveryAlgorithm {
 protected:
  void ExpectEuclidFrom(const TriangleSoup& soup, const Mesh& mesh,
                        const std::vector<Source>& sources,
                        const std::vector<SurfacePoint>& targets) const {
    ExpectAnswer("grid", mesh, {.sources = sources, .targets = targets},
                 EuclidFrom(soup, sources, targets),
                 CoordinateRounding(soup.positions));
  }
};

TEST_P(SurfacePoints, EuclidInThePlane) {
  Random random(1);
  for (const Diagonals diagonals :
       {Diagonals::kParallel, Diagonals::kAlternating, Diagonals::kRandom}) {
    for (const double jitter : {0.0, 0.2}) {
      const TriangleSoup soup = MakeGrid(
          {.columns = 9, .rows = 7, .diagonals = diagonals, .jitter = jitter});
      const auto mesh = BuildOrFail({"grid", soup});
      const std::vector<SurfacePoint> targets = ManyPoints(soup, 40, random);
      for (int i = 0; i < 8; ++i) {
        ExpectEuclidFrom(soup, *mesh, {{RandomSurfacePoint(soup, random)}},
                         targets);
      }
    }
  }
}

// Sources whose offsets leave them the shadow behind them only: each has a cell
// bounded by a branch of a hyperbola, with another source's on both its sides.
TEST_P(SurfacePoints, OffsetsInThePlane) {
  Random random(4);
  const TriangleSoup soup = MakeGrid({.columns = 9,
                                      .rows = 7,
                                      .diagonals = Diagonals::kRandom,
                                      .jitter = 0.1});
  const auto mesh = BuildOrFail({"grid", soup});
  for (int i = 0; i < 100; ++i) {
    std::vector<Source> sources = {{RandomSurfacePoint(soup, random), 0.5}};
    for (int j = 1; j < 4; ++j) {
      const SurfacePoint point = RandomSurfacePoint(soup, random);
      double offset = std::numeric_limits<double>::infinity();
      for (const Source& other : sources) {
        const Real apart =
            Norm(PositionIn(soup, point) - PositionIn(soup, PointOf(other)));
        offset = std::min(offset, static_cast<double>(other.offset + apart));
      }
      sources.push_back({point, offset * random.Uniform(0.7, 1)});
    }
    ExpectEuclidFrom(soup, *mesh, sources, ManyPoints(soup, 20, random));
  }
}

// Of a row of sources before one that is far behind them, each is the nearest
// in a narrow wedge. On the one edge above them windows of the far one
// alternate with theirs, and are tied with them where they change over.
TEST_P(SurfacePoints, SourcesBeforeAnother) {
  constexpr uint32_t kRow = 100;
  constexpr double kFar = 256, kEdge = 36, kLead = 1e-3;
  TriangleSoup soup;
  for (uint32_t i = 0; i <= kRow; ++i) {
    soup.positions.push_back({1.0 * i, 0, 0});
  }
  const uint32_t far = kRow + 1, left = kRow + 2, right = kRow + 3;
  soup.positions.push_back({kRow / 2.0, -kFar, 0});
  soup.positions.push_back({0, kEdge, 0});
  soup.positions.push_back({kRow, kEdge, 0});
  for (uint32_t i = 0; i < kRow; ++i) {
    soup.triangles.push_back({far, i + 1, i});
    soup.triangles.push_back({i, i + 1, left});
  }
  soup.triangles.push_back({kRow, right, left});
  // An arc above the edge, from the right.
  uint32_t before = right;
  for (uint32_t i = 1; i < 4 * kRow; ++i) {
    const double x = kRow - i / 4.0;
    const auto next = static_cast<uint32_t>(soup.positions.size());
    soup.positions.push_back({x, kEdge + x * (kRow - x) / 64, 0});
    soup.triangles.push_back({left, before, next});
    before = next;
  }
  std::vector<Source> sources = {{VertexPoint{far}}};
  for (uint32_t i = 2; i + 2 <= kRow; ++i) {
    const Real apart = Distance(soup.positions[far], soup.positions[i]);
    sources.push_back({VertexPoint{i}, static_cast<double>(apart) - kLead});
  }
  const NamedMesh named{"a row of sources before another", soup};
  ExpectField(named.name, *BuildOrFail(named), sources,
              EuclidFrom(soup, sources, {}));
}

// A point made a vertex changes nothing, as a source or as a target.
TEST_P(SurfacePoints, AreAsGoodAsVertices) {
  Random random(3);
  for (const NamedMesh& named : std::vector<NamedMesh>{
           {"noisy torus", Torus({.around = 16, .across = 10, .noise = 0.2})},
           {"anisotropic torus", Torus({.around = 5, .across = 40})},
           {"icosphere", Icosphere(2)},
           {"box", BoxGrid(1, 2, 3, 3, 4, 5)},
           {"U plate", MakePlate(UShape({.columns = 7, .rows = 6}), 0.3)},
           // Where sources and targets hide behind reflex corners.
           {"hole", MakeGrid(WithHole({.columns = 9, .rows = 9}))},
           {"jittered U",
            MakeGrid(UShape({.columns = 9, .rows = 9, .jitter = 0.2}))}}) {
    const auto mesh = BuildOrFail(named);
    for (int i = 0; i < 4; ++i) {
      const SurfacePoint point = i % 2 ? RandomFacePoint(named.soup, random)
                                       : RandomEdgePoint(named.soup, random);
      const Inserted inserted = InsertPoint(named.soup, point);
      const auto finer = BuildOrFail({named.name, inserted.soup});
      std::vector<double> expected =
          SolveOn(*finer, {{VertexPoint{inserted.vertex}}});
      expected.pop_back();  // of the point itself
      ExpectField(named.name, *mesh, {{point}}, expected);
      // And as a target.
      const Source vertex{RandomVertexPoint(named.soup, random)};
      ExpectAnswer(named.name, *mesh, {.sources = {vertex}, .targets = {point}},
                   SolveOn(*finer, {vertex}));
    }
  }
}

// Every algorithm with sources and targets of all kinds on small meshes of all
// kinds. A case computes its reference once.
TEST(AnyPointsOnRandomMeshes, AgreeWithBruteForce) {
  for (uint64_t seed = 0; seed < 120; ++seed) {
    const NamedMesh named{absl::StrCat("edited mesh ", seed),
                          EditedMesh(seed / 2, seed % 2 == 0)};
    const auto mesh = BuildOrFail(named);
    Random random(seed);
    const std::vector<SurfacePoint> points = ManyPoints(named.soup, 8, random);
    const BruteForce brute_force(named.soup, points);
    for (int i = 0; i < 3; ++i) {
      Query query{.targets = points};
      for (int j = 0; j < (i == 2 ? 3 : 1); ++j) {
        query.sources.push_back(
            {points[random.Below(static_cast<uint32_t>(points.size()))],
             i == 2 ? random.Uniform(0, 0.3) : 0});
      }
      ExpectFromAll(kAlgorithms, named.name, *mesh, query,
                    brute_force.Distances(query.sources),
                    CoordinateRounding(named.soup.positions));
    }
  }
}

// Curves beside a point, on surfaces with turned faces and a fin: edges with
// three faces.
TEST(CurvesOnRandomMeshes, AgreeWithBruteForce) {
  for (uint64_t seed = 0; seed < 30; ++seed) {
    Random random(seed);
    TriangleSoup soup =
        seed % 2
            ? Terrain(4, 4, 1, seed)
            : Torus({.around = 6, .across = 5, .noise = 0.3, .seed = seed});
    const Triangle at = soup.triangles[random.Below(
        static_cast<uint32_t>(soup.triangles.size()))];
    soup.positions.push_back({0.3, random.Uniform(-1, 1), 1.5});
    soup.triangles.push_back(
        {at[0], at[1], static_cast<uint32_t>(soup.positions.size() - 1)});
    const NamedMesh named{absl::StrCat("surface with a fin ", seed),
                          TurnFaces(soup, seed)};
    const auto mesh = BuildOrFail(named);
    const std::vector<Source> point = {{RandomSurfacePoint(soup, random), 0.3}};
    Query query{.sources = point, .targets = ManyPoints(named.soup, 8, random)};
    std::vector<Source> curves;
    for (int i = 0; i < 2; ++i) {
      curves.push_back(
          {Curve{RandomCurve(named.soup, 5, random)}, random.Uniform(0, 0.5)});
      query.sources.push_back(curves.back());
    }
    std::vector<SurfacePoint> points = query.targets;
    points.push_back(PointOf(point[0]));
    std::vector<double> expected =
        BruteForce(named.soup, points, curves).DistancesFromAll(point);
    expected.pop_back();
    ExpectFromAll(kAlgorithms, named.name, *mesh, query, expected,
                  CoordinateRounding(named.soup.positions));
  }
}

// Surfaces a million times as long as wide: rays run along edges for long.
TEST(StretchedMeshes, AgreeWithBruteForce) {
  int compared = 0;
  for (uint64_t seed = 0; seed < 20; ++seed) {
    Random random(seed);
    TriangleSoup soup = seed % 2 ? BoxGrid(1, 2, 1, 3, 4, 2)
                                 : MakeGrid({.columns = 7,
                                             .rows = 5,
                                             .diagonals = Diagonals::kRandom,
                                             .seed = seed});
    const double factor = std::pow(10, random.Uniform(-6, -4));
    for (Point& p : soup.positions) p[seed % 3 == 0] *= factor;
    const NamedMesh named{absl::StrCat("stretched mesh ", seed),
                          RotateAndShift(soup, seed)};
    const auto mesh = BuildOrFail(named);
    constexpr uint64_t kMostWindows = 2'000'000;
    const BruteForce brute_force(named.soup, {}, {}, kMostWindows);
    if (!brute_force.is_complete()) continue;
    ++compared;
    for (int i = 0; i < 6; ++i) {
      const uint32_t s = random.Below(mesh->vertex_count());
      ExpectFromAll(kAlgorithms, named.name, *mesh,
                    {.sources = {{VertexPoint{s}}}}, brute_force.Distances(s),
                    4 * CoordinateRounding(named.soup.positions));
    }
  }
  EXPECT_GE(compared, 5);
}

GEODESIC_TEST_EVERY_ALGORITHM(SurfacePoints);

}  // namespace
}  // namespace geodesic::test
