// Isolines inside faces, on meshes where they can be told by hand.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <ostream>
#include <variant>
#include <vector>

#include "absl/status/status.h"
#include "geodesic/isolines.h"
#include "geodesic/solve.h"
#include "tests/core/questions/isoline_checks.h"
#include "tests/support/checkpoints.h"
#include "tests/support/meshes/curved_meshes.h"
#include "tests/support/meshes/mesh_edits.h"
#include "tests/support/meshes/planar_meshes.h"
#include "tests/support/meshes/polyhedra.h"
#include "tests/support/oracles/planar_oracles.h"
#include "tests/support/random.h"
#include "tests/support/surface_points.h"

namespace geodesic::test {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// (0, 0), (4, 0), (0, 4).
TriangleSoup LargeTriangle() {
  return {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, {{0, 1, 2}}};
}
TriangleSoup Square() {
  return {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}};
}
// Of side 2.
TriangleSoup Cube() { return Triangulate(Box(2, 2, 2)); }

// Sources in the plane, each a point or a polyline.
using Drawing = std::vector<PlanarCurve>;

Query QueryOf(const TriangleSoup& soup, const Drawing& drawing) {
  Query query;
  for (const PlanarCurve& curve : drawing) {
    query.sources.push_back(
        curve.corners.size() == 1
            ? Source{Locate(soup, curve.corners[0]), curve.offset}
            : OnMesh(soup, curve));
  }
  return query;
}

double DistanceTo(const Drawing& drawing, const Point& p) {
  double least = kInfinity;
  for (const PlanarCurve& curve : drawing) {
    PlanarCurve two = curve;
    if (two.corners.size() == 1) two.corners.push_back(two.corners[0]);
    const auto& [x, y] = curve.corners[0];
    least = std::min(least, curve.corners.size() == 1
                                ? curve.offset + std::hypot(p[0] - x, p[1] - y)
                                : test::DistanceTo(two, p));
  }
  return least;
}

struct Count {
  int open = 0;
  int closed = 0;

  bool operator==(const Count&) const = default;
};
std::ostream& operator<<(std::ostream& out, const Count& count) {
  return out << count.open << " open and " << count.closed << " closed";
}

// Expects so many isolines in a planar mesh on which straight ways are
// shortest; that points lie at the level, and middles of chords within the
// error of it.
std::vector<Isoline> Draw(const TriangleSoup& soup, const Drawing& drawing,
                          double level, const Count& expected,
                          double chord_error = 0) {
  const auto mesh = BuildOrFail({"planar mesh", soup});
  const std::vector<Isoline> isolines =
      IsolinesOrFail(*mesh, QueryOf(soup, drawing), {level}, chord_error);
  const double error = chord_error == 0 ? level * 1e-3 : chord_error;
  Count count;
  for (const Isoline& isoline : isolines) {
    ++(isoline.is_closed ? count.closed : count.open);
    const std::vector<Point>& p = isoline.positions;
    EXPECT_GE(p.size(), isoline.is_closed ? 3u : 2u);
    for (size_t i = 0; i < p.size(); ++i) {
      EXPECT_NEAR(DistanceTo(drawing, p[i]), level, 1e-10 * level + 4e-14);
      if (i + 1 == p.size() && !isoline.is_closed) break;
      const Point& next = p[(i + 1) % p.size()];
      const Point middle = {(p[i][0] + next[0]) / 2, (p[i][1] + next[1]) / 2,
                            0};
      EXPECT_NEAR(DistanceTo(drawing, middle), level, error * 1.000001 + 1e-14)
          << "level " << level << ", between (" << p[i][0] << ", " << p[i][1]
          << ") and (" << next[0] << ", " << next[1] << ")";
    }
  }
  EXPECT_EQ(count, expected) << "level " << level;
  return isolines;
}

