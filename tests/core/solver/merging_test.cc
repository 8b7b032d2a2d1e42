// Merged windows keep what they promise (merging.h), seen by sampling.

#include "solver/rules/merging.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/random.h"

namespace geodesic {
namespace {

constexpr double kRounding = 1e-12;

// Two windows that touch at `middle` at one distance. Their rays there part by
// `angle` (converge if negative).
struct Pair {
  Window first, second;
};
Origin From(double at, double distance, double sigma, double angle) {
  // `angle` from the edge's normal; the origin lies behind.
  return {.x = at - distance * std::sin(angle),
          .depth = distance * std::cos(angle),
          .sigma = sigma - distance};
}
Pair DrawPair(test::Random& random, double parting) {
  const double begin = random.Uniform(0, 0.4), end = random.Uniform(0.6, 1);
  const double middle = random.Uniform(0.45, 0.55);
  const double angle = random.Uniform(-1.2, 1.2);
  const double at_middle = random.Uniform(3, 20);
  return {Window::Over({begin, middle},
                       From(middle, random.Uniform(0.2, 10), at_middle, angle)),
          Window::Over({middle, end}, From(middle, random.Uniform(0.2, 10),
                                           at_middle, angle + parting))};
}

double Slope(const Window& window, double at) {
  return (at - window.origin.x) / window.origin.DistanceTo(at);
}

TEST(MergingTest, MergedWindowsCoverMoreAndAreNoFarther) {
  test::Random random(5);
  int found = 0;
  for (int i = 0; i < 20000; ++i) {
    SCOPED_TRACE(i);
    // Rays that coincide, and rays that converge.
    const double parting = i % 2 == 0 ? 0 : -random.Uniform(0, 0.2);
    const auto [first, second] = DrawPair(random, parting);
    MergedWindow merged;
    if (!FindMerged(first, second, 10, merged)) continue;
    ++found;
    const Window& window = merged.window;
    const double begin = first.interval.begin, end = second.interval.end;
    EXPECT_EQ(window.interval.begin, begin);
    EXPECT_EQ(window.interval.end, end);
    EXPECT_NEAR(window.DistanceTo(begin), first.begin_distance, kRounding);
    EXPECT_NEAR(window.DistanceTo(end), second.end_distance, kRounding);
    EXPECT_LE(Slope(window, begin), Slope(first, begin) + kRounding);
    EXPECT_GE(Slope(window, end), Slope(second, end) - kRounding);
    const auto check = [&](const Window& part, double account) {
      double below = 0;
      for (int k = 0; k <= 200; ++k) {
        const double at = part.interval.begin + part.interval.width() * k / 200;
        const double nearer = part.DistanceTo(at) - window.DistanceTo(at);
        EXPECT_GE(nearer, -kRounding);
        below = std::max(below, nearer);
      }
      EXPECT_LE(below, account);
      // And not much less.
      EXPECT_GE(below, 0.99 * account - kRounding);
    };
    check(first, merged.below_first);
    check(second, merged.below_second);
  }
  EXPECT_GT(found, 10000);
}

// Where a source lies right beside a long interval, at its end or within, small
// distances stand beside large ones, and rays to the two ends lean far apart.
TEST(MergingTest, SmallDistancesAreKeptBesideLargeOnes) {
  test::Random random(8);
  int found = 0;
  for (int i = 0; i < 100000; ++i) {
    SCOPED_TRACE(i);
    const double depth = std::pow(10, random.Uniform(-9, -2));
    const double end = random.Uniform(0.1, 1);
    const double beside = i % 2 == 0 ? end : random.Uniform(0, end);
    const Origin origin = {.x = beside + random.Uniform(-3, 3) * depth,
                           .depth = depth};
    const double middle = random.Uniform(0, end);
    const Window first = Window::Over({0, middle}, origin);
    const Window second = Window::Over({middle, end}, origin);
    MergedWindow merged;
    if (!FindMerged(first, second, 1e-12, merged)) continue;
    ++found;
    const double most =
        std::max(merged.below_first, merged.below_second) + 4e-16;
    for (const double at : {0.0, middle, std::clamp(origin.x, 0.0, end), end}) {
      const double nearer =
          origin.DistanceTo(at) - merged.window.DistanceTo(at);
      EXPECT_GE(nearer, -4e-16) << at;
      EXPECT_LE(nearer, most) << at;
      EXPECT_LE(nearer, 1e-14) << at;
    }
  }
  EXPECT_GT(found, 1000);
}

TEST(MergingTest, WhatIsNotOneWavefrontIsNotMerged) {
  test::Random random(6);
  MergedWindow merged;
  for (int i = 0; i < 1000; ++i) {
    auto [first, second] = DrawPair(random, 0);
    Window apart = second;
    apart.CutTo({second.interval.begin + 1e-6, second.interval.end});
    EXPECT_FALSE(FindMerged(first, apart, 10, merged));
    Window late = second;
    late.origin.sigma += 1e-6;
    late = Window::Over(late.interval, late.origin);
    EXPECT_FALSE(FindMerged(first, late, 10, merged));
  }
}

TEST(MergingTest, NoMoreIsSpentThanAllowed) {
  test::Random random(7);
  int found = 0, refused = 0;
  for (int i = 0; i < 1000; ++i) {
    const auto [first, second] = DrawPair(random, 0);
    const double most = std::pow(10, random.Uniform(-6, 0));
    MergedWindow merged;
    if (FindMerged(first, second, most, merged)) {
      ++found;
      EXPECT_LE(std::max(merged.below_first, merged.below_second), most);
    } else if (FindMerged(first, second, 10, merged)) {
      ++refused;
      EXPECT_GT(std::max(merged.below_first, merged.below_second), most);
    }
  }
  EXPECT_GT(found, 50);
  EXPECT_GT(refused, 50);
}

}  // namespace
}  // namespace geodesic
