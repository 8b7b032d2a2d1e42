#include "geodesic/join_seams.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "absl/strings/str_cat.h"
#include "geodesic/isolines.h"
#include "geodesic/mesh.h"
#include "geodesic/mesh_summary.h"
#include "geodesic/path.h"
#include "geodesic/read_mesh.h"
#include "geodesic/solve.h"
#include "geodesic/surface_point.h"
#include "geodesic/valid_query.h"
#include "geodesic_types/algorithms.h"
#include "tests/support/checkpoints.h"
#include "tests/support/meshes/planar_meshes.h"
#include "tests/support/meshes/polyhedra.h"

namespace geodesic {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Of side 2.
TriangleSoup Cube() { return test::Triangulate(test::Box(2, 2, 2)); }

TriangleSoup Joined(TriangleSoup soup, const Welding& welding = {}) {
  const absl::Status status = JoinSeams(welding, soup);
  EXPECT_TRUE(status.ok()) << status;
  return soup;
}

// Every corner a vertex of its own, as in an STL file.
TriangleSoup TakenApart(const TriangleSoup& soup) {
  TriangleSoup apart;
  for (const Triangle& corners : soup.triangles) {
    const auto next = static_cast<uint32_t>(apart.positions.size());
    for (const uint32_t v : corners)
      apart.positions.push_back(soup.positions[v]);
    apart.triangles.push_back({next, next + 1, next + 2});
  }
  return apart;
}

MeshSummary SummaryOf(TriangleSoup soup) {
  const auto mesh = Mesh::Build(std::move(soup));
  EXPECT_TRUE(mesh.ok()) << mesh.status();
  return Summarize(**mesh);
}

TEST(JoinSeamsTest, ASquareInTwoPieces) {
  // Vertices 3 and 4 repeat 1 and 2.
  const TriangleSoup soup = Joined(
      {.positions =
           {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}},
       .triangles = {{0, 1, 2}, {4, 3, 5}}});
  EXPECT_THAT(soup.reading.joined,
              ElementsAre(JoinedVertex{3, 1}, JoinedVertex{4, 2}));
  const auto mesh = Mesh::Build(soup).value();
  EXPECT_EQ(mesh->triangle(1), (Triangle{2, 1, 5}));
  EXPECT_EQ(mesh->NamedTriangle(1), (Triangle{4, 3, 5}));
  EXPECT_EQ(soup.reading.seam_edges, 1u);
  EXPECT_THAT(soup.positions, SizeIs(6));
}

TEST(JoinSeamsTest, ACubeInTwelvePiecesIsClosed) {
  const TriangleSoup soup = Joined(TakenApart(Cube()));
  // Twelve edges of the cube, and a diagonal on each of its sides.
  EXPECT_EQ(soup.reading.seam_edges, 18u);
  const MeshSummary summary = SummaryOf(soup);
  EXPECT_EQ(summary.boundary_edges, 0u);
  EXPECT_EQ(summary.genus, 0);
  EXPECT_EQ(summary.joined_vertices, 36u - 8u);
  EXPECT_EQ(summary.isolated_vertices, 0u);
  EXPECT_THAT(Notes(summary), ElementsAre("joined 18 seam edges"));
}

TEST(JoinSeamsTest, MoreThanRoundingIsToldAndNotJoined) {
  // Two squares of side 1 with a gap of 0.001.
  const std::vector<Point> squares = {{0, 0, 0}, {1, 0, 0},     {1, 1, 0},
                                      {0, 1, 0}, {1.001, 0, 0}, {2, 0, 0},
                                      {2, 1, 0}, {1.001, 1, 0}};
  const TriangleSoup apart = {
      .positions = squares,
      .triangles = {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}}};
  EXPECT_THAT(Joined(apart).reading.joined, IsEmpty());
  const MeshSummary summary = SummaryOf(apart);
  EXPECT_EQ(summary.close_edges, 2u);
  EXPECT_NEAR(summary.close_edge_distance, 0.001, 1e-12);
  EXPECT_THAT(Notes(summary),
              ElementsAre("2 boundary edges lie within 0.001 of others and are "
                          "not joined; --weld 0.001 (weld) joins them"));
  const Welding within = {Welding::Kind::kWithin, 0.001000001};
  const TriangleSoup joined = Joined(apart, within);
  EXPECT_THAT(joined.reading.joined,
              ElementsAre(JoinedVertex{4, 1}, JoinedVertex{7, 2}));
  EXPECT_THAT(Notes(SummaryOf(joined)), ElementsAre("joined 1 seam edge"));
  EXPECT_THAT(Joined(apart, {Welding::Kind::kWithin, 0.0009}).reading.joined,
              IsEmpty());
}