// Right of a vertical line through (0.5, 0) the parallel runs up to the height
// of its end, and round that to the diagonal.
TEST(IsolineArcs, RunBesideACurveThatEndsAtAnEdge) {
  const TriangleSoup triangle = {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}},
                                 {{0, 1, 2}}};
  const auto lines =
      Draw(triangle, {{{{0.5, 0}, {0.5, 0.5}}}}, 0.1, {.open = 2});
  ASSERT_EQ(lines.size(), 2u);
  const double at = 0.5 + 0.1 * std::sqrt(0.5);
  EXPECT_NEAR(Length(lines[0]) + Length(lines[1]), 0.4 + 0.5 + 0.1 * kPi / 4,
              1e-4);
  std::vector<double> ends;
  for (const Isoline& line : lines) {
    for (const Point& end : {line.positions.front(), line.positions.back()}) {
      ends.push_back(end[0]);
    }
  }
  std::ranges::sort(ends);
  const std::vector<double> expected = {0.4, 0.4, at, 0.6};
  for (size_t i = 0; i < 4; ++i) EXPECT_NEAR(ends[i], expected[i], 1e-12);
}

TEST(IsolineArcs, RunAlongACurveThroughTwoFaces) {
  const auto lines = Draw(Square(), {{{{0.3, 0}, {0.3, 1}}}}, 0.1, {.open = 2});
  for (const Isoline& line : lines) {
    const double x = line.positions.front()[0] < 0.3 ? 0.2 : 0.4;
    for (const Point& p : line.positions) EXPECT_NEAR(p[0], x, 1e-12);
    EXPECT_NEAR(Length(line), 1, 1e-12);
  }
}

TEST(IsolineArcs, AreCirclesAroundPointsOfEdgesAndFaces) {
  const auto cube = BuildOrFail({"cube", Cube()});
  const auto& [from, beside, to] = cube->triangle(0);  // half of a side
  for (const SurfacePoint& source :
       {SurfacePoint{EdgePoint{from, to, 0.5}},
        SurfacePoint{FacePoint{2, {0.3, 0.4, 0.3}}}}) {
    const auto lines =
        IsolinesOrFail(*cube, Query{.sources = {{source}}}, {0.5});
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_TRUE(lines[0].is_closed);
    // A thousandth of the radius off, a polygon's perimeter lacks two thirds of
    // that part.
    EXPECT_LT(Length(lines[0]), kPi);
    EXPECT_GT(Length(lines[0]), kPi * (1 - 0.7e-3));
  }
}

// From (1, 1) both legs are 1 away, the corner between them and the third side
// sqrt(2), the others sqrt(10).
TEST(IsolineArcs, AroundAPointInAFace) {
  const Drawing point = {{{{1, 1}}}};
  for (const double level : {1e-6, 1e-3, 0.5, 0.999999, 1.0}) {
    const auto lines = Draw(LargeTriangle(), point, level, {.closed = 1});
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_NEAR(Length(lines[0]), 2 * kPi * level, 6e-3 * level);
  }
  for (const double level : {1.000001, 1.2, 1.414213, 1.414214, 1.5, 3.0}) {
    Draw(LargeTriangle(), point, level, {.open = 2});
  }
  Draw(LargeTriangle(), point, 3.17, {});
  // Beside an edge, and at an offset.
  Draw(LargeTriangle(), {{{{1, 1e-7}}}}, 1e-8, {.closed = 1});
  Draw(LargeTriangle(), {{{{1, 1e-7}}}}, 1e-3, {.open = 1});
  const auto offset =
      Draw(LargeTriangle(), {{{{1, 1}}, 0.75}}, 0.76, {.closed = 1});
  EXPECT_NEAR(Length(offset.at(0)), 2 * kPi * 0.01, 2e-3);
  Draw(LargeTriangle(), {{{{1, 1}}, 0.75}}, 0.74, {});
}

TEST(IsolineArcs, KeepTheChordErrorOfTheQuestion) {
  const Drawing point = {{{{1, 1}}}};
  for (const double error : {0.3, 1e-2, 1e-4, 1e-7}) {
    const auto lines = Draw(LargeTriangle(), point, 0.5, {.closed = 1}, error);
    // A chord of the angle a is r (1 - cos(a / 2)) off; as many as needed, in
    // each third.
    const double angle = 2 * std::acos(1 - error / 0.5);
    const double count = 3 * std::ceil(2 * kPi / 3 / angle);
    EXPECT_NEAR(static_cast<double>(lines.at(0).points.size()), count, 3);
  }
  EXPECT_EQ(Draw(LargeTriangle(), point, 0.5, {.closed = 1}, kInfinity)
                .at(0)
                .points.size(),
            3u);
}

