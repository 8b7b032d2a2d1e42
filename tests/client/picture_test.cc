#include "client/picture/picture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>

#include "client/picture/color_bar.h"
#include "client/picture/colormap.h"

namespace geodesic::client {
namespace {

constexpr int kWidth = 480;
constexpr int kHeight = 360;

// A quad that faces the viewer; its distances rise from 0 at the left to
// `largest` at the right.
MeshArrays Quad() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {{0, 1, 2}, {2, 1, 3}}};
}

PictureOptions FromTheFront() {
  PictureOptions options;
  options.width = kWidth;
  options.height = kHeight;
  options.direction = ViewDirection{0, 0};
  options.up = UpAxis::kY;
  return options;
}

Image RenderField(const MeshArrays& mesh, const std::vector<double>& distances,
                  const std::vector<Point>& sources = {},
                  const PictureOptions& options = FromTheFront()) {
  return Render(mesh,
                {.distances = distances, .isolines = true, .sources = sources},
                options);
}

// Where the quad is: the square in the middle of what the colour bar leaves.
struct Placement {
  double left, right, top, bottom;
};
Placement QuadPlacement() {
  const double margin = 0.05 * kHeight;
  const double width = kWidth - ColorBarWidth(kWidth, kHeight) - margin;
  const double side = std::min(width, kHeight - 2 * margin);
  const double x = margin + width / 2;
  return {x - side / 2, x + side / 2, kHeight / 2 - side / 2,
          kHeight / 2 + side / 2};
}

int Brightness(const Rgb8& pixel) {
  return pixel.red + pixel.green + pixel.blue;
}

TEST(PictureTest, TheMeshIsWhereItBelongsOnWhite) {
  const Image image = RenderField(Quad(), {0, 1, 0, 1});
  const Placement at = QuadPlacement();
  const Rgb8 white = {255, 255, 255};
  const auto left = static_cast<int>(at.left);
  const auto top = static_cast<int>(at.top);
  EXPECT_EQ(image.At(left - 2, kHeight / 2), white);
  EXPECT_NE(image.At(left + 2, kHeight / 2), white);
  EXPECT_EQ(image.At(left + 20, top - 2), white);
  EXPECT_NE(image.At(left + 20, top + 2), white);
  EXPECT_EQ(image.At(0, 0), white);
}

TEST(PictureTest, ColoursFollowTheDistanceInHue) {
  const Image image = RenderField(Quad(), {0, 1, 0, 1});
  const Placement at = QuadPlacement();
  const Colormap colormap;
  for (const double t : {0.07, 0.28, 0.53, 0.72, 0.97}) {
    const auto x = static_cast<int>(at.left + t * (at.right - at.left));
    const Rgb8 pixel = image.At(x, kHeight / 2);
    // Shading scales all channels alike; at the centre of a pixel the distance
    // is that of its position.
    const LinearColor expected =
        colormap.At((x + 0.5 - at.left) / (at.right - at.left));
    const float scale = LinearFromSrgb(pixel.green / 255.0F) / expected.green;
    EXPECT_NEAR(LinearFromSrgb(pixel.red / 255.0F), scale * expected.red, 0.02)
        << t;
    EXPECT_NEAR(LinearFromSrgb(pixel.blue / 255.0F), scale * expected.blue,
                0.02)
        << t;
    EXPECT_GT(scale, 0.6);
    EXPECT_LE(scale, 1.1);
  }
}

TEST(PictureTest, IsolinesRunAtRoundDistances) {
  // Labelled lines at multiples of 0.2, others at multiples of 0.05.
  const Image image = RenderField(Quad(), {0, 1, 0, 1});
  const Placement at = QuadPlacement();
  const auto pixel_at = [&](double distance) {
    const double x = at.left + distance * (at.right - at.left);
    return image.At(static_cast<int>(std::floor(x)), kHeight / 2);
  };
  for (const double labelled : {0.2, 0.4, 0.6, 0.8}) {
    const int line = Brightness(pixel_at(labelled));
    const int minor = Brightness(pixel_at(labelled + 0.05));
    const int between = Brightness(pixel_at(labelled + 0.025));
    EXPECT_LT(line, 0.6 * between) << labelled;
    EXPECT_LT(minor, 0.9 * between) << labelled;
    EXPECT_LT(line, minor) << labelled;
  }
}

