#include "tests/support/half_edges.h"

#include <cassert>
#include <map>
#include <utility>

namespace geodesic::test {

HalfEdges::HalfEdges(const TriangleSoup& soup)
    : soup_(soup), twins_(3 * soup.triangles.size(), kBorder) {
  std::map<std::pair<uint32_t, uint32_t>, uint32_t> by_ends;
  for (uint32_t h = 0; h < size(); ++h) {
    const bool is_new = by_ends.emplace(std::pair(From(h), To(h)), h).second;
    assert(is_new);
    static_cast<void>(is_new);
    const auto twin = by_ends.find({To(h), From(h)});
    if (twin == by_ends.end()) continue;
    twins_[h] = twin->second;
    twins_[twin->second] = h;
  }
}

}  // namespace geodesic::test
