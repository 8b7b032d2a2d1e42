// Crossings around a face joined, with the regions given.

#include "questions/isolines/face_regions.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

namespace geodesic {

inline bool operator==(const Segment& a, const Segment& b) {
  return a.from == b.from && a.to == b.to;
}
inline void PrintTo(const Segment& segment, std::ostream* out) {
  *out << segment.from << " -> " << segment.to;
}

namespace {

using testing::ElementsAre;
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

TEST(FaceRegions, TwoCrossingsAreJoinedWithTheNearSideOnTheLeft) {
  // 10 enters what is nearer and 11 leaves it.
  EXPECT_THAT(FaceRegions(Crossings(2), false).Segments(),
              ElementsAre(Segment{11, 10}));
  EXPECT_THAT(FaceRegions(Crossings(2), true).Segments(),
              ElementsAre(Segment{10, 11}));
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

TEST(FaceRegions, ArcsApartAreCutOffOneByOne) {
  EXPECT_THAT(FaceRegions(Crossings(4), false).Segments(),
              ElementsAre(Segment{11, 10}, Segment{13, 12}));
  EXPECT_THAT(FaceRegions(Crossings(4), true).Segments(),
              ElementsAre(Segment{10, 13}, Segment{12, 11}));
}

TEST(FaceRegions, ArcsThatHangTogetherCutOffWhatIsBetween) {
  FaceRegions beyond(Crossings(4), false);
  beyond.Join(1, 0);
  EXPECT_THAT(beyond.Segments(), ElementsAre(Segment{11, 12}, Segment{13, 10}));
  FaceRegions nearer(Crossings(4), true);
  nearer.Join(0, 1);
  EXPECT_THAT(nearer.Segments(), ElementsAre(Segment{10, 11}, Segment{12, 13}));
}

TEST(FaceRegions, OneArcMayStayApartFromTwo) {
  FaceRegions regions(Crossings(6), false);
  regions.Join(0, 2);
  EXPECT_THAT(regions.Segments(),
              ElementsAre(Segment{11, 14}, Segment{13, 12}, Segment{15, 10}));
}

TEST(FaceRegions, JoiningJoinsWholeRegions) {
  FaceRegions regions(Crossings(8), false);
  regions.Join(0, 1);
  regions.Join(2, 3);
  regions.Join(2, 0);
  for (size_t arc = 1; arc < 4; ++arc) EXPECT_TRUE(regions.AreJoined(0, arc));
}

// Two regions that hang together across each other are one.
TEST(FaceRegions, InterleavedRegionsAreJoined) {
  FaceRegions regions(Crossings(8), false);
  regions.Join(0, 2);
  regions.Join(1, 3);
  EXPECT_THAT(regions.Segments(),
              ElementsAre(Segment{11, 12}, Segment{13, 14}, Segment{15, 16},
                          Segment{17, 10}));
}

TEST(FaceRegions, NestedRegionsStayApart) {
  FaceRegions regions(Crossings(8), false);
  regions.Join(0, 3);
  regions.Join(1, 2);
  EXPECT_THAT(regions.Segments(),
              ElementsAre(Segment{11, 16}, Segment{13, 14}, Segment{15, 12},
                          Segment{17, 10}));
}

}  // namespace
}  // namespace geodesic
