// Which windows are pieces of one: a mistake here shows in distances only where
// many things come together.

#include "solver/trimming/fragments.h"

#include "gtest/gtest.h"

namespace geodesic {
namespace {

Window Over(double begin, double end, const Origin& origin) {
  return Window::Over({begin, end}, origin);
}

// Two in line: what the second sees so near to the line is as far by way of
// either.
constexpr Origin kFirst{.x = 0.5, .depth = 4, .sigma = 1};
constexpr Origin kSecond{.x = 0.5, .depth = 1, .sigma = 4};

TEST(FragmentsTest, WhatIsTiedBetweenTwoPiecesGoes) {
  EXPECT_TRUE(AreFragments(Over(0.1, 0.5, kFirst),
                           Over(0.5, 0.5 + 1e-9, kSecond),
                           Over(0.5 + 1e-9, 0.9, kFirst), 1));
}

// A source before another one, whose offset lets it be nearer by 1e-3 on the
// ray that both share. They are tied where they change over.
TEST(FragmentsTest, WhatIsNearerBetweenTheEndsStays) {
  constexpr Origin kBefore{.x = 0.5, .depth = 1, .sigma = 4 - 1e-3};
  double low = 0, high = 0.2;  // how far from the shared ray
  for (int i = 0; i < 100; ++i) {
    const double middle = (low + high) / 2;
    const bool is_nearer =
        kBefore.PathTo(0.5 + middle) < kFirst.PathTo(0.5 + middle);
    (is_nearer ? low : high) = middle;
  }
  ASSERT_GT(low, 0.05);
  ASSERT_LT(high, 0.06);
  EXPECT_FALSE(AreFragments(Over(0.1, 0.5 - low, kFirst),
                            Over(0.5 - low, 0.5 + low, kBefore),
                            Over(0.5 + low, 0.9, kFirst), 1));
  // Nor does one that is farther there.
  constexpr Origin kFar{.x = 0.5, .depth = 4, .sigma = 1 + 1e-3};
  EXPECT_FALSE(AreFragments(Over(0.1, 0.4, kFirst), Over(0.4, 0.6, kFar),
                            Over(0.6, 0.9, kFirst), 1));
}

TEST(FragmentsTest, PiecesOfOneWindowHaveOneOriginAndNoGap) {
  const Window between = Over(0.5, 0.5 + 1e-9, kSecond);
  Origin turned = kFirst;
  turned.x += 1e-15;
  EXPECT_FALSE(AreFragments(Over(0.1, 0.5, turned), between,
                            Over(0.5 + 1e-9, 0.9, kFirst), 1));
  EXPECT_FALSE(AreFragments(Over(0.1, 0.5 - 1e-6, kFirst), between,
                            Over(0.5 + 1e-9, 0.9, kFirst), 1));
  EXPECT_FALSE(AreFragments(Over(0.1, 0.5, kFirst), between,
                            Over(0.5 + 1e-6, 0.9, kFirst), 1));
}

}  // namespace
}  // namespace geodesic