// Two circles of a face become one as they meet.
TEST(IsolineArcs, MeetInsideAFace) {
  const Drawing points = {{{{0.8, 0.9}}}, {{{1.6, 0.9}}}};
  for (const double part : {0.5, 0.999, 0.999999, 1 - 1e-9}) {
    Draw(LargeTriangle(), points, 0.4 * part, {.closed = 2});
    Draw(LargeTriangle(), points, 0.4 / part, {.closed = 1});
  }
  // Of different size: they meet at the first's 0.5.
  const Drawing uneven = {{{{0.8, 0.9}}}, {{{1.6, 0.9}}, 0.2}};
  Draw(LargeTriangle(), uneven, 0.19, {.closed = 1});
  Draw(LargeTriangle(), uneven, 0.4999, {.closed = 2});
  Draw(LargeTriangle(), uneven, 0.5001, {.closed = 1});
  // A point and the parallel of a line, half way at 0.35.
  const Drawing mixed = {{{{0.2, 0}, {0.2, 3.8}}}, {{{0.9, 1}}}};
  Draw(LargeTriangle(), mixed, 0.19, {.open = 2, .closed = 1});
  Draw(LargeTriangle(), mixed, 0.3499, {.open = 1, .closed = 1});
  Draw(LargeTriangle(), mixed, 0.3501, {.open = 1});
}

TEST(IsolineArcs, AroundTheEndOfACurveAcrossAnEdge) {
  // From a corner of a square to the middle of the diagonal: two sides, and
  // half a circle beyond the diagonal, whatever rounding makes of the right
  // angle.
  for (const double side : {0.1, 0.7, 1.0, 1.1, 3.0, 17.3}) {
    TriangleSoup soup = Square();
    for (Point& point : soup.positions) {
      for (double& x : point) x *= side;
    }
    const auto mesh = Mesh::Build(soup).value();
    const Curve curve{{VertexPoint{1}, EdgePoint{0, 2, 0.5}}};
    EXPECT_NEAR(Length(IsolinesOrFail(*mesh, {.sources = {{curve}}},
                                      {0.1 * side}, 1e-6)) /
                    side,
                2 * (std::sqrt(0.5) - 0.1) + 0.1 * kPi, 1e-4)
        << side;
  }
}

TEST(IsolineArcs, ThroughAVertexAndBackThere) {
  // Vertex 3 is at 2 sqrt 2 from vertex 0.
  const auto mesh = BuildOrFail({"tetrahedron", Triangulate(Tetrahedron())});
  const Query query{
      .sources = {{FacePoint{0, {0.25, 0.5, 0.25}}}, {VertexPoint{0}}}};
  double level = std::sqrt(8.0) * (1 - 2e-15);
  for (int ulp = 0; ulp < 12; ++ulp, level = std::nextafter(level, 3.0)) {
    EXPECT_NEAR(Length(IsolinesOrFail(*mesh, query, {level})), 0.53535, 1e-3)
        << level;
  }
}

// Around the vertex of the tetrahedron, the line of this
// level runs in one face from the vertex that is farthest and back there.
TEST(IsolineArcs, AroundAFaceFromAVertexWithAnyChordError) {
  const auto mesh = BuildOrFail({"tetrahedron", Triangulate(Tetrahedron())});
  const Query query{.sources = {{FacePoint{3, {0.75, 0.05, 0.2}}}}};
  const double level = Solve(*mesh, query)->distances[0];
  ASSERT_NEAR(level, 2.68700576850888, 1e-12);
  for (const double chord_error : {kInfinity, 1.2, 1.0, 0.1, 0.0}) {
    const auto lines = IsolinesOrFail(*mesh, query, {level}, chord_error);
    ASSERT_EQ(lines.size(), 1) << chord_error;
    EXPECT_TRUE(lines[0].is_closed);
    EXPECT_GE(lines[0].positions.size(), 3);
    EXPECT_NEAR(Length(lines[0]), 4.191, chord_error == 0 ? 0.01 : 1);
  }
}

