// Paths are as long as distances, cross edges straight and bend where shortest
// paths may, on every kind of generated mesh and on real ones.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "absl/strings/str_cat.h"
#include "geodesic/computation.h"
#include "geodesic/path.h"
#include "tests/core/exactness/every_algorithm.h"
#include "tests/core/questions/path_check.h"
#include "tests/support/meshes/curved_meshes.h"
#include "tests/support/meshes/developable_meshes.h"
#include "tests/support/meshes/mesh_edits.h"
#include "tests/support/meshes/planar_meshes.h"
#include "tests/support/meshes/polyhedra.h"
#include "tests/support/oracles/planar_oracles.h"
#include "tests/support/surface_points.h"

namespace geodesic::test {
namespace {

// Points in faces and on edges, in turn.
std::vector<SurfacePoint> RandomPoints(const TriangleSoup& soup, uint32_t count,
                                       uint64_t seed) {
  Random random(seed);
  std::vector<SurfacePoint> points;
  for (uint32_t i = 0; i < count; ++i) {
    points.push_back(i % 2 == 0 ? RandomFacePoint(soup, random)
                                : RandomEdgePoint(soup, random));
  }
  return points;
}

// Triangles on edges of each other, many of them on the same few, so that there
// are hundreds of ways through a few edges; some are given twice.
TriangleSoup RandomComplex(uint64_t seed) {
  constexpr size_t kFaces = 36;
  Random random(seed);
  TriangleSoup soup{.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                    .triangles = {{0, 1, 2}}};
  while (soup.triangles.size() < kFaces) {
    const auto count = static_cast<uint32_t>(soup.triangles.size());
    const Triangle on = soup.triangles[random.Below(std::min(count, 3u))];
    const uint32_t side = random.Below(3);
    if (random.Below(8) == 0) {
      soup.triangles.push_back({on[1], on[0], on[2]});
      continue;
    }
    Point tip = soup.positions[on[side]];
    for (double& coordinate : tip) coordinate += random.Uniform(-0.4, 0.4);
    soup.triangles.push_back({on[side], on[(side + 1) % 3],
                              static_cast<uint32_t>(soup.positions.size())});
    soup.positions.push_back(tip);
  }
  return soup;
}

class Paths : public EveryAlgorithm {
 protected:
  // From vertices, from points in faces and on edges, and from all of them at
  // once with offsets; to vertices and points.
  void CheckPaths(const NamedMesh& named, PathCheckOptions options = {},
                  uint32_t vertex_sources = 4) const {
    const auto mesh = BuildOrFail(named);
    const std::vector<SurfacePoint> targets = RandomPoints(named.soup, 40, 1);
    const Algorithm algorithm = GetParam().algorithm;
    Query all{.targets = targets, .algorithm = algorithm};
    const auto from = [&](const SurfacePoint& point) {
      CheckAllPaths(
          named.name, *mesh,
          {.sources = {{point}}, .targets = targets, .algorithm = algorithm},
          options);
      all.sources.push_back(
          {point, 0.01 * mesh->mean_edge_length() *
                      std::ldexp(1, mesh->scale_exponent()) *
                      static_cast<double>(all.sources.size())});
    };
    for (uint32_t v : SpreadVertices(named.soup, vertex_sources)) {
      from(VertexPoint{v});
    }
    for (const SurfacePoint& point : RandomPoints(named.soup, 4, 2)) {
      from(point);
    }
    CheckAllPaths(named.name + ", many sources", *mesh, all, options);
  }
};

// Rays run exactly into vertices, and along edges.
TEST_P(Paths, InPlanarGrids) {
  for (const Diagonals diagonals :
       {Diagonals::kParallel, Diagonals::kAlternating, Diagonals::kRandom}) {
    CheckPaths(
        {"grid", MakeGrid({.columns = 12, .rows = 9, .diagonals = diagonals})});
  }
  CheckPaths({"long grid", MakeGrid({.columns = 40, .rows = 3})});
  CheckPaths({"jittered grid", MakeGrid({.columns = 12,
                                         .rows = 10,
                                         .diagonals = Diagonals::kRandom,
                                         .jitter = 0.2})});
}

TEST_P(Paths, AroundHolesAndReflexCorners) {
  for (const double jitter : {0.0, 0.2}) {
    const GridOptions grid{.columns = 9, .rows = 9, .jitter = jitter};
    CheckPaths({"hole", MakeGrid(WithHole(grid))});
    CheckPaths({"L", MakeGrid(LShape(grid))});
    CheckPaths({"U", MakeGrid(UShape(grid))});
  }
  CheckPaths({"plate", MakePlate(UShape({.columns = 6, .rows = 6}), 0.5)});
}

TEST_P(Paths, OnConvexPolyhedra) {
  CheckPaths({"tetrahedron", Triangulate(Tetrahedron())});
  CheckPaths({"octahedron", Triangulate(Octahedron())});
  CheckPaths({"box", BoxGrid(1, 1, 1, 4, 4, 4)});
  CheckPaths({"flat box", BoxGrid(3, 2, 0.25, 6, 4, 1)});
}

TEST_P(Paths, OnConesAndSaddles) {
  for (const double angle : {1.0, 3.0, 6.0, 6.283185307179586, 7.0, 12.0}) {
    CheckPaths({absl::StrCat("fan of ", angle),
                Fan({.spokes = 12, .rings = 4, .total_angle = angle}).soup()});
    CheckPaths(
        {absl::StrCat("open fan of ", angle),
         Fan({.spokes = 12, .rings = 4, .total_angle = angle, .closed = false})
             .soup()});
  }
  CheckPaths({"prism", Prism({}).soup()});
  CheckPaths({"folded sheet", FoldedSheet(12, 8, 3).soup()});
}

TEST_P(Paths, OnCurvedSurfaces) {
  CheckPaths({"icosphere", Icosphere(2)});
  CheckPaths({"UV sphere", UvSphere(16, 12)});
  CheckPaths({"torus", Torus({.around = 16, .across = 10})});
  CheckPaths(
      {"noisy torus", Torus({.around = 16, .across = 10, .noise = 0.2})});
  CheckPaths({"terrain", Terrain(14, 14, 1.5, 4)});
  CheckPaths({"rough terrain", Terrain(14, 14, 12, 5)});
}

// Angles mean little beside faces without area; lengths do.
TEST_P(Paths, ThroughDegenerateFaces) {
  for (const double jitter : {0.0, 0.2}) {
    for (const uint64_t seed : {1, 2}) {
      const TriangleSoup grid =
          MakeGrid({.columns = 9, .rows = 8, .jitter = jitter, .seed = seed});
      const PathCheckOptions options{
          .slack = CoordinateRounding(grid.positions), .check_bends = false};
      CheckPaths({"zero-area faces", InsertZeroAreaFaces(grid, 30, seed)},
                 options);
      CheckPaths({"doubled vertices", DoubleVertices(grid, 15, seed)}, options);
      CheckPaths({"tripled vertices",
                  DoubleVertices(DoubleVertices(grid, 30, seed), 60, seed)},
                 options);
      CheckPaths({"needles", InsertNeedles(grid, 50, seed)}, options);
    }
  }
  CheckPaths({"needles on a torus", InsertNeedles(Torus({}), 80, 3)},
             {.slack = 1e-15, .check_bends = false});
}

// Nearer to one of several vertices at one place than coordinates can tell.
TEST_P(Paths, FromPointsBesideDoubledVertices) {
  for (const uint64_t seed : {1, 2, 3}) {
    const TriangleSoup terrain = Terrain(6, 6, 1.5, seed);
    std::vector<uint32_t> doubled;
    const TriangleSoup soup =
        DoubleVertices(DoubleVertices(terrain, 4, seed), 8, seed, &doubled);
    const auto mesh = BuildOrFail({"doubled vertices", soup});
    for (const SurfacePoint& near : PointsBeside(soup, doubled, 9e-16)) {
      CheckAllPaths("beside doubled vertices", *mesh,
                    Ask({.sources = {{near}}}),
                    {.slack = 8 * CoordinateRounding(soup.positions),
                     .check_bends = false},
                    7);
    }
  }
}

TEST_P(Paths, OfTinyAndHugeMeshes) {
  for (const double factor : {1e-150, 1e-12, 1e12, 1e150}) {
    CheckPaths({absl::StrCat("torus times ", factor),
                Scale(Torus({.noise = 0.2}), factor)});
  }
}

TEST_P(Paths, LeadNowhereToOtherPieces) {
  const TriangleSoup box = BoxGrid(1, 1, 1, 2, 2, 2);
  CheckPaths(
      {"two boxes and lone vertices", AddIsolatedVertices(Join(box, box), 2)});
}

TEST_P(Paths, AcrossFacesOfAnyOrientation) {
  CheckPaths({"turned torus", TurnFaces(Torus({.noise = 0.1}), 7)});
  CheckPaths({"turned grid", TurnFaces(MakeGrid({.columns = 9}), 7)});
  CheckPaths({"turned box", TurnFaces(BoxGrid(1, 2, 1.5, 3, 4, 3), 7)});
}

// Three pages on one spine.
TEST_P(Paths, AcrossEdgesOfManyFaces) {
  const TriangleSoup grid =
      MakeGrid({.columns = 6, .rows = 6, .jitter = 0.2, .seed = 3});
  for (const bool turned : {false, true}) {
    const TriangleSoup book = Book(grid, 3);
    CheckPaths({"book", turned ? TurnFaces(book, 5) : book});
  }
}

TEST_P(Paths, ThroughEdgesOfVeryManyFaces) {
  for (uint64_t seed = 0; seed < 30; ++seed) {
    CheckPaths({absl::StrCat("complex ", seed), RandomComplex(seed)});
  }
}

// All of them are the same way, but to a source in one of them.
TEST_P(Paths, ThroughFacesThatAreThereManyTimes) {
  constexpr size_t kCopies = 24;
  for (uint64_t seed = 0; seed < 30; ++seed) {
    TriangleSoup soup = RandomComplex(seed);
    const Triangle face = soup.triangles[seed % soup.triangles.size()];
    soup.triangles.insert(soup.triangles.end(), kCopies, face);
    CheckPaths({absl::StrCat("complex ", seed), soup});
  }
}

TEST_P(Paths, FromCurves) {
  for (const double jitter : {0.0, 0.24}) {
    const TriangleSoup soup =
        MakeGrid({.columns = 12, .rows = 10, .jitter = jitter, .seed = 5});
    const auto mesh = BuildOrFail({"grid", soup});
    const std::vector<PlanarCurve> curves = {
        {{{2.2, 1.1}, {6.1, 7.3}, {10.3, 3.9}}, 0.5}, {{{1, 8}, {3, 9}}, 0}};
    Query query = Ask({.targets = RandomPoints(soup, 40, 3), .trace = true});
    for (const PlanarCurve& curve : curves) {
      query.sources.push_back(OnMesh(soup, curve));
    }
    CheckAllPaths("curves in a grid", *mesh, query, {.slack = 1e-14});
    // Each starts on the curve that it names.
    const DistanceField field = SolveTraced(*mesh, query);
    const PathTracer tracer = TracerOf(*mesh, query, field);
    for (uint32_t v = 0; v < mesh->vertex_count(); ++v) {
      const GeodesicPath path = tracer.ToVertex(v).value();
      PlanarCurve curve = curves[path.source];
      curve.offset = 0;
      EXPECT_NEAR(DistanceTo(curve, path.positions[0]), 0, 1e-12) << v;
    }
  }
  // Over folds there is no closed form, but the length is the distance.
  const TriangleSoup soup = Terrain(12, 10, 1.5, 4);
  TriangleSoup flat = soup;
  for (Point& p : flat.positions) p[2] = 0;
  const Query query =
      Ask({.sources = {OnMesh(flat, {{{2.2, 1.1}, {9.1, 7.3}}, 0})},
           .targets = RandomPoints(soup, 40, 3)});
  for (const NamedMesh& named :
       {NamedMesh{"curve on terrain", soup},
        NamedMesh{"curve on terrain with backs", AddBackFaces(soup)}}) {
    CheckAllPaths(named.name, *BuildOrFail(named), query, {.slack = 1e-14});
  }
}

// The line from vertex 0 to vertex 4 runs 3e-9 beside vertex 3 and, 3e-9
// farther on, over the edge between vertices 1 and 2. A path that is led
// through vertex 3 crosses that edge elsewhere.
TEST_P(Paths, CrossEdgesRightBehindAVertexThatTheyPass) {
  const TriangleSoup soup{
      .positions =
          {{-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {-3e-9, 0, 0}, {1, 6e-9, 0}},
      .triangles = {{0, 2, 3}, {0, 3, 1}, {2, 1, 3}, {2, 4, 1}}};
  const auto mesh = BuildOrFail({"kite", soup});
  for (const uint32_t source : {0, 4}) {
    CheckAllPaths(
        "kite", *mesh,
        {.sources = {{VertexPoint{source}}}, .algorithm = GetParam().algorithm},
        {.check_bends = false});
  }
}

GEODESIC_TEST_EVERY_ALGORITHM(Paths);

// From a source on a side, along that side: rounding must not have the line
// cross the side beyond the source.
TEST_P(Paths, CrossASideAtTheSourceOnIt) {
  // Vertex 1 lies on the side 0-2 of the first face; the others lead round
  // vertex 2.
  const std::vector<Point> positions = {
      {0, 0, 0},     {1, 0, 0},      {2, 0, 0},   {1.2, -1, 0},
      {0.9, 0.8, 0}, {2.3, -1.1, 0}, {3, -0.3, 0}};
  const TriangleSoup soup = {
      positions,
      {{0, 3, 2}, {2, 1, 0}, {0, 1, 4}, {1, 2, 4}, {3, 5, 2}, {5, 6, 2}}};
  for (uint64_t seed = 1; seed <= 10; ++seed) {
    const auto mesh =
        BuildOrFail({"zero-area face", RotateAndShift(soup, seed)});
    Query query{.sources = {{VertexPoint{1}}},
                .algorithm = GetParam().algorithm};
    for (const uint32_t face : {0u, 4u, 5u}) {
      for (const double a : {3e-10, 1e-9, 0.3}) {
        for (const double b : {8e-10, 1e-7}) {
          query.targets.push_back(FacePoint{face, {a, b, 1 - a - b}});
        }
      }
    }
    CheckAllPaths("along a side", *mesh, query,
                  {.slack = 1e-15, .check_bends = false});
  }
}

TEST(PathTracer, GivesOnePointWhereSourceAndTargetCoincide) {
  const TriangleSoup soup = Icosphere(1);
  const auto mesh = BuildOrFail({"icosphere", soup});
  for (const SurfacePoint& point : RandomPoints(soup, 6, 7)) {
    const Query query{
        .sources = {{point, 2}}, .targets = {point}, .trace = true};
    const DistanceField field = SolveTraced(*mesh, query);
    const GeodesicPath path = TracerOf(*mesh, query, field).ToTarget(0).value();
    EXPECT_EQ(path.points.size(), 1);
    EXPECT_EQ(path.length, 0);
  }
}

TEST(PathTracer, TakesWhatIsNotCertifiedForNotReached) {
  const TriangleSoup soup = MakeGrid({.columns = 12, .rows = 12});
  const auto mesh = BuildOrFail({"grid", soup});
  const Query query{.sources = {{VertexPoint{0}}}, .trace = true};
  const std::unique_ptr<Computation> computation =
      StartComputation(*mesh, Valid(*mesh, query), {}).value();
  NoCheckpoint checkpoint;
  ASSERT_TRUE(computation->Advance({.radius = 5}, checkpoint).ok());
  const DistanceField field = computation->Field();
  int reached = 0;
  const PathTracer tracer = TracerOf(*mesh, query, field);
  for (uint32_t v = 0; v < mesh->vertex_count(); ++v) {
    const GeodesicPath path = tracer.ToVertex(v).value();
    if (std::isfinite(field.distances[v])) {
      ++reached;
      EXPECT_TRUE(IsShortestPath(*mesh, path, VertexPoint{0}, VertexPoint{v},
                                 field.distances[v]));
    } else {
      EXPECT_TRUE(path.points.empty()) << v;
      EXPECT_EQ(path.length, std::numeric_limits<double>::infinity()) << v;
    }
  }
  EXPECT_GT(reached, 1);
  EXPECT_LT(reached, mesh->vertex_count());
}

TEST(PathTracer, RefusesWhatItWasNotAsked) {
  const auto mesh = BuildOrFail({"icosphere", Icosphere(1)});
  const Query query{.sources = {{VertexPoint{0}}},
                    .targets = {VertexPoint{3}},
                    .trace = true};
  const DistanceField field = SolveTraced(*mesh, query);
  const PathTracer tracer = TracerOf(*mesh, query, field);
  EXPECT_EQ(tracer.ToVertex(42).status(),
            absl::InvalidArgumentError("vertex 42 is out of range: the mesh "
                                       "has 42 vertices, numbered from 0"));
  EXPECT_EQ(tracer.ToTarget(1).status(),
            absl::InvalidArgumentError("target 1 is out of range: the query "
                                       "has 1 targets, numbered from 0"));
  // Another query's field, another mesh's, and one without trace.
  const Query other{.sources = {{VertexPoint{0}}}, .trace = true};
  EXPECT_TRUE(absl::IsInvalidArgument(
      PathTracer::Create(*mesh, Valid(*mesh, other), field).status()));
  const auto finer = BuildOrFail({"finer icosphere", Icosphere(2)});
  EXPECT_TRUE(absl::IsInvalidArgument(
      PathTracer::Create(*finer, Valid(*finer, query), field).status()));
  Query untraced = query;
  untraced.trace = false;
  const DistanceField plain = SolveOrFail(*mesh, untraced);
  EXPECT_TRUE(absl::IsInvalidArgument(
      PathTracer::Create(*mesh, Valid(*mesh, query), plain).status()));
}

TEST(PathTracer, SaysSoWhenTheTraceIsBroken) {
  const auto mesh = BuildOrFail({"icosphere", Icosphere(1)});
  const Query query{.sources = {{VertexPoint{0}}}, .trace = true};
  DistanceField circular = SolveTraced(*mesh, query);
  circular.arrivals[1] = {.pseudo_source = 2};
  circular.arrivals[2] = {.pseudo_source = 1};
  EXPECT_TRUE(
      absl::IsInternal(TracerOf(*mesh, query, circular).ToVertex(1).status()));
  DistanceField foreign = SolveTraced(*mesh, query);
  foreign.arrivals[1] = {.pseudo_source = mesh->vertex_count() + 1};
  EXPECT_TRUE(absl::IsInvalidArgument(
      PathTracer::Create(*mesh, Valid(*mesh, query), foreign).status()));
}

// Scans, CAD parts, terrain.
class RealPaths : public RealMesh {};

TEST_P(RealPaths, AreAsLongAsDistances) {
  const double slack = 64 * CoordinateRounding(named_.soup.positions);
  const uint32_t vertex = named_.soup.triangles[0][0];
  const uint32_t face = mesh_->face_count() / 2;
  constexpr uint32_t kMostPaths = 1000;
  const uint32_t stride = 1 + mesh_->vertex_count() / kMostPaths;
  for (const Algorithm algorithm :
       {Algorithm::kFwpList, Algorithm::kFwpCh, Algorithm::kFwpMmp}) {
    CheckAllPaths(named_.name, *mesh_,
                  {.sources = {{VertexPoint{vertex}},
                               {FacePoint{face, {0.5, 0.25, 0.25}}}},
                   .targets = {FacePoint{face / 2, {0.1, 0.8, 0.1}}},
                   .algorithm = algorithm},
                  {.slack = slack}, stride);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Meshes, RealPaths,
    testing::Values("cgal_anchor_dense.off", "cgal_cheese.off",
                    "cgal_elephant.off", "cgal_fandisk_large.off",
                    "cgal_holes.off", "cgal_rotor_small.off",
                    "cgal_three_peaks.off", "of_flange_6k.ply", "fandisk.obj",
                    "spot_23k.obj", "tray_bottom_4k.ply", "bunny.obj",
                    "horse_be.ply"),
    MeshTestName);

}  // namespace
}  // namespace geodesic::test