TEST(JoinSeamsTest, NothingIsJoinedIfNotWanted) {
  const TriangleSoup apart = TakenApart(Cube());
  EXPECT_TRUE(Joined(apart, {.kind = Welding::Kind::kNone}).reading.is_plain());
}

TEST(JoinSeamsTest, WhatTouchesInAPointOrCrossesStaysApart) {
  // Two triangles that touch in a point, and one that crosses the first.
  const std::vector<Point> positions = {
      {0, 0, 0},  {1, 0, 0},      {0, 1, 0},     {0, 0, 0},    {-1, 0, 0},
      {0, -1, 0}, {0.2, 0.2, -1}, {0.2, 0.2, 1}, {0.3, 0.1, 0}};
  const TriangleSoup soup = Joined(
      {.positions = positions, .triangles = {{0, 1, 2}, {3, 4, 5}, {6, 7, 8}}});
  EXPECT_TRUE(soup.reading.is_plain());
}

TEST(JoinSeamsTest, AnyNumberOfSheetsMeetsInASeam) {
  // Three triangles over the edge from (0, 0, 0) to (0, 0, 1), one of them
  // turned the other way.
  const std::vector<Point> positions = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0},
                                        {0, 0, 0}, {0, 0, 1}, {0, 1, 0},
                                        {0, 0, 1}, {0, 0, 0}, {-1, 0, 0}};
  const TriangleSoup soup = Joined(
      {.positions = positions, .triangles = {{0, 1, 2}, {3, 4, 5}, {6, 7, 8}}});
  EXPECT_EQ(soup.reading.seam_edges, 1u);
  EXPECT_EQ(SummaryOf(soup).non_manifold_edges, 1u);
}

// Two sheets that lie on each other, turned away from each other, as programs
// write leaves: they meet at the rim alone, also where an edge inside each of
// them leads from rim to rim.
TEST(JoinSeamsTest, TwoSidedSheetsMeetAtTheRim) {
  // A unit square, each side cut along the same diagonal.
  const std::vector<Point> twice = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                    {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const TriangleSoup leaf =
      Joined({.positions = twice,
              .triangles = {{0, 1, 2}, {0, 2, 3}, {6, 5, 4}, {7, 6, 4}}});
  const MeshSummary summary = SummaryOf(leaf);
  EXPECT_EQ(summary.seam_edges, 4u);
  EXPECT_EQ(summary.edges, 6u);
  EXPECT_EQ(summary.boundary_edges, 0u);
  EXPECT_EQ(summary.non_manifold_edges, 0u);
  EXPECT_EQ(summary.genus, 0);
  const auto mesh = Mesh::Build(leaf).value();
  // From (0.65, 0.4) to the same place behind: over the rim, 0.35 away. The
  // diagonal is nearer.
  for (const AlgorithmInfo& info : kAlgorithms) {
    const auto field =
        Solve(*mesh, {.sources = {{FacePoint{0, {0.35, 0.25, 0.4}}}},
                      .targets = {FacePoint{2, {0.4, 0.25, 0.35}}},
                      .algorithm = info.algorithm})
            .value();
    EXPECT_NEAR(field.target_distances[0], 0.7, 1e-14) << info.name;
  }
}

// A sheet with a bump on a flat one, both cut along one diagonal: faces of the
// same corners are not the same, whichever comes first and however they turn.
TEST(JoinSeamsTest, SheetsOfTheSameCornersAreTwo) {
  const std::vector<Point> sheets = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0},
                                     {0, 1, 0}, {0, 0, 0}, {1, 0, 0},
                                     {1, 1, 0}, {0, 1, 0}, {0.3, 0.3, 0.2}};
  const TriangleSoup soup = {
      .positions = sheets,
      .triangles = {
          {0, 1, 3}, {1, 2, 3}, {4, 5, 8}, {5, 7, 8}, {7, 4, 8}, {5, 6, 7}}};
  // Straight over the middle of the upper diagonal, and in the plane.
  const double over = std::sqrt(0.5) + std::sqrt(0.12);
  for (int first = 0; first < 6; ++first) {
    for (const bool is_turned : {false, true}) {
      TriangleSoup other = soup;
      if (is_turned) {
        for (int face = 2; face < 6; ++face) {
          std::swap(other.triangles[face][0], other.triangles[face][1]);
        }
      }
      std::rotate(other.triangles.begin(), other.triangles.begin() + first,
                  other.triangles.end());
      const auto mesh = Mesh::Build(Joined(std::move(other))).value();
      for (const AlgorithmInfo& info : kAlgorithms) {
        const auto field = Solve(*mesh, {.sources = {{VertexPoint{2}}},
                                         .algorithm = info.algorithm})
                               .value();
        EXPECT_NEAR(field.distances[8], over, 1e-14) << info.name;
        EXPECT_NEAR(field.distances[0], std::numbers::sqrt2, 1e-14);
      }
    }
  }
}