// Inside a rectangle of 1 by 0.2 the line of the level 0.1 - e is one of
// 0.8 + 2 e by 2 e: thinner than the chord error, and as long as ever.
TEST(IsolineArcs, KeepTheEndsOfThinLoops) {
  const Drawing rectangle = {
      {.corners = {
           {0.5, 0.5}, {1.5, 0.5}, {1.5, 0.7}, {0.5, 0.7}, {0.5, 0.5}}}};
  for (const double e : {1e-4, 1e-5, 1e-6}) {
    for (const double chord_error : {0.0, 1e-3}) {
      const std::vector<Isoline> lines =
          Draw(LargeTriangle(), rectangle, 0.1 - e, {.closed = 2}, chord_error);
      double shortest = kInfinity;
      for (const Isoline& line : lines) {
        shortest = std::min(shortest, Length(line));
      }
      EXPECT_NEAR(shortest, 2 * (0.8 + 2 * e), 4 * std::max(chord_error, 1e-4))
          << e;
    }
  }
}

TEST(IsolineArcs, TouchInAPoint) {
  // Two quarters of circles that touch in the middle of a side.
  const auto mesh = Mesh::Build(Square()).value();
  for (const double level : {0.5, 0.5 + 1e-14, 0.5 - 1e-14, 0.5 - 1e-13}) {
    EXPECT_NEAR(Length(IsolinesOrFail(
                    *mesh, {.sources = {{VertexPoint{0}}, {VertexPoint{1}}}},
                    {level}, 1e-6)),
                kPi / 2, 1e-4)
        << level;
  }
  // Around a square tube of side 1 and height 3 a circle of radius 2 touches
  // itself behind its center, which is in the middle of a slanted edge: in the
  // plane, what lies within 2 to either side.
  const std::vector<Point> positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0},
                                        {0, 1, 0}, {0, 0, 3}, {1, 0, 3},
                                        {1, 1, 3}, {0, 1, 3}};
  const std::vector<Triangle> faces = {{0, 1, 5}, {0, 5, 4}, {1, 2, 6},
                                       {1, 6, 5}, {2, 3, 7}, {2, 7, 6},
                                       {3, 0, 4}, {3, 4, 7}};
  const auto tube = Mesh::Build({positions, faces}).value();
  EXPECT_NEAR(Length(IsolinesOrFail(
                  *tube, {.sources = {{EdgePoint{0, 5, 0.5}}}}, {2}, 1e-6)),
              8 * std::asin(0.75), 1e-4);
}

TEST(IsolineArcs, TouchInAPointOfAGrid) {
  Random random(1);
  for (int i = 0; i < 120; ++i) {
    const auto mesh =
        Mesh::Build(MakeGrid({.jitter = i % 2 == 0 ? 0 : 0.2})).value();
    const auto a = static_cast<uint32_t>(random.Below(81));
    const auto b = static_cast<uint32_t>(random.Below(81));
    if (a == b) continue;
    const Query query{.sources = {{VertexPoint{a}}, {VertexPoint{b}}}};
    const double level =
        Distance(mesh->positions()[a], mesh->positions()[b]) / 2;
    // The lines of a level that is a little lower touch nowhere.
    EXPECT_NEAR(
        Length(IsolinesOrFail(*mesh, query, {level}, 1e-6)),
        Length(IsolinesOrFail(*mesh, query, {level * (1 - 1e-7)}, 1e-6)), 1e-4)
        << a << ' ' << b;
  }
}

