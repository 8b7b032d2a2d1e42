#include "tests/reliability/latency_histogram.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace geodesic::client {
namespace {

TEST(LatencyHistogram, QuantilesAreThoseOfTheSortedLatencies) {
  std::mt19937_64 random(1);
  std::exponential_distribution<double> exponent(1.0 / 6);
  // Seen by two, by turns, and put together.
  LatencyHistogram histogram;
  LatencyHistogram other;
  std::vector<double> sorted;
  for (int i = 0; i < 10'000; ++i) {
    // From nanoseconds to seconds.
    const auto nanoseconds =
        static_cast<int64_t>(std::pow(10, std::min(9.5, exponent(random))));
    (i % 2 == 0 ? histogram : other).Add(std::chrono::nanoseconds(nanoseconds));
    sorted.push_back(1e-6 * static_cast<double>(nanoseconds));
  }
  histogram.Add(other);
  EXPECT_EQ(histogram.count(), sorted.size());
  std::ranges::sort(sorted);
  for (const double part : {0.01, 0.1, 0.5, 0.9, 0.99, 0.9999, 1.0}) {
    const double exact =
        sorted[static_cast<size_t>(std::ceil(part * 10'000)) - 1];
    EXPECT_GE(histogram.Milliseconds(part), exact) << part;
    // A nanosecond is the least that it tells apart.
    EXPECT_LE(histogram.Milliseconds(part), exact * (1 + 1.0 / 64) + 1e-6)
        << part;
  }
  EXPECT_EQ(histogram.Milliseconds(1), sorted.back());
}

TEST(LatencyHistogram, NothingSeenIsZero) {
  EXPECT_EQ(LatencyHistogram().count(), 0u);
  EXPECT_EQ(LatencyHistogram().Milliseconds(0.5), 0);
}

}  // namespace
}  // namespace geodesic::client
