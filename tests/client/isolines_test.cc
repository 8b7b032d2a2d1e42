#include "client/picture/isolines.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace geodesic::client {
namespace {

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

}  // namespace
}  // namespace geodesic::client
