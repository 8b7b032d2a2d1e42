// Isolines against closed forms and the distances of points.

#include "geodesic/isolines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "tests/core/exactness/every_algorithm.h"
#include "tests/core/questions/isoline_checks.h"
#include "tests/support/checkpoints.h"
#include "tests/support/meshes/curved_meshes.h"
#include "tests/support/meshes/mesh_edits.h"
#include "tests/support/meshes/planar_meshes.h"
#include "tests/support/oracles/planar_oracles.h"
#include "tests/support/surface_points.h"

namespace geodesic::test {
namespace {

class Isolines : public EveryAlgorithm {
 protected:
  Query From(const std::vector<Source>& sources) const {
    return Ask({.sources = sources});
  }
};

// Levels spread over the distances of a query, at no vertex.
std::vector<double> SpreadLevels(const Mesh& mesh, const Query& query,
                                 uint32_t count) {
  const double farthest =
      FarthestOf(SolveOrFail(mesh, query.algorithm, query.sources));
  std::vector<double> levels;
  for (uint32_t i = 0; i < count; ++i) {
    levels.push_back(farthest * (i + 0.31) / count);
  }
  return levels;
}

TEST_P(Isolines, CirclesInThePlane) {
  for (const double jitter : {0.0, 0.2}) {
    for (const uint32_t cells : {8u, 32u}) {
      const double width = 8.0 / cells;
      const TriangleSoup soup = MakeGrid({.columns = cells,
                                          .rows = cells,
                                          .cell_width = width,
                                          .cell_height = width,
                                          .diagonals = Diagonals::kAlternating,
                                          .jitter = jitter});
      const auto mesh = BuildOrFail({"grid", soup});
      const uint32_t middle = (cells / 2) * (cells + 1) + cells / 2;
      const Point& center = soup.positions[middle];
      const std::vector<double> levels = {1.37, 2.9, 3.7};
      const std::vector<Isoline> isolines =
          IsolinesOrFail(*mesh, From({{VertexPoint{middle}}}), levels);
      ASSERT_EQ(isolines.size(), levels.size());
      for (size_t i = 0; i < levels.size(); ++i) {
        EXPECT_EQ(isolines[i].level, levels[i]);
        EXPECT_TRUE(isolines[i].is_closed);
        Real area = 0;
        const std::vector<Point>& p = isolines[i].positions;
        for (size_t j = 0; j < p.size(); ++j) {
          EXPECT_NEAR(Distance(p[j], center), levels[i],
                      kRelativeTolerance * levels[i]);
          const Point& next = p[(j + 1) % p.size()];
          area += (p[j][0] * next[1] - next[0] * p[j][1]) / 2;
        }
        const double circle = 2 * std::numbers::pi * levels[i];
        EXPECT_LT(Length(isolines[i]), circle);
        EXPECT_GT(Length(isolines[i]), circle * (1 - kChordErrorOfLevel));
        // The grid's faces run anticlockwise, so do curves around the source.
        EXPECT_GT(area, 0);
      }
    }
  }
}

// From a corner: quarters of circles from side to side, then arcs cut in two.
TEST_P(Isolines, OpenArcsEndAtTheBoundary) {
  const TriangleSoup soup = MakeGrid({.columns = 10, .rows = 6});
  const auto mesh = BuildOrFail({"grid", soup});
  for (const uint32_t corner : {0, 10, 66, 76}) {
    const Point& center = soup.positions[corner];
    const Query query = From({{VertexPoint{corner}}});
    for (const auto& [level, arc] :
         {std::pair(3.3, 3.3 * std::numbers::pi / 2),
          std::pair(7.1, 7.1 * std::asin(6 / 7.1)),
          std::pair(10.9,
                    10.9 * (std::asin(6 / 10.9) - std::acos(10 / 10.9)))}) {
      SCOPED_TRACE(level);
      const auto isolines = IsolinesOrFail(*mesh, query, {level});
      ASSERT_EQ(isolines.size(), 1u);
      EXPECT_FALSE(isolines[0].is_closed);
      EXPECT_NEAR(Length(isolines[0]), arc, arc * 0.01);
      // What is nearer lies on the left.
      const std::vector<Point>& p = isolines[0].positions;
      for (size_t i = 1; i < p.size(); ++i) {
        const Vec3 from = ToVec3(p[i - 1]) - ToVec3(center);
        EXPECT_GT(Cross(from, ToVec3(p[i]) - ToVec3(center)).z, 0);
      }
    }
    EXPECT_TRUE(IsolinesOrFail(*mesh, query, {12.0}).empty());
    ExpectIsolines({"grid", soup}, query, {0.2, 3.3, 7.1, 10.9, 11.6}, 300);
  }
}

// Rows of vertices exactly at the level.
TEST_P(Isolines, ThroughVertices) {
  const TriangleSoup soup = MakeGrid({.columns = 12, .rows = 12});
  const NamedMesh named{"grid", soup};
  const uint32_t middle = 6 * 13 + 6;
  const std::vector<double> levels = {1, std::sqrt(2.0), 2, 3, 4, 5, 6};
  ExpectIsolines(named, From({{VertexPoint{middle}}}), levels, 300);
  const auto mesh = BuildOrFail(named);
  for (const double level : {1.0, 2.0, 3.0, 4.0, 5.0}) {
    const auto isolines =
        IsolinesOrFail(*mesh, From({{VertexPoint{middle}}}), {level});
    ASSERT_EQ(isolines.size(), 1u) << level;
    EXPECT_TRUE(isolines[0].is_closed);
    std::vector<uint32_t> vertices;
    for (const SurfacePoint& point : isolines[0].points) {
      if (const auto* at = std::get_if<VertexPoint>(&point)) {
        vertices.push_back(at->vertex);
      }
    }
    // Each vertex at that distance once.
    std::vector<uint32_t> expected;
    for (uint32_t v = 0; v < soup.positions.size(); ++v) {
      const double dx = soup.positions[v][0] - 6, dy = soup.positions[v][1] - 6;
      if (dx * dx + dy * dy == level * level) expected.push_back(v);
    }
    std::ranges::sort(vertices);
    EXPECT_EQ(vertices, expected) << level;
  }
  // Straight: all of a side of the grid as source, as points with offset 0.
  std::vector<Source> side;
  for (uint32_t v = 0; v < 13; ++v) side.push_back({VertexPoint{v}});
  ExpectIsolines(named, From(side), {1, 2, 3}, 300);
}

// However close: the polylines part and join as the discs do, inside of a face.
TEST_P(Isolines, OfTwoSourcesMeet) {
  const TriangleSoup soup = MakeGrid({.columns = 10, .rows = 6});
  const auto mesh = BuildOrFail({"grid", soup});
  struct Meeting {
    std::vector<Source> sources;
    double level;
    // Whether the first of the two, and the one they become, is closed.
    bool is_closed;
  };
  // Two circles meet at (5.1, 3.2); a circle meets the parallel of a line,
  // which runs from side to side, at (4.55, 3.3).
  const Meeting circles{
      {{Locate(soup, {3.3, 3.3})}, {Locate(soup, {6.9, 3.1})}},
      std::hypot(3.6, 0.2) / 2,
      true};
  const Meeting parallel{
      {{Locate(soup, {6.9, 3.3})}, OnMesh(soup, {{{2.2, 0.2}, {2.2, 5.8}}, 0})},
      (6.9 - 2.2) / 2,
      false};
  const Query from_points = From(circles.sources);
  EXPECT_EQ(IsolinesOrFail(*mesh, from_points, {circles.level / 2}).size(), 2u);
  for (const Meeting& meeting : {circles, parallel}) {
    const Query query = From(meeting.sources);
    for (const double part : {0.99, 0.9999, 0.99999999}) {
      const auto apart = IsolinesOrFail(*mesh, query, {meeting.level * part});
      ASSERT_EQ(apart.size(), 2u) << part;
      EXPECT_EQ(apart[0].is_closed, meeting.is_closed);
      EXPECT_TRUE(apart[1].is_closed);
      const auto joined = IsolinesOrFail(*mesh, query, {meeting.level / part});
      ASSERT_EQ(joined.size(), 1u) << part;
      EXPECT_EQ(joined[0].is_closed, meeting.is_closed);
    }
    ExpectIsolines(
        {"grid", soup}, query,
        {0.1, 0.9, meeting.level * 0.999, meeting.level * 1.001, 2.5, 3.4}, 300,
        1e-14);
  }
}

TEST_P(Isolines, Spheres) {
  const TriangleSoup soup = Icosphere(3);
  const auto mesh = BuildOrFail({"icosphere", soup});
  const Query query = From({{VertexPoint{11}}});
  const std::vector<double> levels = SpreadLevels(*mesh, query, 8);
  const auto isolines = IsolinesOrFail(*mesh, query, levels);
  ASSERT_EQ(isolines.size(), levels.size());
  for (size_t i = 0; i < levels.size(); ++i) {
    EXPECT_EQ(isolines[i].level, levels[i]);
    EXPECT_TRUE(isolines[i].is_closed);
    const double circle = 2 * std::numbers::pi * std::sin(levels[i]);
    EXPECT_NEAR(Length(isolines[i]), circle, 0.05 * circle);
  }
}

// Questions of all kinds on meshes of all kinds.
TEST_P(Isolines, SeparateNearFromFar) {
  const std::vector<NamedMesh> meshes = {
      {"terrain", Terrain(9, 7, 0.9, 4)},
      {"torus", Torus({.noise = 0.1, .seed = 2})},
      {"plate with a hole",
       MakePlate(WithHole({.columns = 6, .rows = 6, .jitter = 0.2}), 0.7)},
      {"U shape", MakeGrid(UShape({.columns = 9,
                                   .rows = 9,
                                   .cell_width = 0.3,
                                   .diagonals = Diagonals::kRandom}))},
      {"needles", InsertNeedles(Terrain(4, 4, 0.5, 3), 12, 5)},
      {"icosphere", Icosphere(3)},
      {"two components", Join(Terrain(4, 4, 0.6, 1), Icosphere(1))}};
  for (const NamedMesh& named : meshes) {
    const auto mesh = BuildOrFail(named);
    const auto& [a, b, c] =
        named.soup.triangles[named.soup.triangles.size() / 3];
    const std::vector<Query> queries = {From({{VertexPoint{5}}}),
                                        From({{EdgePoint{a, b, 0.37}}}),
                                        From({{FacePoint{2, {0.2, 0.3, 0.5}}}}),
                                        From({{VertexPoint{b}, 0.3},
                                              {FacePoint{8, {0.6, 0.3, 0.1}}},
                                              {VertexPoint{14}, 0.1}})};
    for (const Query& query : queries) {
      ExpectIsolines(named, query, SpreadLevels(*mesh, query, 9), 150, 1e-14);
    }
  }
}

TEST(IsolinesWithinATolerance, SeparateNearFromFar) {
  const std::vector<NamedMesh> meshes = {
      {"terrain", Terrain(24, 24, 0.6, 4)},
      {"rough terrain", Terrain(16, 16, 3, 5)},
      {"icosphere", Icosphere(3)},
      {"torus", Torus({.around = 40, .across = 20})},
      {"grid", MakeGrid({.columns = 24, .rows = 24})},
      {"plate", MakePlate(WithHole({.columns = 16, .rows = 16}), 0.3)},
      {"needles", InsertNeedles(Terrain(14, 14, 1, 5), 60, 5)},
      {"two components", Join(Terrain(9, 9, 0.6, 1), Icosphere(2))}};
  for (const NamedMesh& named : meshes) {
    const auto mesh = BuildOrFail(named);
    for (const double tolerance : {1e-6, 1e-3, 1e-2, 0.1}) {
      SCOPED_TRACE(tolerance);
      for (Query query :
           {Query{.sources = {{VertexPoint{5}}}},
            Query{.sources = {{FacePoint{2, {0.2, 0.3, 0.5}}}}},
            Query{.sources = {{VertexPoint{9}, 0.1}, {VertexPoint{14}}}}}) {
        const std::vector<double> levels = SpreadLevels(*mesh, query, 7);
        query.tolerance = tolerance;
        ExpectIsolines(named, query, levels, 150, 1e-14);
      }
    }
  }
}

// Parallels of polylines in the plane: beside a curve, around its ends and
// corners, between two curves.
TEST_P(Isolines, AroundCurves) {
  for (const double jitter : {0.0, 0.22}) {
    const NamedMesh named{"grid", MakeGrid({.columns = 12,
                                            .rows = 10,
                                            .diagonals = Diagonals::kRandom,
                                            .jitter = jitter})};
    const auto mesh = BuildOrFail(named);
    const PlanarCurve bent{{{2.2, 2.1}, {6.1, 7.3}, {8.7, 3.9}}, 0};
    const PlanarCurve short_one{{{5.3, 4.1}, {5.5, 4.2}}, 0.25};
    const PlanarCurve straight{{{1, 9}, {4, 9}}, 0};
    const std::vector<double> levels = {0.04, 0.3, 0.77, 1.31, 1.5, 2.2, 3.1};
    for (const std::vector<PlanarCurve>& curves :
         {std::vector{bent}, std::vector{short_one}, std::vector{straight},
          std::vector{bent, straight},
          std::vector{bent, short_one, straight}}) {
      Query query = From({});
      for (const PlanarCurve& curve : curves) {
        query.sources.push_back(OnMesh(named.soup, curve));
      }
      ExpectIsolines(named, query, levels, 300, 1e-14);
      for (const Isoline& isoline : IsolinesOrFail(*mesh, query, levels)) {
        for (const Point& p : isoline.positions) {
          double least = std::numeric_limits<double>::infinity();
          for (const PlanarCurve& curve : curves) {
            least = std::min(least, DistanceTo(curve, p));
          }
          EXPECT_NEAR(least, isoline.level, 1e-12);
        }
      }
    }
    // A ring around one curve: its sides, and a circle's worth of ends.
    Query query = From({});
    query.sources = {OnMesh(named.soup, {{{3.3, 4.2}, {8.4, 5.9}}, 0})};
    const auto rings = IsolinesOrFail(*mesh, query, {1.7});
    ASSERT_EQ(rings.size(), 1u);
    EXPECT_TRUE(rings[0].is_closed);
    const double ring = 2 * std::hypot(5.1, 1.7) + 2 * std::numbers::pi * 1.7;
    EXPECT_NEAR(Length(rings[0]), ring, 0.02 * ring);
    EXPECT_LE(Length(rings[0]), ring);
  }
}

// Isolines end where three pages meet, and go through edges whose faces
// disagree in orientation.
TEST_P(Isolines, OffOrientedManifolds) {
  const NamedMesh book{"book", Book(MakeGrid({.columns = 4, .rows = 5}), 3)};
  const auto pages = BuildOrFail(book);
  for (const uint32_t s : {5u, 13u, 38u}) {
    const Query query = From({{VertexPoint{s}}});
    ExpectIsolines(book, query, SpreadLevels(*pages, query, 8), 300);
  }
  const NamedMesh turned{"torus with faces turned",
                         TurnFaces(Torus({.noise = 0.1, .seed = 2}), 7)};
  const auto torus = BuildOrFail(turned);
  const Query query = From({{VertexPoint{5}}});
  ExpectIsolines(turned, query, SpreadLevels(*torus, query, 8), 300);
}

// Cutting faces in their own plane changes nothing.
TEST_P(Isolines, AreTheSameOnFinerFaces) {
  std::vector<NamedMesh> meshes = {
      {"plate", MakePlate(LShape({.columns = 4, .rows = 4, .jitter = 0.2}), 1)},
      {"tetrahedral sphere", Icosphere(0)},
      {"torus", Torus({.around = 5, .across = 4, .noise = 0.2, .seed = 6})}};
  for (const uint64_t seed : {1, 2, 3}) {
    meshes.push_back({"terrain", Terrain(4, 3, 1.5, seed)});
  }
  for (const NamedMesh& coarse : meshes) {
    const TriangleSoup halves = SubdivideAtMidpoints(coarse.soup);
    const auto mesh = BuildOrFail(coarse);
    const auto finer = BuildOrFail({coarse.name, halves});
    const Query query =
        From({{VertexPoint{1}}, {VertexPoint{7}, 0.11}, {VertexPoint{10}}});
    for (const double level : SpreadLevels(*mesh, query, 25)) {
      const auto isolines = IsolinesOrFail(*mesh, query, {level});
      const auto finer_ones = IsolinesOrFail(*finer, query, {level});
      EXPECT_EQ(isolines.size(), finer_ones.size())
          << coarse.name << ", level " << level;
      EXPECT_EQ(std::ranges::count(isolines, true, &Isoline::is_closed),
                std::ranges::count(finer_ones, true, &Isoline::is_closed))
          << coarse.name << ", level " << level;
      const double length = Length(isolines);
      EXPECT_NEAR(length, Length(finer_ones), 5e-3 * length);
    }
  }
}

TEST_P(Isolines, ComeInOrderOfLevelEachOnce) {
  const auto mesh = BuildOrFail({"terrain", Terrain(8, 8, 0.8, 2)});
  const Query query = From({{VertexPoint{40}}});
  const auto isolines = IsolinesOrFail(*mesh, query, {3, 1, 2.5, 1});
  ASSERT_FALSE(isolines.empty());
  EXPECT_TRUE(std::ranges::is_sorted(isolines, {}, &Isoline::level));
  std::vector<Isoline> one_by_one;
  for (const double level : {1.0, 2.5, 3.0}) {
    for (Isoline& isoline : IsolinesOrFail(*mesh, query, {level})) {
      one_by_one.push_back(std::move(isoline));
    }
  }
  ASSERT_EQ(isolines.size(), one_by_one.size());
  for (size_t i = 0; i < isolines.size(); ++i) {
    EXPECT_EQ(isolines[i].level, one_by_one[i].level);
    EXPECT_EQ(isolines[i].is_closed, one_by_one[i].is_closed);
    ASSERT_EQ(isolines[i].points.size(), one_by_one[i].points.size());
    for (size_t p = 0; p < isolines[i].points.size(); ++p) {
      EXPECT_LT(Distance(isolines[i].positions[p], one_by_one[i].positions[p]),
                1e-12);
    }
  }
}

TEST_P(Isolines, ScaleWithTheMesh) {
  const TriangleSoup soup = Terrain(6, 6, 0.8, 2);
  for (const double scale : {0x1p-400, 0x1p300}) {
    const auto mesh = BuildOrFail({"terrain", soup});
    const auto scaled = BuildOrFail({"scaled terrain", Scale(soup, scale)});
    const Query query = From({{VertexPoint{20}}});
    const auto isolines = IsolinesOrFail(*mesh, query, {1.5, 2.5});
    const auto scaled_ones =
        IsolinesOrFail(*scaled, query, {1.5 * scale, 2.5 * scale});
    ASSERT_EQ(isolines.size(), scaled_ones.size());
    for (size_t i = 0; i < isolines.size(); ++i) {
      EXPECT_EQ(isolines[i].points, scaled_ones[i].points);
    }
  }
}

GEODESIC_TEST_EVERY_ALGORITHM(Isolines);

TEST(IsolinesErrors, SayWhatIsWrong) {
  const auto mesh = BuildOrFail({"grid", MakeGrid({.columns = 2, .rows = 2})});
  NoCheckpoint checkpoint;
  const Query query{.sources = {{VertexPoint{0}}}};
  const auto error = [&](std::vector<double> levels) {
    return ComputeIsolines(*mesh, Valid(*mesh, query), {std::move(levels)}, {},
                           checkpoint)
        .status();
  };
  EXPECT_EQ(error({}),
            absl::InvalidArgumentError("levels is empty: name at least one"));
  EXPECT_EQ(error({1, 0}), absl::InvalidArgumentError(
                               "levels[1] 0 is not a finite number > 0"));
  EXPECT_EQ(
      error({std::numeric_limits<double>::infinity()}),
      absl::InvalidArgumentError("levels[0] inf is not a finite number > 0"));
}

// With so many levels that every window is kept for a while, faces are dealt
// with while the wavefront moves: to the same end, and in memory that goes with
// the wavefront.
TEST(IsolinesOfManyLevels, AreThoseOfEachLevel) {
  const NamedMesh named{"icosphere", Icosphere(5)};
  const auto mesh = BuildOrFail(named);
  const Query query{.sources = {{EdgePoint{0, mesh->triangle(0)[1], 0.3}}}};
  std::vector<double> levels;
  for (int i = 1; i < 150; ++i) levels.push_back(0.0207 * i);
  RecordingCheckpoint checkpoint;
  const auto isolines =
      ComputeIsolines(*mesh, Valid(*mesh, query), {levels}, {}, checkpoint);
  ASSERT_TRUE(isolines.ok()) << isolines.status();
  uint64_t bytes = 0, windows = 0;
  for (const Progress& progress : checkpoint.polls()) {
    bytes = std::max(bytes, progress.solver_bytes);
    windows = std::max(windows, progress.windows_propagated);
  }
  EXPECT_LT(bytes, windows * sizeof(double) * 3);
  for (size_t i = 0; i < levels.size(); i += 37) {
    std::vector<std::vector<SurfacePoint>> of_level, alone;
    for (const Isoline& isoline : *isolines) {
      if (isoline.level == levels[i]) of_level.push_back(isoline.points);
    }
    for (const Isoline& isoline : IsolinesOrFail(*mesh, query, {levels[i]})) {
      alone.push_back(isoline.points);
    }
    EXPECT_EQ(of_level, alone) << levels[i];
  }
}

// Whoever cancels is heard at every poll, those between faces among them.
TEST(IsolinesErrors, CancelAtAnyPoll) {
  const auto mesh = BuildOrFail({"icosphere", Icosphere(3)});
  const Query query{.sources = {{VertexPoint{0}}}};
  const std::vector<double> levels = SpreadLevels(*mesh, query, 30);
  RecordingCheckpoint never;
  ASSERT_TRUE(
      ComputeIsolines(*mesh, Valid(*mesh, query), {levels}, {}, never).ok());
  EXPECT_GT(never.polls().size(), 20u);
  for (uint64_t poll = 0; poll < never.polls().size(); ++poll) {
    RecordingCheckpoint checkpoint(poll);
    EXPECT_EQ(
        ComputeIsolines(*mesh, Valid(*mesh, query), {levels}, {}, checkpoint)
            .status(),
        RecordingCheckpoint::Stopped());
    EXPECT_EQ(checkpoint.polls().size(), poll + 1);
  }
}

// However few the faces are.
TEST(IsolinesErrors, AskBetweenManyLevelsOfAFace) {
  const auto mesh = BuildOrFail({"icosphere", Icosphere(0)});
  const Query query{.sources = {{VertexPoint{0}}}};
  const std::vector<double> levels = SpreadLevels(*mesh, query, 5000);
  RecordingCheckpoint never;
  ASSERT_TRUE(
      ComputeIsolines(*mesh, Valid(*mesh, query), {levels}, {}, never).ok());
  EXPECT_GT(never.polls().size(), levels.size() / 64);
}

class RealMeshIsolines : public RealMesh {};

TEST_P(RealMeshIsolines, SeparateNearFromFar) {
  const Query query{.sources = {{VertexPoint{named_.soup.triangles[0][0]}}}};
  ExpectIsolines(named_, query, SpreadLevels(*mesh_, query, 6), 2000,
                 CoordinateRounding(named_.soup.positions));
}

INSTANTIATE_TEST_SUITE_P(Meshes, RealMeshIsolines,
                         testing::Values("fandisk.obj", "cgal_elephant.off",
                                         "cgal_blobby_3cc.off",
                                         "of_flange_6k.ply",
                                         "cgal_pinion_small.off",
                                         "gears_19k.ply", "spot_23k.obj"),
                         MeshTestName);

}  // namespace
}  // namespace geodesic::test
