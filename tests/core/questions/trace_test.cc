// Straightest lines against closed forms, and their laws.

#include "geodesic/trace.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "geodesic/log_map.h"
#include "geodesic/solve.h"
#include "geodesic_types/field_path.h"
#include "tests/support/meshes/curved_meshes.h"
#include "tests/support/meshes/developable_meshes.h"
#include "tests/support/meshes/planar_meshes.h"
#include "tests/support/meshes/polyhedra.h"
#include "tests/support/queries.h"
#include "tests/support/vec.h"

namespace geodesic::test {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kNoEnd = std::numeric_limits<double>::infinity();

std::shared_ptr<const Mesh> Build(TriangleSoup soup) {
  return Mesh::Build(std::move(soup)).value();
}

struct Start {
  SurfacePoint place;
  LineDirection direction = 0.0;
};

absl::StatusOr<TracedLine> Trace(const Mesh& mesh, const Start& start,
                                 double length) {
  const absl::StatusOr<LineTracer> tracer = LineTracer::From(mesh, start.place);
  if (!tracer.ok()) return tracer.status();
  NoCheckpoint checkpoint;
  return tracer->Trace(start.direction, length, checkpoint);
}

TracedLine Line(const Mesh& mesh, const Start& start, double length) {
  return Trace(mesh, start, length).value();
}

void ExpectAt(const Point& found, const Point& expected, double tolerance) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(found[i], expected[i], tolerance);
}

// The pieces add up to the length.
void ExpectWhole(const TracedLine& line) {
  ASSERT_EQ(line.points.size(), line.positions.size());
  double length = 0;
  for (size_t i = 1; i < line.positions.size(); ++i) {
    length +=
        static_cast<double>(Distance(line.positions[i - 1], line.positions[i]));
  }
  EXPECT_NEAR(length, line.length, 1e-12 * (1 + line.length));
}

Point Way(const Point& from, const Point& to) {
  return {to[0] - from[0], to[1] - from[1], to[2] - from[2]};
}

// That lines in all directions from there are straight in the plane.
void ExpectStraight(const Mesh& mesh, const SurfacePoint& place) {
  const Point from = PositionOf(place, mesh);
  for (int degrees = 0; degrees < 360; degrees += 15) {
    const double angle = degrees * kPi / 180;
    const Point way = {3 * std::cos(angle), 3 * std::sin(angle), 0};
    const TracedLine line = Line(mesh, {place, way}, 2.5);
    ExpectWhole(line);
    EXPECT_EQ(line.end, TraceEnd::kLength);
    ExpectAt(line.positions.front(), from, 1e-15);
    ExpectAt(
        line.positions.back(),
        {from[0] + 2.5 * std::cos(angle), from[1] + 2.5 * std::sin(angle), 0},
        1e-12);
  }
}

TEST(TraceTest, IsAStraightLineInAPlane) {
  for (const double jitter : {0.0, 0.2}) {
    const TriangleSoup grid =
        MakeGrid({.columns = 12, .rows = 12, .jitter = jitter});
    const auto mesh = Build(grid);
    // In the middle.
    for (const SurfacePoint& place :
         {SurfacePoint(VertexPoint{84}),
          SurfacePoint(
              EdgePoint{grid.triangles[132][0], grid.triangles[132][1], 0.3}),
          SurfacePoint(FacePoint{132, {0.2, 0.3, 0.5}})}) {
      ExpectStraight(*mesh, place);
    }
  }
}

TEST(TraceTest, EndsAtTheBoundary) {
  const auto mesh = Build(MakeGrid({.columns = 12, .rows = 9}));
  const TracedLine line =
      Line(*mesh, {FacePoint{90, {0.2, 0.3, 0.5}}, Point{1, 0.01, 0}}, kNoEnd);
  ExpectWhole(line);
  EXPECT_EQ(line.end, TraceEnd::kBoundary);
  EXPECT_EQ(TraceEndName(line.end), "boundary");
  EXPECT_EQ(line.positions.back()[0], 12);
  // Along the boundary up to where it turns.
  const TracedLine along = Line(*mesh, {VertexPoint{0}, Point{1, 0, 0}}, 5);
  EXPECT_EQ(along.end, TraceEnd::kBoundary);
  EXPECT_EQ(along.length, 1);
}

// Three right angles lie around a cube's corner: half of them on each side.
TEST(TraceTest, PassesAVertexWithEqualAngles) {
  const auto mesh = Build(Triangulate(Box(1, 1, 1)));
  const Polyhedron box = Box(1, 1, 1);
  const auto vertex_at = [&](const Point& p) {
    return static_cast<uint32_t>(std::ranges::find(box.vertices, p) -
                                 box.vertices.begin());
  };
  // Along the edge to (1, 0, 0); then 3 pi / 4 from it, into the middle of the
  // face x = 1, along its diagonal.
  const TracedLine line =
      Line(*mesh, {VertexPoint{vertex_at({0, 0, 0})}, Point{1, 0, 0}},
           1 + std::sqrt(2.0) / 2);
  ExpectWhole(line);
  ExpectAt(line.positions.back(), {1, 0.5, 0.5}, 1e-12);
}

// On a cone, in a plane and on a saddle.
TEST(TraceTest, GoesOnAcrossTheApexOfAFan) {
  for (const double total : {4.0, 2 * kPi, 9.0}) {
    const Fan fan({.spokes = 10, .rings = 2, .total_angle = total});
    const auto mesh = Build(fan.soup());
    // Spokes 0 and 5 are opposite: the line from one's first vertex to the apex
    // goes on along the other.
    const TracedLine line = Line(
        *mesh,
        {VertexPoint{1}, Way(fan.soup().positions[1], fan.soup().positions[0])},
        2 * static_cast<double>(
                Distance(fan.soup().positions[1], fan.soup().positions[0])));
    ExpectWhole(line);
    ExpectAt(line.positions.back(), fan.soup().positions[6], 1e-11);
  }
}

