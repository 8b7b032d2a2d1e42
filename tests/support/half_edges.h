// Connectivity of a triangle soup for the oracles, worked out apart from
// geodesic::Mesh, which is under test. Half-edge 3f + i is side i of face f,
// from corner i to corner i + 1.

#ifndef GEODESIC_TESTS_SUPPORT_HALF_EDGES_H_
#define GEODESIC_TESTS_SUPPORT_HALF_EDGES_H_

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

#include "geodesic/triangle_soup.h"

namespace geodesic::test {

inline constexpr uint32_t kBorder = 0xffffffffu;

inline uint32_t NextSide(uint32_t h) { return h % 3 == 2 ? h - 2 : h + 1; }
inline uint32_t PreviousSide(uint32_t h) { return h % 3 == 0 ? h + 2 : h - 1; }

class HalfEdges {
 public:
  // Any number of faces may share an edge, in either orientation. `soup` must
  // outlive this object.
  explicit HalfEdges(const TriangleSoup& soup)
      : soup_(soup), others_(3 * soup.triangles.size()) {
    std::map<std::pair<uint32_t, uint32_t>, std::vector<uint32_t>> by_ends;
    for (uint32_t h = 0; h < size(); ++h) {
      by_ends[std::minmax(From(h), To(h))].push_back(h);
    }
    for (const auto& [ends, sides] : by_ends) {
      for (const uint32_t h : sides) {
        std::ranges::copy_if(sides, std::back_inserter(others_[h]),
                             [h](uint32_t other) { return other != h; });
      }
    }
  }

  uint32_t size() const { return static_cast<uint32_t>(others_.size()); }
  uint32_t From(uint32_t h) const { return soup_.triangles[h / 3][h % 3]; }
  uint32_t To(uint32_t h) const { return From(NextSide(h)); }
  uint32_t Opposite(uint32_t h) const { return From(PreviousSide(h)); }

  // The other sides of faces that run along the same edge.
  const std::vector<uint32_t>& Others(uint32_t h) const { return others_[h]; }
  // The only other one, or kBorder.
  // REQUIRES: edges have at most two faces.
  uint32_t Twin(uint32_t h) const {
    return others_[h].empty() ? kBorder : others_[h][0];
  }

 private:
  const TriangleSoup& soup_;
  std::vector<std::vector<uint32_t>> others_;
};

}  // namespace geodesic::test

#endif  // GEODESIC_TESTS_SUPPORT_HALF_EDGES_H_
