#include "client/picture/rasterizer.h"

#include <gtest/gtest.h>

#include <cmath>

namespace geodesic::client {
namespace {

// Four corners of a square, and a nearer triangle over its lower right.
const std::vector<Vector3> kScreen = {{2, 2, 0}, {8, 2, 0}, {2, 8, 0},
                                      {8, 8, 0}, {8, 5, 1}, {5, 8, 1},
                                      {8, 8, 1}};

TEST(RasterizerTest, NeighboursLeaveNoSeamAndStayInside) {
  const VisibilityBuffer buffer =
      Rasterize(kScreen, {{0, 1, 2}, {2, 1, 3}}, 10, 10);
  for (int y = 0; y < 10; ++y) {
    for (int x = 0; x < 10; ++x) {
      const bool inside = x >= 2 && x < 8 && y >= 2 && y < 8;
      EXPECT_EQ(buffer.At(x, y).triangle != kNoTriangle, inside)
          << x << " " << y;
    }
  }
}

TEST(RasterizerTest, NearerHidesFartherInAnyOrder) {
  for (const bool near_first : {true, false}) {
    std::vector<Triangle> triangles = {{0, 1, 2}, {2, 1, 3}};
    const Triangle near = {4, 5, 6};
    triangles.insert(near_first ? triangles.begin() : triangles.end(), near);
    const VisibilityBuffer buffer = Rasterize(kScreen, triangles, 10, 10);
    EXPECT_EQ(triangles[buffer.At(7, 7).triangle], near);
    EXPECT_EQ(buffer.At(7, 7).depth, 1);
    EXPECT_NE(triangles[buffer.At(3, 3).triangle], near);
  }
}

TEST(RasterizerTest, WindingDoesNotMatter) {
  const VisibilityBuffer buffer = Rasterize(kScreen, {{0, 2, 1}}, 10, 10);
  EXPECT_EQ(buffer.At(3, 3).triangle, 0);
}

TEST(RasterizerTest, DepthIsInterpolated) {
  const std::vector<Vector3> screen = {{0, 0, 0}, {10, 0, 10}, {0, 10, 0}};
  const VisibilityBuffer buffer = Rasterize(screen, {{0, 1, 2}}, 10, 10);
  EXPECT_NEAR(buffer.At(4, 1).depth, 4.5, 1e-6);
}

TEST(RasterizerTest, EdgeOnAndOffscreenAreSkipped) {
  const std::vector<Vector3> screen = {
      {1, 1, 0},     {5, 5, 0},     {9, 9, 0},  {-50, -50, 0},
      {-40, -50, 0}, {-50, -40, 0}, {NAN, 1, 1}};
  const VisibilityBuffer buffer =
      Rasterize(screen, {{0, 1, 2}, {3, 4, 5}, {0, 1, 6}, {1, 1, 1}}, 10, 10);
  for (const VisibleSample& sample : buffer.samples) {
    EXPECT_EQ(sample.triangle, kNoTriangle);
  }
}

TEST(RasterizerTest, TrianglesAreClippedToTheScreen) {
  const std::vector<Vector3> screen = {
      {-1000, -1000, 0}, {3000, -1000, 0}, {-1000, 3000, 0}};
  const VisibilityBuffer buffer = Rasterize(screen, {{0, 1, 2}}, 10, 10);
  for (const VisibleSample& sample : buffer.samples) {
    EXPECT_EQ(sample.triangle, 0);
  }
}

TEST(IsVisibleTest, ComparesDepthOnTheScreenOnly) {
  const VisibilityBuffer buffer =
      Rasterize(kScreen, {{0, 1, 2}, {2, 1, 3}}, 10, 10);
  EXPECT_TRUE(IsVisible({4, 4, 0.5}, 0, buffer));
  EXPECT_FALSE(IsVisible({4, 4, -0.5}, 0, buffer));
  EXPECT_TRUE(IsVisible({4, 4, -0.5}, 1, buffer));
  EXPECT_TRUE(IsVisible({0.5, 0.5, -100}, 0, buffer));  // Nothing there.
  for (const double off :
       {-1.0, 10.0, 1e300, -1e300, double{INFINITY}, double{NAN}}) {
    EXPECT_FALSE(IsVisible({off, 4, 9}, 0, buffer)) << off;
    EXPECT_FALSE(IsVisible({4, off, 9}, 0, buffer)) << off;
  }
}

}  // namespace
}  // namespace geodesic::client