TEST(TraceTest, ComesBackWhenReversed) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> turn(0, 2 * kPi);
  for (const TriangleSoup& soup :
       {Icosphere(2), Torus({.noise = 0.05}), Triangulate(Icosahedron())}) {
    const auto mesh = Build(soup);
    for (uint32_t face = 0; face < 20; ++face) {
      const SurfacePoint place = FacePoint{face, {0.5, 0.3, 0.2}};
      const TracedLine there = Line(*mesh, {place, turn(random)}, 5);
      ExpectWhole(there);
      ASSERT_GE(there.positions.size(), 2);
      const size_t last = there.positions.size() - 1;
      const TracedLine back =
          Line(*mesh,
               {there.points[last],
                Way(there.positions[last], there.positions[last - 1])},
               5);
      ExpectAt(back.positions.back(), there.positions.front(), 1e-9);
    }
  }
}

// On a convex surface shortest paths avoid vertices, and so are straight lines
// from the source.
TEST(TraceTest, InvertsTheLogMap) {
  for (const TriangleSoup& soup : {Icosphere(2), Triangulate(Icosahedron())}) {
    const auto mesh = Build(soup);
    for (const SurfacePoint& place :
         {SurfacePoint(VertexPoint{3}),
          SurfacePoint(FacePoint{7, {0.5, 0.2, 0.3}}),
          Canonicalize(
              EdgePoint{soup.triangles[9][0], soup.triangles[9][1], 0.4},
              *mesh)}) {
      const Query query = {.sources = {{place}}, .trace = true};
      const DistanceField field = Solve(*mesh, query).value();
      const LogMap map =
          ComputeLogMap(*mesh, Valid(*mesh, query), field).value();
      for (uint32_t v = 0; v < mesh->vertex_count(); ++v) {
        const auto& [x, y] = map.coordinates[v];
        const TracedLine line =
            Line(*mesh, {place, std::atan2(y, x)}, field.distances[v]);
        ExpectAt(line.positions.back(), mesh->positions()[v], 1e-10);
      }
    }
  }
}

// Where all vertices are saddles nothing is shorter than a straight line.
TEST(TraceTest, IsAsLongAsTheDistanceAmongSaddles) {
  const auto mesh = Build(HyperbolicGrid(16, 16, 0.1));
  const SurfacePoint place = FacePoint{260, {0.2, 0.3, 0.5}};
  for (int degrees = 0; degrees < 360; degrees += 7) {
    const TracedLine line = Line(*mesh, {place, degrees * kPi / 180}, 6);
    const DistanceField field =
        Solve(*mesh, {.sources = {{place}}, .targets = {line.points.back()}})
            .value();
    EXPECT_NEAR(field.target_distances[0], line.length, 1e-11) << degrees;
  }
}

// Every third face the other way round.
TEST(TraceTest, CrossesEdgesWhereFacesDisagreeInOrientation) {
  TriangleSoup grid = MakeGrid({.columns = 12, .rows = 12, .jitter = 0.2});
  for (size_t face = 0; face < grid.triangles.size(); face += 3) {
    std::swap(grid.triangles[face][0], grid.triangles[face][1]);
  }
  ExpectStraight(*Build(grid), FacePoint{132, {0.2, 0.3, 0.5}});
}

TEST(TraceTest, EndsWhereThereIsNoStraightOn) {
  // Three faces at an edge.
  TriangleSoup book{.positions = {{0, 0, 0},
                                  {0, 1, 0},
                                  {-1, 0.5, 0},
                                  {1, 0.5, 0.2},
                                  {1, 0.5, -0.2}},
                    .triangles = {{0, 1, 2}, {1, 0, 3}, {1, 0, 4}}};
  const auto mesh = Build(book);
  const TracedLine line =
      Line(*mesh, {FacePoint{0, {0.4, 0.3, 0.3}}, Point{1, 0.1, 0}}, kNoEnd);
  EXPECT_EQ(line.end, TraceEnd::kSingular);
  EXPECT_EQ(line.positions.back()[0], 0);
}

TEST(TraceTest, RefusesWhatHasNoMeaning) {
  const auto grid = Build(MakeGrid({.columns = 4, .rows = 4}));
  const auto field_of = [&](const Start& start, double length) {
    const absl::Status status = Trace(*grid, start, length).status();
    EXPECT_TRUE(absl::IsInvalidArgument(status)) << status;
    return FieldPathOf(status).value_or("");
  };
  EXPECT_EQ(field_of({VertexPoint{99}}, 1), "source.vertex");
  EXPECT_EQ(field_of({VertexPoint{6}}, -1), "length");
  EXPECT_EQ(field_of({VertexPoint{6}}, std::nan("")), "length");
  EXPECT_EQ(field_of({VertexPoint{6}, std::nan("")}, 1), "direction");
  EXPECT_EQ(field_of({VertexPoint{6}, Point{0, 0, 1}}, 1), "direction");
  EXPECT_EQ(field_of({VertexPoint{6}, Point{0, 0, 0}}, 1), "direction");
  EXPECT_EQ(field_of({VertexPoint{0}, kPi}, 1), "direction");
  EXPECT_EQ(field_of({VertexPoint{0}, Point{-1, -1, 0}}, 1), "direction");
}

}  // namespace
}  // namespace geodesic::test
