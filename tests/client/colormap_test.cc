#include "client/picture/colormap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace geodesic::client {
namespace {

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

TEST(ColormapTest, LightnessRises) {
  const Colormap colormap;
  double before = 0;
  for (int i = 0; i <= 100; ++i) {
    const double lightness = ToOkLab(colormap.At(i / 100.0)).lightness;
    EXPECT_GT(lightness, before) << i;
    before = lightness;
  }
  EXPECT_LT(ToOkLab(colormap.At(0)).lightness, 0.4);
  EXPECT_GT(ToOkLab(colormap.At(1)).lightness, 0.9);
}

TEST(ColormapTest, EqualStepsLookEqual) {
  const Colormap colormap;
  std::vector<double> steps;
  for (int i = 1; i <= 32; ++i) {
    const OkLab a = ToOkLab(colormap.At((i - 1) / 32.0));
    const OkLab b = ToOkLab(colormap.At(i / 32.0));
    steps.push_back(
        std::hypot(a.lightness - b.lightness, a.a - b.a, a.b - b.b));
  }
  const auto [least, most] = std::ranges::minmax(steps);
  EXPECT_LT(most / least, 1.15);
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
}

TEST(ColormapTest, BeyondTheEndsIsTheEnd) {
  const Colormap colormap;
  EXPECT_EQ(colormap.At(-1).red, colormap.At(0).red);
  EXPECT_EQ(colormap.At(2).red, colormap.At(1).red);
}

TEST(OkLabTest, WhiteIsWhite) {
  const LinearColor white = LinearFromOkLab({1, 0, 0});
  EXPECT_NEAR(white.red, 1, 1e-6);
  EXPECT_NEAR(white.green, 1, 1e-6);
  EXPECT_NEAR(white.blue, 1, 1e-6);
}

}  // namespace
}  // namespace geodesic::client
