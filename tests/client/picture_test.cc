#include "client/picture/picture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <string_view>

#include "client/picture/colormap.h"
#include "client/picture/overlay.h"
#include "tests/integration/meshes.h"

namespace geodesic::client {
namespace {

using ::testing::AllOf;
using ::testing::EndsWith;
using ::testing::StartsWith;

constexpr int kWidth = 480;
constexpr int kHeight = 360;

struct Rgb8 {
  uint8_t red = 0;
  uint8_t green = 0;
  uint8_t blue = 0;

  friend bool operator==(const Rgb8&, const Rgb8&) = default;
};

constexpr Rgb8 kWhite = {255, 255, 255};

// A picture's pixels, from the file that it becomes.
class Pixels {
 public:
  explicit Pixels(const Image& image) : png_(image.EncodePng().value()) {
    std::string_view unread = png_;
    surface_.reset(cairo_image_surface_create_from_png_stream(Read, &unread));
    EXPECT_EQ(cairo_surface_status(surface_.get()), CAIRO_STATUS_SUCCESS);
  }

  int width() const { return cairo_image_surface_get_width(surface_.get()); }
  int height() const { return cairo_image_surface_get_height(surface_.get()); }

  Rgb8 At(int x, int y) const {
    uint32_t pixel;
    std::memcpy(&pixel,
                cairo_image_surface_get_data(surface_.get()) +
                    y * cairo_image_surface_get_stride(surface_.get()) + 4 * x,
                sizeof(pixel));
    return {static_cast<uint8_t>(pixel >> 16), static_cast<uint8_t>(pixel >> 8),
            static_cast<uint8_t>(pixel)};
  }

  // How many of a rectangle's pixels satisfy a condition.
  template <typename Condition>
  int Count(int left, int top, int right, int bottom, Condition is) const {
    int count = 0;
    for (int y = top; y < bottom; ++y) {
      for (int x = left; x < right; ++x) count += is(At(x, y)) ? 1 : 0;
    }
    return count;
  }

  friend bool operator==(const Pixels& a, const Pixels& b) {
    return a.png_ == b.png_;
  }

 private:
  struct Destroy {
    void operator()(cairo_surface_t* s) const { cairo_surface_destroy(s); }
  };

  static cairo_status_t Read(void* from, unsigned char* data,
                             unsigned int length) {
    auto* bytes = static_cast<std::string_view*>(from);
    if (bytes->size() < length) return CAIRO_STATUS_READ_ERROR;
    std::memcpy(data, bytes->data(), length);
    bytes->remove_prefix(length);
    return CAIRO_STATUS_SUCCESS;
  }

  std::string png_;
  std::unique_ptr<cairo_surface_t, Destroy> surface_;
};

Pixels Draw(const MeshArrays& mesh, const PictureContent& content,
            const PictureOptions& options) {
  return Pixels(Render(mesh, content, options));
}

double LinearFromSrgb(double srgb) {
  return srgb <= 0.04045 ? srgb / 12.92 : std::pow((srgb + 0.055) / 1.055, 2.4);
}

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

Pixels RenderField(const MeshArrays& mesh, const std::vector<double>& distances,
                   const std::vector<Point>& sources = {},
                   const PictureOptions& options = FromTheFront()) {
  return Draw(mesh,
              {.distances = distances, .isolines = true, .sources = sources},
              options);
}

// Where the quad is: the square in the middle of what the key leaves.
struct Placement {
  explicit Placement(double key = KeyWidth(kWidth, kHeight)) {
    const double margin = 0.05 * kHeight;
    const double width = kWidth - std::max(key, margin) - margin;
    side = std::min(width, kHeight - 2 * margin);
    left = margin + width / 2 - side / 2;
    bottom = kHeight / 2.0 + side / 2;
  }

  // The pixel of a point of the quad, from 0 to 1.
  Rgb8 Pixel(const Pixels& image, double x, double y) const {
    return image.At(static_cast<int>(left + x * side),
                    static_cast<int>(bottom - y * side));
  }

