// Crossings around a face joined, with the regions given.

#include "questions/isolines/face_regions.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace geodesic {
namespace {

using testing::Eq;
using testing::Optional;

// `count` crossings at 0.25, 0.5, ... with the numbers 10, 11, ...
std::vector<PerimeterCrossing> Crossings(uint32_t count) {
  std::vector<PerimeterCrossing> crossings;
  for (uint32_t i = 0; i < count; ++i) {
    crossings.push_back({0.25 * (i + 1), 10 + i});
  }
  return crossings;
}

TEST(FaceRegions, FindsTheArcOfAPlace) {
  const FaceRegions beyond(Crossings(4), false);
  EXPECT_EQ(beyond.ArcAt(0.1), std::nullopt);
  EXPECT_THAT(beyond.ArcAt(0.3), Optional(Eq(0u)));
  EXPECT_EQ(beyond.ArcAt(0.6), std::nullopt);
  EXPECT_THAT(beyond.ArcAt(0.9), Optional(Eq(1u)));
  EXPECT_EQ(beyond.ArcAt(2.5), std::nullopt);
  const FaceRegions nearer(Crossings(4), true);
  EXPECT_THAT(nearer.ArcAt(0.1), Optional(Eq(0u)));
  EXPECT_EQ(nearer.ArcAt(0.3), std::nullopt);
  EXPECT_THAT(nearer.ArcAt(0.6), Optional(Eq(1u)));
  EXPECT_EQ(nearer.ArcAt(0.9), std::nullopt);
  EXPECT_THAT(nearer.ArcAt(2.5), Optional(Eq(0u)));
}

TEST(FaceRegions, IsolinesLeadAroundRegions) {
  struct Case {
    const char* what;
    uint32_t crossings;
    bool starts_nearer;
    std::vector<std::pair<size_t, size_t>> joined_arcs;
    std::vector<std::pair<uint32_t, uint32_t>> segments;
  };
  for (const Case& c : std::vector<Case>{
           // 10 enters what is nearer and 11 leaves it.
           {"near side on the left", 2, false, {}, {{11, 10}}},
           {"near side on the left", 2, true, {}, {{10, 11}}},
           {"cut off one by one", 4, false, {}, {{11, 10}, {13, 12}}},
           {"cut off one by one", 4, true, {}, {{10, 13}, {12, 11}}},
           {"cut off what is between",
            4,
            false,
            {{1, 0}},
            {{11, 12}, {13, 10}}},
           {"cut off what is between", 4, true, {{0, 1}}, {{10, 11}, {12, 13}}},
           {"one apart from two",
            6,
            false,
            {{0, 2}},
            {{11, 14}, {13, 12}, {15, 10}}},
           // Two regions that hang together across each other are one.
           {"interleaved",
            8,
            false,
            {{0, 2}, {1, 3}},
            {{11, 12}, {13, 14}, {15, 16}, {17, 10}}},
           {"nested",
            8,
            false,
            {{0, 3}, {1, 2}},
            {{11, 16}, {13, 14}, {15, 12}, {17, 10}}}}) {
    FaceRegions regions(Crossings(c.crossings), c.starts_nearer);
    for (const auto& [arc, other] : c.joined_arcs) regions.Join(arc, other);
    std::vector<std::pair<uint32_t, uint32_t>> segments;
    for (const auto& [from, to] : regions.Segments()) {
      segments.emplace_back(from, to);
    }
    EXPECT_EQ(segments, c.segments) << c.what;
  }
}

TEST(FaceRegions, JoiningJoinsWholeRegions) {
  FaceRegions regions(Crossings(8), false);
  regions.Join(0, 1);
  regions.Join(2, 3);
  regions.Join(2, 0);
  for (size_t arc = 1; arc < 4; ++arc) EXPECT_TRUE(regions.AreJoined(0, arc));
}

}  // namespace
}  // namespace geodesic
