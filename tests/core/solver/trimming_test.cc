// Who keeps ties, which no distance tells. All else about trimming shows in
// distances (tests/core/exactness).

#include "solver/trimming/trimming.h"

#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include "gtest/gtest.h"
#include "solver/trimming/trimming_kernels.h"
#include "solver/windows/window_columns.h"

namespace geodesic {
namespace {

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

// In the case that FindCrossovers is for: the newer window ends last, and each
// is nearer on its own side. Such pairs are made by their distances at a point
// of the overlap. Where another root lies in the overlap, too, it may leave the
// pair to WonByNewer.
TEST(TrimmingTest, ListsChangeOverWhereWindowsDo) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> unit(0, 1);
  constexpr size_t kPairs = 1000;
  WindowColumns older, newer;
  older.Reserve(kPairs);
  newer.Reserve(kPairs);
  while (older.size < kPairs) {
    const double low = unit(random), high = low + 0.1 + unit(random);
    Origin first{.x = low - unit(random), .depth = 0.1 + unit(random)};
    Origin second{.x = high + unit(random), .depth = 0.1 + unit(random)};
    const double meeting = low + (high - low) * unit(random);
    first.sigma = 2 + second.DistanceTo(meeting) - first.DistanceTo(meeting);
    second.sigma = 2;
    if (first.sigma < 0) continue;
    older.Set(older.size++, Window::Over({low - 0.1, high}, first));
    newer.Set(newer.size++, Window::Over({low, high + 0.1}, second));
  }
  std::vector<double> meetings(kPairs + WindowColumns::kPadding);
  std::vector<std::pair<Window, Window>> pairs;
  for (size_t i = 0; i < kPairs; ++i) {
    pairs.emplace_back(older.At(i), newer.At(i));
  }
  FindCrossovers(older, newer, meetings.data());
  size_t found = 0;
  for (size_t i = 0; i < kPairs; ++i) {
    if (std::isnan(meetings[i])) continue;
    ++found;
    const auto& [first, second] = pairs[i];
    const Interval won = WonByNewer(first, second);
    EXPECT_NEAR(meetings[i], won.begin, 1e-12) << i;
    EXPECT_EQ(won.end, first.interval.end) << i;
    EXPECT_NEAR(first.DistanceTo(won.begin), second.DistanceTo(won.begin),
                1e-12);
    EXPECT_NEAR(older.end_distance[i], first.DistanceTo(won.begin), 1e-12);
    EXPECT_NEAR(newer.begin_distance[i], first.DistanceTo(won.begin), 1e-12);
  }
  EXPECT_GT(found, kPairs / 2);
}

}  // namespace
}  // namespace geodesic