// Faces of the same corners at the corners of two such squares: a path goes
// from one into the other, and on over its diagonal.
TEST(JoinSeamsTest, PathsGoOnBehindFacesOfTheSameCorners) {
  const std::vector<Point> square = {
      {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  TriangleSoup soup = {
      .positions = square,
      .triangles = {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}}};
  soup.positions.insert(soup.positions.end(), square.begin(), square.end());
  const auto mesh = Mesh::Build(Joined(std::move(soup))).value();
  // From (0.8, 0.2) behind to (1, 1), (0, 1), all straight in the plane.
  for (const AlgorithmInfo& info : kAlgorithms) {
    const auto field =
        Solve(*mesh, {.sources = {{FacePoint{2, {0.2, 0.6, 0.2}}}},
                      .targets = {FacePoint{3, {0.2, 0.2, 0.6}},
                                  FacePoint{0, {0.2, 0.6, 0.2}},
                                  FacePoint{1, {0.2, 0.2, 0.6}}},
                      .algorithm = info.algorithm})
            .value();
    EXPECT_NEAR(field.distances[3], std::hypot(0.8, 0.8), 1e-14) << info.name;
    EXPECT_NEAR(field.target_distances[0], std::hypot(0.6, 0.6), 1e-14);
    // In front: over the rim, 0.2 away; the other half 0.2 from (0, 1).
    EXPECT_NEAR(field.target_distances[1], 0.4, 1e-14) << info.name;
    // Unfolded over the side below, or the one to the right.
    EXPECT_NEAR(field.target_distances[2], std::hypot(0.6, 1.0), 1e-14);
  }
}

// The same of many faces: from behind, everything is as far as by the rim.
void ExpectGridsMeetAtTheRim(bool is_turned) {
  constexpr uint32_t kSide = 5;
  TriangleSoup soup = test::MakeGrid({.columns = kSide - 1, .rows = kSide - 1});
  const auto count = static_cast<uint32_t>(soup.positions.size());
  ASSERT_EQ(count, kSide * kSide);
  const std::vector<Point> front = soup.positions;
  const std::vector<Triangle> triangles = soup.triangles;
  soup.positions.insert(soup.positions.end(), front.begin(), front.end());
  for (const auto& [a, b, c] : triangles) {
    soup.triangles.push_back(is_turned
                                 ? Triangle{c + count, b + count, a + count}
                                 : Triangle{a + count, b + count, c + count});
  }
  const auto mesh = Mesh::Build(Joined(std::move(soup))).value();
  EXPECT_EQ(Summarize(*mesh).non_manifold_edges, 0u);
  for (uint32_t source = 0; source < count; ++source) {
    const auto field =
        Solve(*mesh, {.sources = {{VertexPoint{source}}}}).value();
    for (uint32_t v = 0; v < count; ++v) {
      // Unfolded over one of the sides.
      const Point& from = front[source];
      const Point& to = front[v];
      double expected = kInfinity;
      for (int axis = 0; axis < 2; ++axis) {
        const double high = std::ranges::max_element(front, {}, [&](auto& p) {
                              return p[axis];
                            })->at(axis);
        const double along = to[1 - axis] - from[1 - axis];
        expected =
            std::min({expected, std::hypot(from[axis] + to[axis], along),
                      std::hypot(2 * high - from[axis] - to[axis], along)});
      }
      EXPECT_NEAR(field.distances[count + v], expected, 1e-13)
          << source << " to behind " << v;
    }
  }
}

TEST(JoinSeamsTest, TwoSidedGridsMeetAtTheRim) {
  ExpectGridsMeetAtTheRim(true);
  ExpectGridsMeetAtTheRim(false);
}

// A triangle without extent at a corner of a square in two pieces.
TEST(JoinSeamsTest, AFaceWithoutExtentIsPartOfItsPlace) {
  const std::vector<Point> positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0},
                                        {0, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                        {1, 1, 0}, {1, 1, 0}, {1, 1, 0}};
  const TriangleSoup soup = Joined(
      {.positions = positions, .triangles = {{0, 1, 2}, {3, 4, 5}, {6, 7, 8}}});
  const auto mesh = Mesh::Build(soup).value();
  EXPECT_THAT(
      Notes(Summarize(*mesh)),
      ElementsAre("joined 1 seam edge",
                  "left out 1 triangle, where a vertex is named twice"));
  const auto field = Solve(*mesh, {.sources = {{VertexPoint{0}}}}).value();
  for (const uint32_t v : {2, 4, 6, 7, 8}) {
    EXPECT_NEAR(field.distances[v], std::numbers::sqrt2, 1e-15) << v;
  }
}

