// Boundary edges that nothing joins are told: right numbers by hand.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "geodesic/join_seams.h"
#include "geodesic/mesh.h"
#include "geodesic/mesh_summary.h"
#include "tests/support/meshes/planar_meshes.h"

namespace geodesic {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

MeshSummary Told(TriangleSoup soup) {
  const absl::Status joined = JoinSeams({}, soup);
  EXPECT_TRUE(joined.ok()) << joined;
  const auto mesh = Mesh::Build(std::move(soup));
  EXPECT_TRUE(mesh.ok()) << mesh.status();
  const MeshSummary summary = Summarize(**mesh);
  EXPECT_EQ(SummarizeReading(**mesh).touching_edges, summary.touching_edges);
  return summary;
}

// A long edge below, from 0 to 2 along x, and two halves of it above.
TriangleSoup CornerInsideAnEdge(double size) {
  const std::vector<Point> positions = {{0, 0, 0}, {2, 0, 0}, {1, -1, 0},
                                        {0, 0, 0}, {1, 0, 0}, {1, 1, 0},
                                        {2, 0, 0}};
  TriangleSoup soup{.positions = positions,
                    .triangles = {{0, 2, 1}, {3, 4, 5}, {4, 6, 5}}};
  for (Point& point : soup.positions) {
    for (double& x : point) x *= size;
  }
  return soup;
}

TEST(TouchingEdgesTest, ACornerInsideAnEdge) {
  for (const double size : {1.0, 1e-200, 1e150}) {
    const MeshSummary summary = Told(CornerInsideAnEdge(size));
    EXPECT_EQ(summary.touching_edges, 3u) << size;
    EXPECT_EQ(summary.close_edges, 0u) << size;
    EXPECT_EQ(summary.seam_edges, 0u) << size;
    EXPECT_THAT(
        Notes(summary),
        ElementsAre(HasSubstr("3 boundary edges lie along other edges")))
        << size;
  }
}

TEST(TouchingEdgesTest, ACornerInsideAnEdgeWhoseEndsAreJoined) {
  TriangleSoup soup = CornerInsideAnEdge(1);
  soup.triangles = {{0, 2, 1}, {0, 4, 5}, {4, 1, 5}};
  EXPECT_EQ(Told(std::move(soup)).touching_edges, 3u);
}

TEST(TouchingEdgesTest, EdgesOfDifferentLengths) {
  // Below one edge of 1000, above a thousand of 1.
  TriangleSoup soup{.positions = {{0, 0, 0}, {1000, 0, 0}, {500, -900, 0}},
                    .triangles = {{0, 2, 1}}};
  for (uint32_t i = 0; i < 1000; ++i) {
    const double x = i;
    for (const Point& point :
         {Point{x, 0, 0}, Point{x + 1, 0, 0}, Point{x + 0.5, 1, 0}}) {
      soup.positions.push_back(point);
    }
    soup.triangles.push_back({3 * i + 3, 3 * i + 4, 3 * i + 5});
  }
  EXPECT_EQ(Told(std::move(soup)).touching_edges, 1001u);
}

TEST(TouchingEdgesTest, EdgesThatArePushedAlongEachOther) {
  // From 0 to 2 below, from 0.5 to 2.5 above: each lies along the other.
  const std::vector<Point> positions = {{0, 0, 0},   {2, 0, 0},   {1, -1, 0},
                                        {0.5, 0, 0}, {2.5, 0, 0}, {1, 1, 0}};
  EXPECT_EQ(Told({.positions = positions, .triangles = {{0, 2, 1}, {3, 4, 5}}})
                .touching_edges,
            2u);
}

TEST(TouchingEdgesTest, BricksAreToldWhateverTheirShift) {
  for (const double shift : {0.1, 0.5, 0.9}) {
    TriangleSoup soup;
    for (const double side : {-1.0, 1.0}) {
      const auto first = static_cast<uint32_t>(soup.positions.size());
      const double begin = side > 0 ? shift : 0;
      for (const double y : {0.0, side}) {
        for (const double x : {0.0, 1.0, 2.0}) {
          soup.positions.push_back({begin + x, y, 0});
        }
      }
      for (const uint32_t i : {first, first + 1}) {
        soup.triangles.push_back({i, i + 1, i + 3});
        soup.triangles.push_back({i + 1, i + 4, i + 3});
      }
    }
    EXPECT_EQ(Told(std::move(soup)).touching_edges, 4u) << shift;
  }
}

TEST(TouchingEdgesTest, AWallOnAnEdgeInsideAFloor) {
  // Its foot repeats the ends of the floor's diagonal.
  const std::vector<Point> positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0},
                                        {0, 1, 0}, {0, 0, 0}, {1, 1, 0},
                                        {0, 0, 1}};
  const MeshSummary summary = Told(
      {.positions = positions, .triangles = {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}}});
  EXPECT_EQ(summary.touching_edges, 1u);
  EXPECT_EQ(summary.seam_edges, 0u);
}

TEST(TouchingEdgesTest, NothingElseIsTold) {
  const std::vector<Point> crossing = {{0, 0, 0},  {2, 0, 0}, {1, -1, 0},
                                       {1, -1, 0}, {1, 1, 0}, {1, 0, 1}};
  const std::vector<Point> behind = {{0, 0, 0},   {1, 0, 0}, {0, -1, 0},
                                     {1.5, 0, 0}, {3, 0, 0}, {2, 1, 0}};
  const std::vector<Point> sheared = {{0, 0, 0},      {1, 0, 0},
                                      {2, 0, 0},      {3.7, 0.03, 0},
                                      {4.7, 0.03, 0}, {5.7, 0.03, 0}};
  const std::vector<std::pair<std::string, TriangleSoup>> meshes = {
      {"a grid", test::MakeGrid({.jitter = 0.2})},
      {"sides that touch in a corner",
       {.positions =
            {{0, 0, 0}, {2, 0, 0}, {1, -1, 0}, {1, 0, 0}, {2, 1, 0}, {0, 1, 0}},
        .triangles = {{0, 2, 1}, {3, 4, 5}}}},
      {"edges that cross",
       {.positions = crossing, .triangles = {{0, 2, 1}, {3, 4, 5}}}},
      {"edges one behind the other",
       {.positions = behind, .triangles = {{0, 2, 1}, {3, 4, 5}}}},
      {"the sides of a needle",
       {.positions = {{0, 0, 0}, {100, 0, 0}, {50, 1e-3, 0}},
        .triangles = {{0, 1, 2}}}},
      {"the sides of a strip",
       {.positions = {{0, 0, 0}, {100, 0, 0}, {150, 1, 0}, {50, 1, 0}},
        .triangles = {{0, 1, 3}, {1, 2, 3}}}},
      {"a sheared grid",
       {.positions = sheared,
        .triangles = {{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}}}},
      {"two sheets that open in a corner",
       {.positions =
            {{0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {1, -0.02, 0}, {0, -1, 0}},
        .triangles = {{0, 1, 2}, {0, 4, 3}}}},
      {"more than doubles hold",
       {.positions = {{-1.7e308, 0, 0}, {1.7e308, 0, 0}, {0, 1.7e308, 0}},
        .triangles = {{0, 1, 2}}}}};
  for (const auto& [name, soup] : meshes) {
    const MeshSummary summary = Told(soup);
    EXPECT_EQ(summary.touching_edges, 0u) << name;
    EXPECT_THAT(Notes(summary), IsEmpty()) << name;
  }
}

}  // namespace
}  // namespace geodesic
