// Who keeps ties, which no distance tells. All else about trimming shows in
// distances (tests/core/exactness).

#include "solver/rules/trimming.h"

#include "gtest/gtest.h"

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

}  // namespace
}  // namespace geodesic