// A triangle of sides 3, 4 and 5, halved: its inscribed circle has the
// radius 1/2.
TEST(IsolineArcs, OnBothSidesOfAClosedCurve) {
  const Drawing ring = {{{{0.4, 0.4}, {1.9, 0.4}, {0.4, 2.4}, {0.4, 0.4}}}};
  for (const double level : {1e-7, 1e-3, 0.2, 0.39}) {
    const auto lines = Draw(LargeTriangle(), ring, level, {.closed = 2});
    ASSERT_EQ(lines.size(), 2u);
    EXPECT_NEAR(Length(lines[0]) + Length(lines[1]),
                6 + 2 * kPi * level + 6 * (1 - level / 0.5), 0.01 * level);
  }
  // The legs of the mesh are 0.4 away, the corner between them 0.57.
  Draw(LargeTriangle(), ring, 0.47, {.open = 2, .closed = 1});
  Draw(LargeTriangle(), ring, 0.499999, {.open = 2, .closed = 1});
  Draw(LargeTriangle(), ring, 0.500001, {.open = 2});
  Draw(LargeTriangle(), ring, 0.6, {.open = 1});
}

// Three corners of an equilateral triangle of side 2: their circles meet on the
// sides at 1, and in the middle at 2 / sqrt(3).
TEST(IsolineArcs, AroundWhatIsFarthestInAFace) {
  const TriangleSoup triangle = {{{0, 0, 0}, {2, 0, 0}, {1, std::sqrt(3.0), 0}},
                                 {{0, 1, 2}}};
  const Drawing corners = {{{{0, 0}}}, {{{2, 0}}}, {{{1, std::sqrt(3.0)}}}};
  Draw(triangle, corners, 0.999, {.open = 3});
  for (const double level : {1.001, 1.1, 1.154, 1.1547}) {
    const auto lines = Draw(triangle, corners, level, {.closed = 1});
    ASSERT_EQ(lines.size(), 1u);
    // What is nearer, around it, is on the left: it runs clockwise.
    double area = 0;
    const std::vector<Point>& p = lines[0].positions;
    for (size_t i = 0; i < p.size(); ++i) {
      const Point& next = p[(i + 1) % p.size()];
      area += (p[i][0] * next[1] - next[0] * p[i][1]) / 2;
    }
    EXPECT_LT(area, 0);
  }
  Draw(triangle, corners, 1.1548, {});
}

std::vector<TriangleSoup> JitteredGrids() {
  std::vector<TriangleSoup> grids;
  for (uint64_t seed = 1; seed <= 60; ++seed) {
    grids.push_back(MakeGrid({.columns = 7,
                              .rows = 6,
                              .diagonals = Diagonals::kRandom,
                              .jitter = 0.23,
                              .seed = seed}));
  }
  return grids;
}

TEST(IsolineArcs, NeverCrossACurveAcrossAGrid) {
  const std::vector<double> levels = {1e-8, 1e-5, 1e-3, 0.01, 0.04, 0.1, 0.3};
  for (const TriangleSoup& grid : JitteredGrids()) {
    for (const std::array<double, 4>& ends :
         {std::array{2.6, 0.0, 4.3, 6.0}, std::array{0.0, 2.3, 7.0, 2.9},
          std::array{3.0, 0.0, 3.0, 6.0}}) {
      const double x = ends[0];
      const double y = ends[1];
      const double to_x = ends[2];
      const double to_y = ends[3];
      for (const double level : levels) {
        for (const Isoline& line :
             Draw(grid, {{{{x, y}, {to_x, to_y}}}}, level, {.open = 2})) {
          const auto side = [&](const Point& p) {
            return (to_x - x) * (p[1] - y) - (to_y - y) * (p[0] - x) > 0;
          };
          for (const Point& p : line.positions) {
            EXPECT_EQ(side(p), side(line.positions.front()));
          }
        }
      }
    }
  }
}

TEST(IsolineArcs, GoRoundACurveInsideAGrid) {
  const Drawing bent = {{{{2.2, 2.1}, {3.4, 3.9}, {4.7, 2.6}}}};
  const Drawing two = {bent[0], {{{2.1, 4.9}, {5.5, 5.2}}, 0}};
  // Legs 0.6 and 0.8: the inscribed circle has the radius 0.2.
  const Drawing ring = {{{{2.3, 2.3}, {2.9, 2.3}, {2.3, 3.1}, {2.3, 2.3}}}};
  for (const TriangleSoup& grid : JitteredGrids()) {
    for (const double level : {1e-7, 1e-4, 0.01, 0.07, 0.3}) {
      Draw(grid, bent, level, {.closed = 1});
      Draw(grid, two, level, {.closed = 2});
    }
    for (const double level : {1e-6, 0.01, 0.1, 0.199}) {
      Draw(grid, ring, level, {.closed = 2});
    }
    Draw(grid, ring, 0.201, {.closed = 1});
  }
}