  double side, left, bottom;
};

int Brightness(const Rgb8& pixel) {
  return pixel.red + pixel.green + pixel.blue;
}

TEST(PictureTest, AFieldHasItsPlaceColoursLinesAndBar) {
  const Pixels image = RenderField(Quad(), {0, 1, 0, 1});
  const Placement at;
  const auto left = static_cast<int>(at.left);
  const auto top = static_cast<int>(at.bottom - at.side);
  // The mesh is where it belongs, on white.
  EXPECT_EQ(image.At(left - 2, kHeight / 2), kWhite);
  EXPECT_NE(image.At(left + 2, kHeight / 2), kWhite);
  EXPECT_EQ(image.At(left + 20, top - 2), kWhite);
  EXPECT_NE(image.At(left + 20, top + 2), kWhite);
  EXPECT_EQ(image.At(0, 0), kWhite);
  // Colours follow the distance in hue.
  const Colormap colormap;
  for (const double t : {0.07, 0.28, 0.53, 0.72, 0.97}) {
    const auto x = static_cast<int>(at.left + t * (at.side));
    const Rgb8 pixel = image.At(x, kHeight / 2);
    // Shading scales all channels alike; at the centre of a pixel the distance
    // is that of its position.
    const LinearColor expected = colormap.At((x + 0.5 - at.left) / (at.side));
    const double scale = LinearFromSrgb(pixel.green / 255.0) / expected.green;
    EXPECT_NEAR(LinearFromSrgb(pixel.red / 255.0), scale * expected.red, 0.02)
        << t;
    EXPECT_NEAR(LinearFromSrgb(pixel.blue / 255.0), scale * expected.blue, 0.02)
        << t;
    EXPECT_GT(scale, 0.6);
    EXPECT_LE(scale, 1.1);
  }
  // Labelled lines at multiples of 0.2, others at multiples of 0.05.
  for (const double labelled : {0.2, 0.4, 0.6, 0.8}) {
    const int line = Brightness(at.Pixel(image, labelled, 0.5));
    const int minor = Brightness(at.Pixel(image, labelled + 0.05, 0.5));
    const int between = Brightness(at.Pixel(image, labelled + 0.025, 0.5));
    EXPECT_LT(line, 0.6 * between) << labelled;
    EXPECT_LT(minor, 0.9 * between) << labelled;
    EXPECT_LT(line, minor) << labelled;
  }
  // The bar goes from dark to light: the first column right of the mesh that is
  // not white.
  const auto bar_bottom = static_cast<int>(0.87 * kHeight);
  const auto bar_top = static_cast<int>(0.17 * kHeight);
  int x = static_cast<int>(at.left + at.side) + 3;
  while (x < kWidth && image.At(x, bar_bottom) == kWhite) ++x;
  ASSERT_LT(x, kWidth);
  x += 3;
  EXPECT_GT(Brightness(image.At(x, bar_top)),
            Brightness(image.At(x, bar_bottom)) + 150);
}

TEST(PictureTest, UnreachablePartsAreGrey) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const Pixels image =
      RenderField(Quad(), {kInfinity, kInfinity, 1, kInfinity});
  const Placement at;
  const Rgb8 pixel = image.At(static_cast<int>(at.left) + 20, kHeight / 2);
  EXPECT_EQ(pixel.red, pixel.green);
  EXPECT_EQ(pixel.green, pixel.blue);
  EXPECT_GT(pixel.red, 120);
  EXPECT_LT(pixel.red, 230);
}

bool IsRed(const Rgb8& pixel) {
  return pixel.red > 180 && pixel.green < 80 && pixel.blue < 80;
}

TEST(PictureTest, HiddenSourcesAreRingsAndToldSo) {
  // The middle of the quad is behind vertex 5 and in front of vertex 6.
  MeshArrays mesh = Quad();
  mesh.positions.push_back({0.5, 0.5, 0.0});
  mesh.positions.push_back({0.5, 0.5, -0.9});
  mesh.triangles.push_back({5, 5, 5});
  mesh.triangles.push_back({4, 4, 4});
  const std::vector<double> distances = {0.4, 1, 0.4, 1, 0, 0};
  const Placement at;
  const auto x = static_cast<int>(at.left + at.side / 2);
  const int y = kHeight / 2;
  const auto red_around = [&](const Pixels& image) {
    return image.Count(x - 4, y - 4, x + 5, y + 5, IsRed);
  };
  const auto legend = [](const Pixels& image) {
    const int top = kHeight - static_cast<int>(0.05 * kHeight) + 1;
    return image.Count(0, top, kWidth, kHeight,
                       [](const Rgb8& pixel) { return pixel != kWhite; });
  };
  const Pixels none = RenderField(mesh, distances);
  const Pixels seen = RenderField(mesh, distances, {mesh.positions[4]});
  const Pixels hidden = RenderField(mesh, distances, {mesh.positions[5]});
  EXPECT_TRUE(IsRed(seen.At(x, y)));
  // Hollow: the surface is seen through the ring.
  EXPECT_EQ(hidden.At(x, y), none.At(x, y));
  EXPECT_FALSE(hidden == none);
  EXPECT_LT(red_around(hidden), red_around(seen));
  // "source", and the longer "source (hidden)".
  EXPECT_EQ(legend(none), 0);
  EXPECT_GT(legend(seen), 50);
  EXPECT_GT(legend(hidden), 1.5 * legend(seen));
}

TEST(PictureTest, AnyMagnitudeIsDrawn) {
  // The pictures do not depend on the unit.
  const Pixels unit = RenderField(Quad(), {0, 1, 0, 1});
  for (const double scale : {1e-300, 1e300}) {
    MeshArrays mesh = Quad();
    for (Point& point : mesh.positions) {
      for (double& coordinate : point) coordinate *= scale;
    }
    const Pixels scaled = RenderField(mesh, {0, scale, 0, scale});
    const auto x = static_cast<int>(Placement().left) + 25;
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
  const Pixels with =
      RenderField(mesh, {0, 1, 0, 1, kInfinity}, {mesh.positions[4]}, options);
  const Pixels without = RenderField(Quad(), {0, 1, 0, 1}, {}, options);
  EXPECT_TRUE(with == without);
  // The view is chosen so that it shows.
  EXPECT_NE(without.At(2 * kWidth / 5, kHeight / 2), kWhite);
}

TEST(PictureTest, NothingToSeeIsStillAPicture) {
  EXPECT_EQ(RenderField({}, {}).width(), kWidth);
  EXPECT_EQ(RenderField({{{0, 0, 0}}, {}}, {0}, {{0, 0, 0}}).height(), kHeight);
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
  const Pixels image = Draw(mesh, {.bold_lines = {line}}, FromTheFront());
  const auto pixel = [&](double x, double y) {
    return Placement(/*key=*/0).Pixel(image, x, y);
  };
  EXPECT_GT(pixel(0.3, 0.5).red, pixel(0.3, 0.5).green + 100);
  EXPECT_LT(pixel(0.3, 0.6).red, pixel(0.3, 0.6).green + 40);
  EXPECT_GT(pixel(0.7, 0.5).red, pixel(0.7, 0.5).green + 15);
  EXPECT_LT(pixel(0.7, 0.5).red, pixel(0.7, 0.5).green + 70);
  EXPECT_LT(pixel(0.05, 0.5).red, pixel(0.05, 0.5).green + 40);
}

TEST(PictureTest, ClosedLinesComeBack) {
  PictureLine line = {.points = {{0.2, 0.2, 0}, {0.8, 0.2, 0}, {0.5, 0.8, 0}}};
  const Pixels open = Draw(Quad(), {.thin_lines = {line}}, FromTheFront());
  line.is_closed = true;
  const Pixels closed = Draw(Quad(), {.thin_lines = {line}}, FromTheFront());
  // In the middle of the closing side.
  const Placement at(/*key=*/0);
  EXPECT_LT(Brightness(at.Pixel(closed, 0.35, 0.5)),
            Brightness(at.Pixel(open, 0.35, 0.5)) - 100);
}

// A flat square, and the distances and numbers of those of two sources that are
// nearest.
struct TwoCells {
  explicit TwoCells(uint32_t cells) : mesh(PlanarGrid(cells)) {
    for (const Point& point : mesh.positions) {
      const double first = std::hypot(point[0] - 0.1, point[1] - 0.2);
      const double second = std::hypot(point[0] - 0.8, point[1] - 0.9);
      distances.push_back(std::min(first, second));
      nearest.push_back(first <= second ? 0 : 1);
    }
  }

  MeshArrays mesh;
  std::vector<double> distances;
  std::vector<uint32_t> nearest;
};

TEST(PictureTest, CellsHaveStraightBordersAndALegend) {
  const TwoCells two(9);
  const Pixels image = Draw(two.mesh,
                            {.distances = two.distances,
                             .nearest_sources = two.nearest,
                             .source_names = {"first", "second"}},
                            FromTheFront());
  const Placement at;
  const auto pixel = [&](double x, double y) { return at.Pixel(image, x, y); };
  const Rgb8 first = pixel(0.2, 0.25);
  const Rgb8 second = pixel(0.75, 0.8);
  EXPECT_NE(first, second);
  // As far from both: x + y = 1.
  for (const double x : {0.05, 0.11, 0.23, 0.38, 0.5, 0.61, 0.77, 0.94}) {
    const double off = 2.5 / at.side;  // pixels on either side
    EXPECT_EQ(pixel(x - off, 1 - x), first) << x;
    EXPECT_EQ(pixel(x + off, 1 - x), second) << x;
  }
  // Both colours stand at the right too. Shading scales all channels alike.
  const auto like = [&](const Rgb8& color) {
    const auto ratio = [](uint8_t p, uint8_t q) {
      return LinearFromSrgb(p / 255.0) / LinearFromSrgb(q / 255.0);
    };
    return image.Count(
        static_cast<int>(at.left + at.side) + 5, 0, kWidth, kHeight,
        [&](const Rgb8& p) {
          const double red = ratio(p.red, color.red);
          return std::abs(ratio(p.green, color.green) / red - 1) < 0.03 &&
                 std::abs(ratio(p.blue, color.blue) / red - 1) < 0.03;
        });
  };
  EXPECT_GT(like(first), 40);
  EXPECT_GT(like(second), 40);
}

TEST(PictureTest, LongNamesOfSourcesEndInAnEllipsis) {
  Image image(kWidth, kHeight);
  const std::string name = "face:12345@0.25,0.5,0.25:0.125";
  EXPECT_EQ(image.Shortened(name, 1000, 20), name);
  const std::string shortened = image.Shortened(name, 100, 20);
  EXPECT_THAT(shortened, AllOf(StartsWith("face:1"), EndsWith("…")));
  EXPECT_LE(image.DrawText(shortened, 0, 20, 20), 100);
  EXPECT_GT(image.DrawText(shortened, 0, 20, 20), 70);

  // Nothing of the legend reaches the picture's right edge.
  const TwoCells two(3);
  const Pixels cells = Draw(two.mesh,
                            {.distances = two.distances,
                             .nearest_sources = two.nearest,
                             .source_names = {name, "0;" + name + ";" + name}},
                            FromTheFront());
  EXPECT_EQ(cells.Count(kWidth - 3, 0, kWidth, kHeight,
                        [](const Rgb8& pixel) { return pixel != kWhite; }),
            0);
}

TEST(PictureTest, PicturesTooNarrowForAKeyHaveNone) {
  PictureOptions options = FromTheFront();
  options.width = 100;
  const Pixels image =
      Draw(Quad(), {.distances = std::vector<double>{0, 1, 0, 1}}, options);
  // The mesh is in the middle.
  const auto left = image.At(15, kHeight / 2);
  EXPECT_NE(left, kWhite);
  EXPECT_NE(image.At(84, kHeight / 2), kWhite);
  EXPECT_EQ(image.At(97, kHeight / 2), kWhite);
}

}  // namespace
}  // namespace geodesic::client