TEST(JoinSeamsTest, SidesWithoutLengthJoinNoPieces) {
  // Two triangles that touch in a point, written as quadrilaterals.
  const std::vector<Point> positions = {{0, 0, 0},   {0, 0, 0}, {1, 1, 0},
                                        {1, -1, 0},  {0, 0, 0}, {0, 0, 0},
                                        {-1, -1, 0}, {-1, 1, 0}};
  const TriangleSoup soup =
      Joined({.positions = positions,
              .triangles = {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}}});
  EXPECT_THAT(soup.reading.joined,
              ElementsAre(JoinedVertex{1, 0}, JoinedVertex{5, 4}));
  EXPECT_EQ(SummaryOf(soup).components, 2u);
}

TEST(JoinSeamsTest, SidesWithoutLengthAreNotTold) {
  // Two triangles in one point.
  EXPECT_EQ(SummaryOf({.positions = std::vector<Point>(6, Point{1, 2, 3}),
                       .triangles = {{0, 1, 2}, {3, 4, 5}}})
                .close_edges,
            0u);
}

TEST(JoinSeamsTest, SidesOfOnePieceAreNotTold) {
  // A ribbon; its long sides are near each other, for their length.
  EXPECT_EQ(
      SummaryOf({.positions = {{0, 0, 0}, {100, 0, 0}, {100, 1, 0}, {0, 1, 0}},
                 .triangles = {{0, 1, 2}, {0, 2, 3}}})
          .close_edges,
      0u);
}

TEST(JoinSeamsTest, FacesOnEachOtherHideNoBoundary) {
  // Around 3 and 1 the numbers of neighbours add up to 0: 2 + 2 - 4 - 0.
  const TriangleSoup soup = Joined(
      {.positions = {{1, 1, 0}, {0, 0, 0}, {1, -1, 0}, {2, 0, 0}, {1, 1, 0}},
       .triangles = {{3, 2, 1}, {3, 1, 4}, {3, 2, 1}, {3, 1, 0}}});
  EXPECT_EQ(soup.reading.seam_edges, 2u);
  EXPECT_THAT(soup.reading.joined, ElementsAre(JoinedVertex{4, 0}));
}

