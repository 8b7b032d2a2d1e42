#include "solver/rules/trimming.h"

#include <cmath>
#include <random>

#include "gtest/gtest.h"

namespace geodesic {
namespace {

long double Distance(const Origin& origin, long double x) {
  return origin.sigma + std::hypot(x - static_cast<long double>(origin.x),
                                   static_cast<long double>(origin.depth));
}

Interval Won(const Origin& older, const Origin& newer,
             const Interval& overlap) {
  return WonByNewer(Window::Over(overlap, older), Window::Over(overlap, newer));
}

TEST(TrimmingTest, TheOlderKeepsTies) {
  const Origin origin{.x = 0.3, .depth = 1, .sigma = 2};
  EXPECT_EQ(Won(origin, origin, {0, 1}).width(), 0);
}

// Of two in one line the first keeps all, whoever came first: paths by way of
// the second are as long.
TEST(TrimmingTest, TheLesserSigmaTakesTies) {
  const Origin first{.x = 0.25, .depth = 4, .sigma = 1},
      second{.x = 0.25, .depth = 1, .sigma = 4};
  const Interval overlap{0.25 - 1e-9, 0.25 + 1e-9};
  EXPECT_EQ(Won(second, first, overlap).width(), overlap.width());
  EXPECT_EQ(Won(first, second, overlap).width(), 0);
  // But nothing where it is farther.
  const Origin nearer{.x = 0.25, .depth = 1, .sigma = 3.9};
  EXPECT_EQ(Won(nearer, first, overlap).width(), 0);
}

TEST(TrimmingTest, MirrorImagesShareTheEdgeInItsMiddle) {
  const Origin left{.x = 0, .depth = 1}, right{.x = 1, .depth = 1};
  const Interval won = Won(left, right, {0, 1});
  EXPECT_NEAR(won.begin, 0.5, 1e-15);
  EXPECT_EQ(won.end, 1);
}

TEST(TrimmingTest, ANearerWindowTakesAll) {
  const Origin far{.x = 0.5, .depth = 2}, near{.x = 0.4, .depth = 1};
  EXPECT_EQ(Won(far, near, {0.1, 0.9}).width(), 0.8);
  EXPECT_EQ(Won(near, far, {0.1, 0.9}).width(), 0);
}

TEST(TrimmingTest, OnlyTheOverlapIsContested) {
  const Origin far{.x = 0.5, .depth = 2}, near{.x = 0.5, .depth = 1};
  const Interval won =
      WonByNewer(Window::Over({0, 0.6}, far), Window::Over({0.4, 1}, near));
  EXPECT_EQ(won.begin, 0.4);
  EXPECT_EQ(won.end, 0.6);
}

TEST(TrimmingTest, CuttingAWindowKeepsItsDistancesRight) {
  const Origin origin{.x = 0.25, .depth = 0.5, .sigma = 3};
  Window window = Window::Over({0, 1}, origin);
  EXPECT_EQ(window.Label(), 3.5);
  window.CutTo({0.5, 1});
  EXPECT_EQ(window.begin_distance, window.DistanceTo(0.5));
  EXPECT_EQ(window.end_distance, window.DistanceTo(1));
  EXPECT_EQ(window.Label(), window.begin_distance);
}

// Random pairs: the newer is nearer within what it won and nowhere else, and
// where they change over the two distances agree.
TEST(TrimmingTest, RandomPairsChangeOverWhereTheyAreEqual) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> unit(0, 1);
  int crossings = 0;
  for (int i = 0; i < 20000; ++i) {
    const Origin older{.x = 4 * unit(random) - 2,
                       .depth = std::pow(10, -6 * unit(random)),
                       .sigma = unit(random)};
    const Origin newer{.x = 4 * unit(random) - 2,
                       .depth = std::pow(10, -6 * unit(random)),
                       .sigma = unit(random)};
    const Interval overlap{0, 1};
    // Only pairs that can meet on an edge: the line through both sources must
    // not cross it (see WonByNewer).
    const double at = older.x + (newer.x - older.x) * older.depth /
                                    (older.depth - newer.depth);
    if (at > 0 && at < 1) continue;
    const Interval won = Won(older, newer, overlap);
    for (double x : {0.0, 0.125, 0.25, 0.5, 0.75, 0.875, 1.0}) {
      const long double difference = Distance(newer, x) - Distance(older, x);
      if (std::abs(difference) < 1e-13L) continue;
      EXPECT_EQ(difference < 0,
                x >= won.begin && x <= won.end && won.width() > 0)
          << "case " << i << " at " << x;
    }
    if (won.width() > 0 && won.width() < 1) {
      ++crossings;
      const double x = won.begin > 0 ? won.begin : won.end;
      EXPECT_NEAR(static_cast<double>(Distance(newer, x) - Distance(older, x)),
                  0, 1e-13)
          << "case " << i;
    }
  }
  EXPECT_GT(crossings, 1000);
}

}  // namespace
}  // namespace geodesic
