// Segments put together into chains.

#include "questions/isolines/chains.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

namespace geodesic {
namespace {

using testing::ElementsAre;

TEST(Chains, NoneOfNothing) { EXPECT_TRUE(ChainSegments(0, {}).empty()); }

TEST(Chains, OpenOnesComeFirst) {
  const std::vector<Segment> segments = {{4, 0},
                                         {0, 2},
                                         {2, 4},  // a loop
                                         {5, 1},
                                         {3, 5}};  // 3 5 1
  const std::vector<Chain> chains = ChainSegments(6, segments);
  ASSERT_EQ(chains.size(), 2u);
  EXPECT_THAT(chains[0].crossings, ElementsAre(3, 5, 1));
  EXPECT_FALSE(chains[0].is_closed);
  EXPECT_THAT(chains[1].crossings, ElementsAre(0, 2, 4));
  EXPECT_TRUE(chains[1].is_closed);
}

TEST(Chains, ALoopOfTwo) {
  const std::vector<Segment> segments = {{0, 1}, {1, 0}};
  const std::vector<Chain> chains = ChainSegments(2, segments);
  ASSERT_EQ(chains.size(), 1u);
  EXPECT_THAT(chains[0].crossings, ElementsAre(0, 1));
  EXPECT_TRUE(chains[0].is_closed);
}

// An edge of three faces: every segment is in one chain, and all end there.
TEST(Chains, EndWhereThreeSegmentsMeet) {
  const std::vector<Segment> segments = {{0, 3}, {3, 1}, {3, 2}};
  const std::vector<Chain> chains = ChainSegments(4, segments);
  ASSERT_EQ(chains.size(), 3u);
  EXPECT_THAT(chains[0].crossings, ElementsAre(0, 3));
  EXPECT_THAT(chains[1].crossings, ElementsAre(3, 1));
  EXPECT_THAT(chains[2].crossings, ElementsAre(3, 2));
}

// Faces that disagree in orientation give segments that run against each other.
TEST(Chains, GoOnThroughSegmentsThatRunTheOtherWay) {
  const std::vector<Segment> segments = {{0, 1}, {2, 1}, {2, 3}};
  const std::vector<Chain> chains = ChainSegments(4, segments);
  ASSERT_EQ(chains.size(), 1u);
  EXPECT_THAT(chains[0].crossings, ElementsAre(0, 1, 2, 3));
  const std::vector<Segment> against = {{1, 0}, {1, 2}};
  const std::vector<Chain> both_ends = ChainSegments(3, against);
  ASSERT_EQ(both_ends.size(), 1u);
  EXPECT_THAT(both_ends[0].crossings, ElementsAre(0, 1, 2));
}

}  // namespace
}  // namespace geodesic