TEST(JoinSeamsTest, AFaceKeepsItsSides) {
  // A needle whose long sides are as good as equal: no seam.
  const TriangleSoup needle = {
      .positions = {{0, 0, 0}, {1, 0, 0}, {1, 1e-9, 0}},
      .triangles = {{0, 1, 2}}};
  for (const Welding& welding :
       {Welding(), Welding{Welding::Kind::kWithin, 0.1}}) {
    EXPECT_TRUE(Joined(needle, welding).reading.is_plain());
  }
}

TEST(JoinSeamsTest, ClosedMeshesAndPlainBoundariesAreLeftAlone) {
  EXPECT_TRUE(Joined(Cube()).reading.is_plain());
  EXPECT_TRUE(
      Joined(test::MakeGrid({.columns = 9, .rows = 7})).reading.is_plain());
}

TEST(JoinSeamsTest, ASoupThatIsRefusedLaterIsLeftAlone) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(Joined({.positions = {{0, 0, 0}}, .triangles = {{0, 1, 7}}})
                  .reading.is_plain());
  EXPECT_TRUE(Joined({.positions = {{nan, 0, 0}, {0, 1, 0}, {1, 0, 0}},
                      .triangles = {{0, 1, 2}}})
                  .reading.is_plain());
}

TEST(JoinSeamsTest, ADistanceIsANumberFromZero) {
  TriangleSoup soup = Cube();
  for (const double distance : {-1.0, kInfinity, std::nan("")}) {
    EXPECT_TRUE(absl::IsInvalidArgument(
        JoinSeams({Welding::Kind::kWithin, distance}, soup)));
  }
}

