#include "client/picture/default_view.h"

#include <gtest/gtest.h>

#include <cmath>

namespace geodesic::client {
namespace {

// A box between two corners.
MeshArrays Box(const Point& low, const Point& high) {
  MeshArrays mesh;
  for (int i = 0; i < 8; ++i) {
    mesh.positions.push_back({(i & 1) != 0 ? high[0] : low[0],
                              (i & 2) != 0 ? high[1] : low[1],
                              (i & 4) != 0 ? high[2] : low[2]});
  }
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6},
                    {0, 1, 4}, {1, 5, 4}, {2, 6, 3}, {3, 6, 7},
                    {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

TEST(GuessUpAxisTest, YUnlessTheMeshSaysOtherwise) {
  EXPECT_EQ(GuessUpAxis(Box({0, 0, 0}, {1, 1, 1}).positions), UpAxis::kY);
  EXPECT_EQ(GuessUpAxis({}), UpAxis::kY);
}

TEST(GuessUpAxisTest, FlatAlongZIsATerrain) {
  EXPECT_EQ(GuessUpAxis(Box({0, 0, 0}, {5, 4, 1}).positions), UpAxis::kZ);
}

TEST(GuessUpAxisTest, WhatWouldFallOverAlongYStandsAlongZ) {
  // A pyramid with its base at z = 0 and its apex to one side.
  EXPECT_EQ(GuessUpAxis({{0, 0, 0},
                         {2, 0, 0},
                         {0, 2, 0},
                         {2, 2, 0},
                         {1, 1, 3},
                         {1, -0.5, 1.5}}),
            UpAxis::kZ);
}

TEST(ChooseViewTest, SeesTheSource) {
  // The side the source is on decides: a source in the middle of each wall.
  const MeshArrays mesh = Box({-1, -1, -1}, {1, 1, 1});
  const View front = ChooseView(mesh, mesh.positions, {{0, 0, 1}}, UpAxis::kY);
  const View back = ChooseView(mesh, mesh.positions, {{0, 0, -1}}, UpAxis::kY);
  EXPECT_LT(std::abs(front.azimuth), 90);
  EXPECT_GT(std::abs(back.azimuth), 90);
}

TEST(ChooseViewTest, ShowsTheLongSide) {
  // Long along x is seen from the front, long along z from the side.
  const MeshArrays along_x = Box({-5, -1, -1}, {5, 1, 1});
  EXPECT_EQ(
      std::abs(ChooseView(along_x, along_x.positions, {}, UpAxis::kY).azimuth),
      30);
  const MeshArrays along_z = Box({-1, -1, -5}, {1, 1, 5});
  EXPECT_EQ(
      std::abs(ChooseView(along_z, along_z.positions, {}, UpAxis::kY).azimuth),
      60);
}

TEST(ChooseViewTest, SeesMoreOfTheMarks) {
  // Two in front against one behind.
  const MeshArrays mesh = Box({-1, -1, -1}, {1, 1, 1});
  const View view =
      ChooseView(mesh, mesh.positions, {{0, 0, -1}, {0.5, 0, 1}, {-0.5, 0, 1}},
                 UpAxis::kY);
  EXPECT_LT(std::abs(view.azimuth), 90);
}

TEST(ChooseViewTest, MarksFarOffAndEmptyMeshesAreFine) {
  ChooseView({}, {}, {{1e308, 0, 0}}, UpAxis::kY);
  EXPECT_GT(ChooseView({}, {}, {}, UpAxis::kZ).elevation, 30);
}

}  // namespace
}  // namespace geodesic::client
