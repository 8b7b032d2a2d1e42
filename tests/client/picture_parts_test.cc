// What pictures are made of: views, colours, normals, lines, cells, samples.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "client/picture/camera.h"
#include "client/picture/colormap.h"
#include "client/picture/corner_normals.h"
#include "client/picture/isolines.h"
#include "client/picture/nearest_cells.h"
#include "client/picture/rasterizer.h"

namespace geodesic::client {
namespace {

const std::vector<Point> kCorners = {
    {0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {2, 2, 0}};
constexpr Rectangle kArea = {10, 20, 200, 100};

TEST(CameraTest, FrontViewFitsTheMiddleOfTheArea) {
  const Camera camera(kCorners, {UpAxis::kY, 0, 0}, kArea);
  // 100 pixels for 2 units, around (110, 70); y points down.
  const Vector3 low = camera.Project({0, 0, 0});
  EXPECT_NEAR(low.x, 60, 1e-9);
  EXPECT_NEAR(low.y, 120, 1e-9);
  const Vector3 high = camera.Project({2, 2, 0});
  EXPECT_NEAR(high.x, 160, 1e-9);
  EXPECT_NEAR(high.y, 20, 1e-9);
}

TEST(CameraTest, LooksFromWhereTheViewSays) {
  // Views, and points toward their viewers.
  const std::vector<std::pair<View, Point>> table = {
      {{UpAxis::kY, 0, 0}, {0, 0, 1}},
      {{UpAxis::kY, 90, 0}, {1, 0, 0}},
      {{UpAxis::kY, 0, 90}, {0, 1, 0}},
      {{UpAxis::kZ, 0, 0}, {0, -1, 0}}};
  for (const auto& [view, point] : table) {
    const Camera camera(kCorners, view, kArea);
    EXPECT_GT(camera.Project(point).z, camera.Project({0, 0, 0}).z);
  }
  const Camera camera(kCorners, {UpAxis::kZ, 0, 0}, kArea);
  EXPECT_LT(camera.Project({0, 0, 1}).y, camera.Project({0, 0, 0}).y);
  EXPECT_GT(camera.Project({1, 0, 0}).x, camera.Project({0, 0, 0}).x);
}

TEST(CameraTest, AxesAreOrthonormalAndRightHanded) {
  for (const UpAxis up : {UpAxis::kY, UpAxis::kZ}) {
    const Camera camera(kCorners, {up, 37, 21}, kArea);
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

// Linear sRGB -> OKLab by the published matrices, the other way round than the
// colormap goes.
OkLab ToOkLab(const LinearColor& c) {
  const double l = std::cbrt(0.4122214708 * c.red + 0.5363325363 * c.green +
                             0.0514459929 * c.blue);
  const double m = std::cbrt(0.2119034982 * c.red + 0.6806995451 * c.green +
                             0.1073969566 * c.blue);
  const double s = std::cbrt(0.0883024619 * c.red + 0.2817188376 * c.green +
                             0.6299787005 * c.blue);
  return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
          1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
          0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
}

TEST(ColormapTest, LightnessRisesByStepsThatLookEqual) {
  const Colormap colormap;
  std::vector<double> steps;
  for (int i = 1; i <= 32; ++i) {
    const OkLab a = ToOkLab(colormap.At((i - 1) / 32.0));
    const OkLab b = ToOkLab(colormap.At(i / 32.0));
    EXPECT_GT(b.lightness, a.lightness) << i;
    steps.push_back(
        std::hypot(a.lightness - b.lightness, a.a - b.a, a.b - b.b));
  }
  const auto [least, most] = std::ranges::minmax(steps);
  EXPECT_LT(most / least, 1.15);
  EXPECT_LT(ToOkLab(colormap.At(0)).lightness, 0.4);
  EXPECT_GT(ToOkLab(colormap.At(1)).lightness, 0.9);
}

TEST(ColormapTest, ColoursAreWithinTheScreensReach) {
  // Channels that had to be clipped would show as exact zeros or ones.
  const Colormap colormap;
  for (int i = 0; i <= 255; ++i) {
    const LinearColor color = colormap.At(i / 255.0);
    for (const float channel : {color.red, color.green, color.blue}) {
      EXPECT_GT(channel, 0) << i;
      EXPECT_LT(channel, 1) << i;
    }
  }
  // Beyond the ends is the end.
  EXPECT_EQ(colormap.At(-1).red, colormap.At(0).red);
  EXPECT_EQ(colormap.At(2).red, colormap.At(1).red);
}

// Two triangles that share the edge 0-1 and make this angle with a plane.
MeshArrays Fold(double degrees) {
  const double angle = degrees * std::numbers::pi / 180;
  return {{{0, 0, 0},
           {0, 1, 0},
           {1, 0, 0},
           {-std::cos(angle), 0, -std::sin(angle)}},
          {{0, 2, 1}, {0, 1, 3}}};
}

TEST(CornerNormalsTest, GentleFoldsAreSmoothedAndSharpOnesStaySharp) {
  // Half way between both triangles' own.
  const double half = std::cos(15 * std::numbers::pi / 180);
  for (const auto& [degrees, first, second] :
       {std::array{0.0, 1.0, 1.0}, {30, half, half}, {60, 1, 0.5}}) {
    MeshArrays mesh = Fold(degrees);
    const auto normals = CornerNormals(mesh);
    EXPECT_NEAR(normals[0][0][2], first, 1e-6) << degrees;
    EXPECT_NEAR(normals[1][0][2], second, 1e-6) << degrees;
    // The winding of the other makes no difference.
    std::swap(mesh.triangles[1][0], mesh.triangles[1][1]);
    EXPECT_NEAR(CornerNormals(mesh)[0][0][2], first, 1e-6) << degrees;
  }
}

TEST(CornerNormalsTest, HugeAndDegenerateAreFinite) {
  const MeshArrays mesh = {
      {{1e300, 0, 0}, {0, 1e300, 0}, {0, 0, 1e300}, {0, 0, 0}},
      {{0, 1, 2}, {3, 3, 3}}};
  const auto normals = CornerNormals(mesh);
  EXPECT_NEAR(normals[0][0][0], 1 / std::numbers::sqrt3, 1e-6);
  EXPECT_EQ(normals[1][0], (Normal{0, 0, 0}));
}

TEST(CornerNormalsTest, VerticesOfManyTrianglesAreAveraged) {
  // A cone of 100,000 triangles: quadratic time would show.
  constexpr int kCount = 100000;
  MeshArrays mesh;
  mesh.positions.push_back({0, 0, 1});
  for (uint32_t i = 0; i < kCount; ++i) {
    const double angle = 2 * std::numbers::pi * i / kCount;
    mesh.positions.push_back({std::cos(angle), std::sin(angle), 0});
    mesh.triangles.push_back({0, 1 + i, 1 + (i + 1) % kCount});
  }
  EXPECT_NEAR(CornerNormals(mesh)[0][0][2], 1, 1e-6);
}

TEST(ChooseIsolinesTest, StepsAreRoundAndNumbersModerate) {
  for (double largest = 1.3e-7; largest < 1e9; largest *= 1.37) {
    const IsolineScale scale = ChooseIsolines(largest);
    const double labels = largest / scale.label_step();
    EXPECT_GE(labels, 4) << largest;
    EXPECT_LE(labels, 10) << largest;
    EXPECT_GE(largest / scale.step, 16) << largest;
    EXPECT_LE(largest / scale.step, 50) << largest;
    // 1, 2 or 5 times a power of ten.
    const double digits =
        scale.label_step() /
        std::pow(10, std::floor(std::log10(scale.label_step() * 1.0001)));
    EXPECT_TRUE(std::abs(digits - 1) < 1e-9 || std::abs(digits - 2) < 1e-9 ||
                std::abs(digits - 5) < 1e-9)
        << digits;
  }
}

TEST(ChooseIsolinesTest, NothingForNothing) {
  for (const double largest :
       {0.0, -1.0, std::numeric_limits<double>::infinity(), std::nan("")}) {
    EXPECT_EQ(ChooseIsolines(largest).step, 0);
    EXPECT_TRUE(ScaleLabels(ChooseIsolines(largest), largest).empty());
  }
}

TEST(IsolineCoverageTest, IsOneOnALineAndZeroBetween) {
  const IsolineScale scale = {0.1, 5};
  const double gradient = 0.1 / 40;  // Lines are 40 pixels apart.
  EXPECT_EQ(IsolineCoverage(scale, 0.5, gradient, 2), 1);
  EXPECT_GT(IsolineCoverage(scale, 0.3, gradient, 2), 0.5);
  EXPECT_EQ(IsolineCoverage(scale, 0.35, gradient, 2), 0);
}

TEST(IsolineCoverageTest, WidthIsInPixelsWhateverTheSlope) {
  const IsolineScale scale = {0.1, 5};
  for (const double pixels_apart : {20.0, 40.0, 400.0}) {
    const double gradient = 0.1 / pixels_apart;
    // The line at 0.5 is 4 pixels wide.
    EXPECT_EQ(IsolineCoverage(scale, 0.5 + 1.7 * gradient, gradient, 2), 1);
    EXPECT_EQ(IsolineCoverage(scale, 0.5 + 2.3 * gradient, gradient, 2), 0);
  }
}

TEST(IsolineCoverageTest, SourcesCrowdedLinesAndFlatFieldsHaveNone) {
  EXPECT_EQ(IsolineCoverage({0.1, 5}, 0, 0.01, 2), 0);
  EXPECT_EQ(IsolineCoverage({0.1, 5}, 0.5, 1, 2), 0);
  EXPECT_EQ(IsolineCoverage({0.1, 5}, 0.5, 0, 2), 0);
  EXPECT_EQ(IsolineCoverage({0, 1}, 0.5, 1, 2), 0);
}

TEST(ScaleLabelsTest, AreWrittenShort) {
  const auto labels = ScaleLabels({0.02, 5}, 0.35);
  ASSERT_EQ(labels.size(), 4);
  EXPECT_EQ(labels[0].text, "0");
  EXPECT_EQ(labels[3].text, "0.3");
  EXPECT_EQ(ScaleLabels({4e-6, 5}, 2.1e-5)[1].text, "2e-05");
}

// Two triangles of a plane, 0-1-2 and 2-1-3, with sources at corners 0 and 3.
const MeshArrays kSquare = {{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {2, 2, 0}},
                            {{0, 1, 2}, {2, 1, 3}}};

TEST(NearestCellsTest, WithinATriangleTheNearestOfItsCornersSourcesWins) {
  // Vertices 1 and 2 are as far from both sources, and belong to the first.
  const std::vector<double> distances = {0, 2, 2, 0};
  const std::vector<uint32_t> nearest = {5, 5, 5, 7};
  const NearestCells cells(kSquare, distances, nearest);
  EXPECT_EQ(cells.At({0, 1, 2}, {0.1, 0.45, 0.45}).source, 5);
  // The other triangle is nearer to 7 all over.
  for (const double to_3 : {0.01, 0.3, 0.9}) {
    const double rest = (1 - to_3) / 2;
    const NearestCells::Nearest found = cells.At({2, 1, 3}, {rest, rest, to_3});
    EXPECT_EQ(found.source, 7) << to_3;
    EXPECT_DOUBLE_EQ(found.corner_distances[0], 2);
    EXPECT_DOUBLE_EQ(found.corner_distances[1], 2);
    EXPECT_DOUBLE_EQ(found.corner_distances[2], 0);
  }
}

TEST(NearestCellsTest, UnfoldsOverASideInAnyUnit) {
  // Folded along 1-2, which changes no distance. Vertex 3 is nearest to a
  // source of its own; from 0 it is sqrt(8) away, straight over the side.
  for (const double unit : {1e-200, 1.0, 1e200}) {
    MeshArrays folded = kSquare;
    folded.positions[3] = {1, 1, std::sqrt(2)};
    for (Point& point : folded.positions) {
      for (double& coordinate : point) coordinate *= unit;
    }
    const std::vector<double> distances = {0, 2 * unit, 2 * unit, unit};
    const std::vector<uint32_t> nearest = {0, 0, 0, 1};
    const NearestCells cells(folded, distances, nearest);
    // Half way from 1 to 2: sqrt(2) from source 0, less than from the other.
    const NearestCells::Nearest found = cells.At({2, 1, 3}, {0.5, 0.5, 0});
    EXPECT_EQ(found.source, 0);
    EXPECT_NEAR(found.corner_distances[2] / unit, std::sqrt(8), 1e-12);
  }
}

TEST(NearestCellsTest, OneSourceHasItsCellWhole) {
  const std::vector<double> distances = {0, 2, 2, 3};
  const std::vector<uint32_t> nearest = {4, 4, 4, 4};
  const NearestCells cells(kSquare, distances, nearest);
  const NearestCells::Nearest found = cells.At({2, 1, 3}, {0.2, 0.2, 0.6});
  EXPECT_EQ(found.source, 4);
  EXPECT_EQ(found.corner_distances, (std::array<double, 3>{2, 2, 3}));
}

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