TEST(PictureTest, UnreachablePartsAreGrey) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const Image image = RenderField(Quad(), {kInfinity, kInfinity, 1, kInfinity});
  const Placement at = QuadPlacement();
  const Rgb8 pixel = image.At(static_cast<int>(at.left) + 20, kHeight / 2);
  EXPECT_EQ(pixel.red, pixel.green);
  EXPECT_EQ(pixel.green, pixel.blue);
  EXPECT_GT(pixel.red, 120);
  EXPECT_LT(pixel.red, 230);
}

TEST(PictureTest, SourcesAreMarkedWhereTheyAreSeen) {
  // The middle of the quad is behind it for vertex 5 and in front for vertex 4.
  MeshArrays mesh = Quad();
  mesh.positions.push_back({0.5, 0.5, 0.0});
  mesh.positions.push_back({0.5, 0.5, -0.9});
  mesh.triangles.push_back({5, 5, 5});
  mesh.triangles.push_back({4, 4, 4});
  const std::vector<double> distances = {0.4, 1, 0.4, 1, 0, 0};
  const Placement at = QuadPlacement();
  const auto x = static_cast<int>((at.left + at.right) / 2);
  const Rgb8 seen =
      RenderField(mesh, distances, {mesh.positions[4]}).At(x, kHeight / 2);
  EXPECT_GT(seen.red, 180);
  EXPECT_LT(seen.green, 60);
  const Rgb8 hidden =
      RenderField(mesh, distances, {mesh.positions[5]}).At(x, kHeight / 2);
  EXPECT_EQ(hidden, RenderField(mesh, distances, {}).At(x, kHeight / 2));
}

TEST(PictureTest, TheColourBarGoesFromDarkToLight) {
  const Image image = RenderField(Quad(), {0, 1, 0, 1});
  // A column of the bar: the first right of the mesh that is not white.
  const auto bottom = static_cast<int>(0.87 * kHeight);
  const auto top = static_cast<int>(0.17 * kHeight);
  int x = static_cast<int>(QuadPlacement().right) + 3;
  while (x < kWidth && image.At(x, bottom) == Rgb8{255, 255, 255}) ++x;
  ASSERT_LT(x, kWidth);
  x += 3;
  EXPECT_GT(Brightness(image.At(x, top)),
            Brightness(image.At(x, bottom)) + 150);
}

TEST(PictureTest, AnyMagnitudeIsDrawn) {
  // The pictures do not depend on the unit.
  const Image unit = RenderField(Quad(), {0, 1, 0, 1});
  for (const double scale : {1e-300, 1e300}) {
    MeshArrays mesh = Quad();
    for (Point& point : mesh.positions) {
      for (double& coordinate : point) coordinate *= scale;
    }
    const Image scaled = RenderField(mesh, {0, scale, 0, scale});
    const auto x = static_cast<int>(QuadPlacement().left) + 25;
    EXPECT_NEAR(scaled.At(x, kHeight / 2).green, unit.At(x, kHeight / 2).green,
                2);
  }
}

TEST(PictureTest, StrayVerticesDoNotShrinkTheMesh) {
  MeshArrays mesh = Quad();
  mesh.positions.push_back({1e308, 1e308, -1e308});
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  PictureOptions options;
  options.width = kWidth;
  options.height = kHeight;
  // As a source, too, it changes nothing.
  const Image with =
      RenderField(mesh, {0, 1, 0, 1, kInfinity}, {mesh.positions[4]}, options);
  const Image without = RenderField(Quad(), {0, 1, 0, 1}, {}, options);
  EXPECT_TRUE(with.pixels == without.pixels);
}

