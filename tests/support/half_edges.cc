#include "tests/support/half_edges.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

namespace geodesic::test {

HalfEdges::HalfEdges(const TriangleSoup& soup)
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

}  // namespace geodesic::test
