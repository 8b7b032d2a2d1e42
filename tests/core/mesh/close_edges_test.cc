#include "mesh/close_edges.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "tests/support/checkpoints.h"

namespace geodesic::test {
namespace {

TEST(CloseEdges, AreSoughtWithPollsBeforeTheFirstIsFound) {
  constexpr uint32_t kEdges = 1 << 18;
  std::vector<Point> positions;
  std::vector<VertexPair> edges;
  for (uint32_t i = 0; i < kEdges; ++i) {
    positions.push_back({1.0 * i, 0, 0});
    positions.push_back({1.0 * i, 1, 0});
    edges.push_back({2 * i, 2 * i + 1});
  }
  const Closeness closeness = {.distance = 1e-3, .part = 1};
  RecordingCheckpoint whole;
  ASSERT_TRUE(CloseEdges::Make(positions, edges, closeness, whole).ok());
  const uint64_t polls = whole.polls().size();
  EXPECT_EQ(polls, 2 * (kEdges >> 16));
  for (uint64_t poll = 0; poll < polls; ++poll) {
    RecordingCheckpoint checkpoint(poll);
    EXPECT_EQ(
        CloseEdges::Make(positions, edges, closeness, checkpoint).status(),
        RecordingCheckpoint::Stopped());
  }
}

}  // namespace
}  // namespace geodesic::test