// Crossings of edges are those that are there without points in between.
TEST(IsolineArcs, LeaveCrossingsOfEdgesAsTheyAre) {
  const auto mesh = BuildOrFail({"terrain", Terrain(8, 8, 0.8, 2)});
  const Query query{.sources = {{VertexPoint{40}}}};
  const std::vector<double> levels = {0.3, 1.7, 3.1};
  const auto bare = IsolinesOrFail(*mesh, query, levels, kInfinity);
  auto lines = IsolinesOrFail(*mesh, query, levels);
  ASSERT_EQ(bare.size(), lines.size());
  for (size_t i = 0; i < bare.size(); ++i) {
    const size_t count = lines[i].points.size();
    std::erase_if(lines[i].points, [](const SurfacePoint& point) {
      return std::holds_alternative<FacePoint>(point);
    });
    EXPECT_LT(lines[i].points.size(), count);
    EXPECT_EQ(lines[i].points, bare[i].points);
  }
}

// On a page of a book, in a face beside the spine, at which lines end.
TEST(IsolineArcs, EndWhereThreeFacesMeet) {
  const NamedMesh book{"book", Book(MakeGrid({.columns = 4, .rows = 5}), 3)};
  Random random(5);
  for (int i = 0; i < 12; ++i) {
    const Query query{.sources = {{RandomFacePoint(book.soup, random)},
                                  {RandomEdgePoint(book.soup, random), 0.2}}};
    ExpectIsolines(book, query, {0.02, 0.1, 0.21, 0.4, 0.9, 1.7}, 100, 1e-14);
  }
}

// Points, and curves that turn, on surfaces of all kinds.
TEST(IsolineArcs, KeepTheLawsFromSourcesAnywhere) {
  Random random(3);
  for (const NamedMesh& named : std::vector<NamedMesh>{
           {"terrain", Terrain(6, 5, 0.9, 4)},
           {"torus", Torus({.around = 9, .across = 6, .noise = 0.1})},
           {"cube", Cube()},
           {"icosahedron", Icosphere(0)}}) {
    for (int i = 0; i < 8; ++i) {
      Query query{.sources = {{RandomSurfacePoint(named.soup, random), 0.05},
                              {Curve{RandomCurve(named.soup, 5, random)}}}};
      ExpectIsolines(named, query, {0.003, 0.06, 0.2, 0.5, 0.8}, 60, 1e-13);
    }
  }
}

TEST(IsolineArcs, HaveLimits) {
  const auto mesh = BuildOrFail({"triangle", LargeTriangle()});
  const Query query{.sources = {{FacePoint{0, {0.5, 0.25, 0.25}}}}};
  const auto draw = [&](double chord_error, Checkpoint& checkpoint) {
    return ComputeIsolines(*mesh, Valid(*mesh, query), {{0.5}, chord_error}, {},
                           checkpoint)
        .status();
  };
  NoCheckpoint never;
  EXPECT_EQ(draw(-1, never).message(), "chord_error is -1; it must be >= 0");
  EXPECT_EQ(draw(NAN, never).code(), absl::StatusCode::kInvalidArgument);
  EXPECT_EQ(draw(1e-300, never).message(),
            "chord_error asks for more than 10000000 points inside faces: name "
            "a larger one, or fewer levels");
  // 4.4 million points of one circle come with some hundred polls; memory that
  // they take is told.
  RecordingCheckpoint polls;
  EXPECT_TRUE(draw(2.5e-13, polls).ok());
  EXPECT_GT(polls.polls().size(), 500u);
  EXPECT_GT(polls.polls().back().solver_bytes, 100'000'000u);
  RecordingCheckpoint stops(300);
  EXPECT_EQ(draw(2.5e-13, stops), RecordingCheckpoint::Stopped());
  EXPECT_EQ(stops.polls().size(), 301u);
}

}  // namespace
}  // namespace geodesic::test
