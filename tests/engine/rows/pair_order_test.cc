#include "server/engine/rows/pair_order.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <utility>
#include <vector>

namespace geodesic::server {
namespace {

AnswerRow Row(std::vector<uint32_t> pairs, std::vector<double> distances) {
  return {{.columns = std::move(pairs), .values = std::move(distances)}, {}};
}

TEST(PairOrder, GivesDistancesInOrderWithoutGaps) {
  PairOrder order(4);
  const auto known = [&] {
    return std::vector(order.known().begin(), order.known().end());
  };
  EXPECT_EQ(known(), std::vector<double>());
  order.Add(Row({1, 3}, {10, 30}));
  EXPECT_EQ(known(), std::vector<double>());
  order.Add(Row({0}, {0}));
  EXPECT_EQ(known(), (std::vector<double>{0, 10}));
  EXPECT_FALSE(order.is_whole());
  order.Add(Row({2}, {20}));
  EXPECT_EQ(known(), (std::vector<double>{0, 10, 20, 30}));
  EXPECT_TRUE(order.is_whole());
}

}  // namespace
}  // namespace geodesic::server
