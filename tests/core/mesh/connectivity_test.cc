#include "mesh/connectivity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "tests/support/random.h"

namespace geodesic {
namespace {

// The half-edges of a soup, and what is to be found about them, by looking at
// all pairs.
struct Faces {
  std::vector<Triangle> triangles;
  std::vector<uint32_t> outgoing_begin;
  std::vector<HalfEdge> outgoing;

  uint32_t sides() const { return 3 * triangles.size(); }
  uint32_t From(HalfEdge h) const { return triangles[h / 3][h % 3]; }
  uint32_t To(HalfEdge h) const { return From(Next(h)); }

  // All half-edges at the edge of h.
  std::vector<HalfEdge> HalfEdgesAt(HalfEdge h) const {
    std::vector<HalfEdge> edge;
    for (HalfEdge other = 0; other < sides(); ++other) {
      if (std::minmax({From(other), To(other)}) ==
          std::minmax({From(h), To(h)})) {
        edge.push_back(other);
      }
    }
    return edge;
  }

  // The half-edge that runs the other way, alone beside h; kNoHalfEdge if there
  // is no such one.
  HalfEdge Twin(HalfEdge h) const {
    const std::vector<HalfEdge> edge = HalfEdgesAt(h);
    const HalfEdge other = edge.back() == h ? edge.front() : edge.back();
    return edge.size() == 2 && From(other) != From(h) ? other : kNoHalfEdge;
  }

  bool IsClosedFan(uint32_t v) const {
    std::vector<HalfEdge> around;
    for (HalfEdge h = 0; h < sides(); ++h) {
      if (From(h) == v) around.push_back(h);
    }
    std::vector<HalfEdge> reached;
    for (HalfEdge h = around.empty() ? kNoHalfEdge : around[0];
         h != kNoHalfEdge && std::ranges::count(reached, h) == 0;
         h = Twin(h) == kNoHalfEdge ? kNoHalfEdge : Next(Twin(h))) {
      // Both sides of the face at v.
      if (Twin(h) == kNoHalfEdge || Twin(Prev(h)) == kNoHalfEdge) return false;
      reached.push_back(h);
    }
    return !around.empty() && reached.size() == around.size();
  }
};

Faces RandomFaces(uint32_t vertices, uint32_t faces, test::Random& random) {
  Faces soup;
  while (soup.triangles.size() < faces) {
    const Triangle t = {random.Below(vertices), random.Below(vertices),
                        random.Below(vertices)};
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) {
      soup.triangles.push_back(t);
    }
  }
  for (uint32_t v = 0; v < vertices; ++v) {
    soup.outgoing_begin.push_back(soup.outgoing.size());
    for (HalfEdge h = 0; h < soup.sides(); ++h) {
      if (soup.From(h) == v) soup.outgoing.push_back(h);
    }
  }
  soup.outgoing_begin.push_back(soup.outgoing.size());
  return soup;
}

TEST(ConnectivityTest, IsThatOfLookingAtAllPairs) {
  test::Random random(1);
  uint32_t twins = 0, irregular_edges = 0, closed_fans = 0;
  for (int round = 0; round < 2000; ++round) {
    // A few vertices: closed fans come by chance, and irregular edges all the
    // time.
    const Faces faces = RandomFaces(3 + round % 6, 1 + round % 17, random);
    const Connectivity found = FindConnectivity(
        {faces.triangles, faces.outgoing_begin, faces.outgoing});
    for (HalfEdge h = 0; h < faces.sides(); ++h) {
      const std::vector<HalfEdge> edge = faces.HalfEdgesAt(h);
      const Exit exit = found.exits[h];
      if (edge.size() == 1 || faces.Twin(h) != kNoHalfEdge) {
        ASSERT_EQ(exit, faces.Twin(h)) << "round " << round << ", " << h;
        twins += exit != kNoHalfEdge;
        continue;
      }
      ASSERT_TRUE(exit >= kIrregularExit && exit != kNoHalfEdge)
          << "round " << round << ", " << h;
      const uint32_t* const begin =
          &found.irregular_begin[exit - kIrregularExit];
      ASSERT_EQ(std::vector(found.irregular_half_edges.begin() + begin[0],
                            found.irregular_half_edges.begin() + begin[1]),
                edge);
      ++irregular_edges;
    }
    for (uint32_t v = 0; v + 1 < faces.outgoing_begin.size(); ++v) {
      ASSERT_EQ(found.is_closed_fan[v], faces.IsClosedFan(v))
          << "round " << round << ", vertex " << v;
      closed_fans += found.is_closed_fan[v];
    }
  }
  // Or it has shown nothing.
  EXPECT_GT(twins, 100);
  EXPECT_GT(irregular_edges, 100);
  EXPECT_GT(closed_fans, 100);
}

}  // namespace
}  // namespace geodesic
