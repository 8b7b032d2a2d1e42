#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "geodesic/rows/matrix.h"

namespace geodesic {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

DistanceRow Filtered(const RowFilter& filter, std::vector<double> values) {
  DistanceRow row{.values = std::move(values)};
  filter.Apply(row);
  return row;
}

TEST(RowFilterTest, WhatIsBeyondTheRadiusIsInfinite) {
  const DistanceRow row = Filtered({.radius = 2}, {3, kInfinity, 2, 1});
  EXPECT_TRUE(row.columns.empty());
  EXPECT_EQ(row.values, (std::vector<double>{kInfinity, kInfinity, 2, 1}));
  EXPECT_EQ(row.bytes(), 4 * sizeof(double));
}

TEST(RowFilterTest, SparseRowsListWhatIsFinite) {
  const DistanceRow row =
      Filtered({.radius = 2, .sparse = true}, {3, kInfinity, 2, 1});
  EXPECT_EQ(row.columns, (std::vector<uint32_t>{2, 3}));
  EXPECT_EQ(row.values, (std::vector<double>{2, 1}));
  EXPECT_EQ(row.bytes(), 2 * (sizeof(double) + sizeof(uint32_t)));
}

TEST(RowFilterTest, NearestComeInOrderAndEqualOnesByNumber) {
  const std::vector<double> values{3, kInfinity, 1, 2, 1};
  const auto nearest = [&](uint64_t count) {
    return Filtered({.nearest = count}, values).columns;
  };
  EXPECT_EQ(nearest(1), (std::vector<uint32_t>{2}));
  EXPECT_EQ(nearest(3), (std::vector<uint32_t>{2, 4, 3}));
  EXPECT_EQ(nearest(9), (std::vector<uint32_t>{2, 4, 3, 0}));
  EXPECT_EQ(Filtered({.nearest = 3}, values).values,
            (std::vector<double>{1, 1, 2}));
  EXPECT_TRUE(Filtered({.nearest = 9}, {}).values.empty());
}

}  // namespace
}  // namespace geodesic