TEST(JoinSeamsTest, StopsWhenTold) {
  // So many edges in one place that each is compared with each other.
  TriangleSoup soup;
  for (uint32_t i = 0; i < 4000; ++i) {
    const double x = 1e-9 * i;
    soup.positions.insert(soup.positions.end(),
                          {{x, 0, 0}, {x, 1, 0}, {0, 0, 1.0 + i}});
    soup.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  test::RecordingCheckpoint checkpoint(3);
  EXPECT_TRUE(absl::IsCancelled(
      JoinSeams({Welding::Kind::kWithin, 1e-12}, soup, checkpoint)));
}

// Answers under the file's numbers: a cube of side 2 in twelve pieces.
class JoinedAnswers : public ::testing::Test {
 protected:
  void SetUp() override {
    TriangleSoup apart = TakenApart(Cube());
    whole_ = *Mesh::Build(Cube());
    corners_ = Cube().triangles;
    mesh_ = *Mesh::Build(Joined(std::move(apart)));
  }

  // The vertex of the whole cube at vertex v of the pieces.
  uint32_t InWhole(uint32_t v) const { return corners_[v / 3][v % 3]; }

  std::shared_ptr<const Mesh> whole_;
  std::shared_ptr<const Mesh> mesh_;
  std::vector<Triangle> corners_;
};

TEST_F(JoinedAnswers, FieldsAreThoseOfTheWholeFromEachRepeat) {
  for (uint32_t source = 0; source < mesh_->vertex_count(); ++source) {
    const auto field = Solve(*mesh_, {.sources = {{VertexPoint{source}}},
                                      .targets = {VertexPoint{35}}});
    const auto expected =
        Solve(*whole_, {.sources = {{VertexPoint{InWhole(source)}}}});
    ASSERT_TRUE(field.ok() && expected.ok());
    for (uint32_t v = 0; v < mesh_->vertex_count(); ++v) {
      EXPECT_NEAR(field->distances[v], expected->distances[InWhole(v)], 1e-14);
    }
    EXPECT_EQ(field->target_distances[0], field->distances[35]);
  }
}

// Places on edges name two corners of a face, as the file has it.
void ExpectOnNamedEdges(const Mesh& mesh,
                        const std::vector<SurfacePoint>& points) {
  for (const SurfacePoint& point : points) {
    const auto* on_edge = std::get_if<EdgePoint>(&point);
    if (on_edge == nullptr) continue;
    bool is_edge = false;
    for (uint32_t face = 0; face < mesh.face_count(); ++face) {
      const Triangle& corners = mesh.NamedTriangle(face);
      is_edge |= std::ranges::count(corners, on_edge->from) == 1 &&
                 std::ranges::count(corners, on_edge->to) == 1;
    }
    EXPECT_TRUE(is_edge) << on_edge->from << "-" << on_edge->to;
  }
}

TEST_F(JoinedAnswers, PathsAndIsolinesAreOnEdgesOfTheFile) {
  for (uint32_t source = 0; source < mesh_->vertex_count(); ++source) {
    const auto query = ValidQuery::Make({.sources = {{VertexPoint{source}}},
                                         .targets = {EdgePoint{33, 34, 0.25}},
                                         .trace = true},
                                        *mesh_)
                           .value();
    NoCheckpoint checkpoint;
    const auto field = Solve(*mesh_, query, {}, checkpoint).value();
    const auto tracer = PathTracer::Create(*mesh_, query, field).value();
    for (uint32_t target = 0; target < mesh_->vertex_count(); ++target) {
      const auto path = tracer.ToVertex(target).value();
      ExpectOnNamedEdges(*mesh_, path.points);
      EXPECT_NEAR(path.length, field.distances[target], 1e-14);
    }
    const auto path = tracer.ToTarget(0).value();
    ExpectOnNamedEdges(*mesh_, path.points);
    const auto isolines =
        ComputeIsolines(*mesh_, query.DistancesAlone(),
                        {.levels = {0.5, 1.2, 2.1, 3}}, {}, checkpoint)
            .value();
    ASSERT_FALSE(isolines.empty());
    for (const Isoline& line : isolines) {
      ExpectOnNamedEdges(*mesh_, line.points);
    }
  }
}

TEST_F(JoinedAnswers, EachVertexSettlesOnce) {
  test::SettledCheckpoint checkpoint(*mesh_);
  ASSERT_TRUE(
      Solve(*mesh_, Query{.sources = {{VertexPoint{7}}}}, {}, checkpoint).ok());
  std::vector<bool> settled(mesh_->vertex_count());
  for (const auto& v : checkpoint.settled) settled[v.vertex] = true;
  EXPECT_THAT(settled, testing::Each(true));
  EXPECT_THAT(checkpoint.settled, SizeIs(mesh_->vertex_count()));
}

TEST(LeftOutFacesTest, KeepTheirNumbersAndTakeNoPart) {
  // A unit square; face 1 names vertex 2 twice.
  const auto mesh =
      Mesh::Build({.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
                   .triangles = {{0, 1, 2}, {2, 2, 3}, {0, 2, 3}}})
          .value();
  EXPECT_EQ(mesh->face_count(), 3u);
  EXPECT_TRUE(mesh->IsLeftOut(1));
  EXPECT_EQ(mesh->triangle(2), (Triangle{0, 2, 3}));
  const MeshSummary summary = Summarize(*mesh);
  EXPECT_EQ(summary.left_out_faces, 1u);
  EXPECT_EQ(summary.boundary_edges, 4u);
  EXPECT_EQ(summary.genus, 0);
  EXPECT_THAT(
      Notes(summary),
      ElementsAre("left out 1 triangle, where a vertex is named twice"));
  const auto field = Solve(*mesh, {.sources = {{VertexPoint{1}}},
                                   .targets = {FacePoint{2, {0, 0, 1}}}})
                         .value();
  EXPECT_NEAR(field.distances[3], std::numbers::sqrt2, 1e-15);
  const auto refused =
      Solve(*mesh, {.sources = {{FacePoint{1, {0.5, 0.25, 0.25}}}}});
  EXPECT_EQ(
      refused.status().message(),
      "sources[0].face.face 1 names a vertex twice, so that it is no part "
      "of the surface");
}

TEST(LeftOutFacesTest, SomeFaceIsLeft) {
  EXPECT_TRUE(
      absl::IsInvalidArgument(Mesh::Build({.positions = {{0, 0, 0}, {1, 0, 0}},
                                           .triangles = {{0, 0, 1}, {1, 0, 1}}})
                                  .status()));
}

}  // namespace
}  // namespace geodesic
