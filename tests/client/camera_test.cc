#include "client/picture/camera.h"

#include <gtest/gtest.h>

#include <cmath>

namespace geodesic::client {
namespace {

const std::vector<Point> kSquare = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {2, 2, 0}};
constexpr Rectangle kArea = {10, 20, 200, 100};

TEST(CameraTest, FrontViewFitsTheMiddleOfTheArea) {
  const Camera camera(kSquare, {UpAxis::kY, 0, 0}, kArea);
  // 100 pixels for 2 units, around (110, 70); y points down.
  const Vector3 low = camera.Project({0, 0, 0});
  EXPECT_NEAR(low.x, 60, 1e-9);
  EXPECT_NEAR(low.y, 120, 1e-9);
  const Vector3 high = camera.Project({2, 2, 0});
  EXPECT_NEAR(high.x, 160, 1e-9);
  EXPECT_NEAR(high.y, 20, 1e-9);
}

TEST(CameraTest, NearerIsMoreTowardTheViewer) {
  const Camera camera(kSquare, {UpAxis::kY, 0, 0}, kArea);
  EXPECT_GT(camera.Project({0, 0, 1}).z, camera.Project({0, 0, 0}).z);
  const Camera from_the_right(kSquare, {UpAxis::kY, 90, 0}, kArea);
  EXPECT_GT(from_the_right.Project({1, 0, 0}).z,
            from_the_right.Project({0, 0, 0}).z);
}

TEST(CameraTest, WithZUpTheFrontIsAlongY) {
  const Camera camera(kSquare, {UpAxis::kZ, 0, 0}, kArea);
  EXPECT_GT(camera.Project({0, -1, 0}).z, camera.Project({0, 0, 0}).z);
  EXPECT_LT(camera.Project({0, 0, 1}).y, camera.Project({0, 0, 0}).y);
  EXPECT_GT(camera.Project({1, 0, 0}).x, camera.Project({0, 0, 0}).x);
}

TEST(CameraTest, ElevationLooksDown) {
  const Camera camera(kSquare, {UpAxis::kY, 0, 90}, kArea);
  EXPECT_GT(camera.Project({0, 1, 0}).z, camera.Project({0, 0, 0}).z);
}

TEST(CameraTest, AxesAreOrthonormalAndRightHanded) {
  for (const UpAxis up : {UpAxis::kY, UpAxis::kZ}) {
    const Camera camera(kSquare, {up, 37, 21}, kArea);
    const Vector3 cross = Cross(camera.right(), camera.up());
    EXPECT_NEAR(Length(camera.right()), 1, 1e-12);
    EXPECT_NEAR(Length(camera.up()), 1, 1e-12);
    EXPECT_NEAR(Length(cross - camera.toward_viewer()), 0, 1e-12);
  }
}

TEST(CameraTest, HugeCoordinatesStayFinite) {
  const Camera camera({{-1e308, -1e308, 0}, {1e308, 1e308, 0}},
                      {UpAxis::kY, 30, 20}, kArea);
  const Vector3 corner = camera.Project({1e308, 1e308, 0});
  EXPECT_GE(corner.x, kArea.left - 1e-6);
  EXPECT_LE(corner.x, kArea.left + kArea.width + 1e-6);
}

TEST(CameraTest, NothingAndOnePointAreFine) {
  const Camera nothing({}, {UpAxis::kY, 0, 0}, kArea);
  EXPECT_NEAR(nothing.Project({0, 0, 0}).x, 110, 1e-9);
  const Camera one({{5, 5, 5}}, {UpAxis::kY, 0, 0}, kArea);
  EXPECT_NEAR(one.Project({5, 5, 5}).x, 110, 1e-6);
  EXPECT_NEAR(one.Project({5, 5, 5}).y, 70, 1e-6);
}

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
  // A terrain, flat along z.
  EXPECT_EQ(GuessUpAxis(Box({0, 0, 0}, {5, 4, 1}).positions), UpAxis::kZ);
  // A pyramid with its base at z = 0 and its apex to one side, which would fall
  // over along y.
  EXPECT_EQ(GuessUpAxis({{0, 0, 0},
                         {2, 0, 0},
                         {0, 2, 0},
                         {2, 2, 0},
                         {1, 1, 3},
                         {1, -0.5, 1.5}}),
            UpAxis::kZ);
}

TEST(ChooseViewTest, SeesMostOfTheMarks) {
  const MeshArrays mesh = Box({-1, -1, -1}, {1, 1, 1});
  const auto azimuth = [&mesh](const std::vector<Point>& marks) {
    return std::abs(
        ChooseView(mesh, mesh.positions, marks, UpAxis::kY).azimuth);
  };
  EXPECT_LT(azimuth({{0, 0, 1}}), 90);
  EXPECT_GT(azimuth({{0, 0, -1}}), 90);
  // Two in front against one behind.
  EXPECT_LT(azimuth({{0, 0, -1}, {0.5, 0, 1}, {-0.5, 0, 1}}), 90);
}

TEST(ChooseViewTest, ShowsTheLongSide) {
  // Long along x is seen from the front, long along z from the side.
  const auto azimuth = [](const Point& corner) {
    const MeshArrays mesh = Box({-corner[0], -corner[1], -corner[2]}, corner);
    return std::abs(ChooseView(mesh, mesh.positions, {}, UpAxis::kY).azimuth);
  };
  EXPECT_EQ(azimuth({5, 1, 1}), 30);
  EXPECT_EQ(azimuth({1, 1, 5}), 60);
}

TEST(ChooseViewTest, MarksFarOffAndEmptyMeshesAreFine) {
  ChooseView({}, {}, {{1e308, 0, 0}}, UpAxis::kY);
  EXPECT_GT(ChooseView({}, {}, {}, UpAxis::kZ).elevation, 30);
}

}  // namespace
}  // namespace geodesic::client
