// The connectivity of soups at random, by looking at all sides of each edge.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <utility>
#include <vector>

#include "geodesic/mesh.h"
#include "tests/support/random.h"

namespace geodesic {
namespace {

// A few vertices: closed fans come by chance, and irregular edges all the time.
TriangleSoup RandomSoup(uint32_t vertices, uint32_t faces,
                        test::Random& random) {
  TriangleSoup soup;
  for (uint32_t v = 0; v < vertices; ++v) {
    soup.positions.push_back(
        {random.Uniform(0, 1), random.Uniform(0, 1), random.Uniform(0, 1)});
  }
  while (soup.triangles.size() < faces) {
    const auto any = [&] { return random.Below(vertices); };
    const Triangle t = {any(), any(), any()};
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) {
      soup.triangles.push_back(t);
    }
  }
  return soup;
}

class Edges {
 public:
  explicit Edges(const Mesh& mesh) : mesh_(mesh) {
    for (HalfEdge h = 0; h < mesh.half_edge_count(); ++h) {
      sides_[Ends(h)].push_back(h);
    }
  }

  // In order of their numbers.
  const std::vector<HalfEdge>& SidesAt(HalfEdge h) const {
    return sides_.at(Ends(h));
  }

  // Whether the faces around v, of which no three share an edge, come one from
  // another across edges at v.
  bool IsOneFan(uint32_t v) const {
    std::set<uint32_t> reached;
    std::vector<HalfEdge> left = {mesh_.Outgoing(v)[0]};
    while (!left.empty()) {
      const HalfEdge h = left.back();
      left.pop_back();
      if (!reached.insert(h / 3).second) continue;
      for (const HalfEdge at_v : {h - h % 3, h - h % 3 + 1, h - h % 3 + 2}) {
        if (mesh_.From(at_v) != v && mesh_.To(at_v) != v) continue;
        const std::vector<HalfEdge>& sides = SidesAt(at_v);
        if (sides.size() > 2) return false;
        left.insert(left.end(), sides.begin(), sides.end());
      }
    }
    return reached.size() == mesh_.Outgoing(v).size();
  }

 private:
  std::pair<uint32_t, uint32_t> Ends(HalfEdge h) const {
    return std::minmax({mesh_.From(h), mesh_.To(h)});
  }

  const Mesh& mesh_;
  std::map<std::pair<uint32_t, uint32_t>, std::vector<HalfEdge>> sides_;
};

TEST(ConnectivityTest, IsThatOfLookingAtAllSides) {
  test::Random random(1);
  uint32_t twins = 0, irregular_edges = 0, fans = 0, pinches = 0;
  for (int round = 0; round < 2000; ++round) {
    SCOPED_TRACE(round);
    const auto mesh =
        *Mesh::Build(RandomSoup(3 + round % 6, 1 + round % 17, random));
    const Edges edges(*mesh);
    for (HalfEdge h = 0; h < mesh->half_edge_count(); ++h) {
      std::vector<HalfEdge> sides = edges.SidesAt(h);
      ASSERT_EQ(mesh->IsBoundaryEdge(h), sides.size() == 1) << h;
      ASSERT_EQ(mesh->IsNonManifoldEdge(h), sides.size() > 2) << h;
      ASSERT_EQ(mesh->FirstOfEdge(h), sides[0]) << h;
      const bool is_regular =
          sides.size() == 2 && mesh->From(sides[0]) != mesh->From(sides[1]);
      ASSERT_EQ(mesh->IsIrregularEdge(h), sides.size() > 1 && !is_regular) << h;
      std::erase(sides, h);
      ASSERT_EQ(mesh->Twin(h), is_regular ? sides[0] : kNoHalfEdge) << h;
      std::vector<HalfEdge> beyond;
      mesh->ForEachBeyond(h, [&](HalfEdge other, bool is_mirrored) {
        beyond.push_back(other);
        EXPECT_EQ(is_mirrored, mesh->From(other) == mesh->From(h)) << h;
      });
      ASSERT_EQ(beyond, sides) << h;
      twins += is_regular;
      irregular_edges += mesh->IsIrregularEdge(h);
    }
    for (uint32_t v = 0; v < mesh->vertex_count(); ++v) {
      if (mesh->Outgoing(v).empty()) continue;
      ASSERT_EQ(mesh->IsNonManifold(v), !edges.IsOneFan(v)) << v;
      ++(mesh->IsNonManifold(v) ? pinches : fans);
    }
  }
  // Or it has shown nothing.
  for (const uint32_t count : {twins, irregular_edges, fans, pinches}) {
    EXPECT_GT(count, 100);
  }
}

}  // namespace
}  // namespace geodesic