TEST(PictureTest, NothingToSeeIsStillAPicture) {
  EXPECT_EQ(RenderField({}, {}).width, kWidth);
  EXPECT_EQ(RenderField({{{0, 0, 0}}, {}}, {0}, {{0, 0, 0}}).height, kHeight);
}

TEST(PictureTest, ChoosesAViewByItself) {
  PictureOptions options;
  options.width = 64;
  options.height = 64;
  const Image image = RenderField(Quad(), {0, 1, 0, 1}, {{0, 0, 0}}, options);
  EXPECT_EQ(image.width, 64);
  EXPECT_NE(image.At(25, 32), (Rgb8{255, 255, 255}));
}

// Without a colour bar the quad fills the height and is centred.
TEST(PictureTest, BoldLinesAreFaintWhereSomethingHidesThem) {
  MeshArrays mesh = Quad();
  // A wall in front of the right half.
  for (const double y : {0.0, 1.0}) {
    mesh.positions.push_back({0.5, y, 0.5});
    mesh.positions.push_back({1.0, y, 0.5});
  }
  mesh.triangles.push_back({4, 5, 6});
  mesh.triangles.push_back({6, 5, 7});
  const PictureLine line = {.points = {{0.1, 0.5, 0}, {0.9, 0.5, 0}}};
  const Image image = Render(mesh, {.bold_lines = {line}}, FromTheFront());
  const double side = 0.9 * kHeight;
  const auto pixel = [&](double x, double y) {
    return image.At(static_cast<int>(kWidth / 2.0 + (x - 0.5) * side),
                    static_cast<int>(kHeight / 2.0 - (y - 0.5) * side));
  };
  EXPECT_GT(pixel(0.3, 0.5).red, pixel(0.3, 0.5).green + 100);
  EXPECT_LT(pixel(0.3, 0.6).red, pixel(0.3, 0.6).green + 40);
  EXPECT_GT(pixel(0.7, 0.5).red, pixel(0.7, 0.5).green + 15);
  EXPECT_LT(pixel(0.7, 0.5).red, pixel(0.7, 0.5).green + 70);
  EXPECT_LT(pixel(0.05, 0.5).red, pixel(0.05, 0.5).green + 40);
}

TEST(PictureTest, ClosedLinesComeBack) {
  PictureLine line = {.points = {{0.2, 0.2, 0}, {0.8, 0.2, 0}, {0.5, 0.8, 0}}};
  const Image open = Render(Quad(), {.thin_lines = {line}}, FromTheFront());
  line.is_closed = true;
  const Image closed = Render(Quad(), {.thin_lines = {line}}, FromTheFront());
  const double side = 0.9 * kHeight;
  // The middle of the closing side.
  const auto x = static_cast<int>(kWidth / 2.0 + (0.35 - 0.5) * side);
  const auto y = static_cast<int>(kHeight / 2.0);
  EXPECT_LT(Brightness(closed.At(x, y)), Brightness(open.At(x, y)) - 100);
}

TEST(PictureTest, LabelsHaveColoursOfTheirOwn) {
  const std::vector<double> distances = {0, 0, 0, 0};
  const std::vector<uint32_t> labels = {0, 1, 0, 1};
  const Image image = Render(Quad(), {.distances = distances, .labels = labels},
                             FromTheFront());
  const Rgb8 left = image.At(kWidth / 2 - 80, kHeight / 2);
  const Rgb8 right = image.At(kWidth / 2 + 80, kHeight / 2);
  EXPECT_EQ(image.At(kWidth / 2 - 60, kHeight / 2), left);
  EXPECT_GT(std::abs(left.red - right.red) +
                std::abs(left.green - right.green) +
                std::abs(left.blue - right.blue),
            60);
}

}  // namespace
}  // namespace geodesic::client
