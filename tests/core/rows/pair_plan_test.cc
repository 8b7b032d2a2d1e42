#include "rows/pair_plan.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace geodesic {
namespace {

PointPair Vertices(uint32_t source, uint32_t target) {
  return {VertexPoint{source}, VertexPoint{target}};
}

TEST(PairPlan, AFieldAnswersWhatSharesAnEndOnEitherSide) {
  const std::vector<PointPair> pairs = {Vertices(8, 9), Vertices(7, 1),
                                        Vertices(2, 7), Vertices(7, 7)};
  const auto rows = PlanPairs(pairs, {.least_for_field = 3});
  ASSERT_EQ(rows.size(), 2);
  EXPECT_FALSE(rows[0].shared.has_value());
  EXPECT_EQ(rows[0].pairs, std::vector<uint32_t>{0});
  EXPECT_EQ(rows[1].shared, SurfacePoint(VertexPoint{7}));
  EXPECT_EQ(rows[1].pairs, (std::vector<uint32_t>{1, 2, 3}));
}

// The pair of both common ends goes to the more common one, and leaves too few
// to the other.
TEST(PairPlan, CountsAPairOnce) {
  const std::vector<PointPair> pairs = {Vertices(1, 5), Vertices(1, 6),
                                        Vertices(1, 2), Vertices(2, 7)};
  const auto rows = PlanPairs(pairs, {.least_for_field = 2});
  ASSERT_EQ(rows.size(), 2);
  EXPECT_EQ(rows[0].shared, SurfacePoint(VertexPoint{1}));
  EXPECT_EQ(rows[0].pairs, (std::vector<uint32_t>{0, 1, 2}));
  EXPECT_FALSE(rows[1].shared.has_value());
  EXPECT_EQ(rows[1].pairs, std::vector<uint32_t>{3});
}

}  // namespace
}  // namespace geodesic
