#include "mesh/split_touching.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "mesh/disjoint_sets.h"

namespace geodesic {
namespace {

// A corner of a face: 3 face + number.
using Corner = uint32_t;

// The corners at each vertex v: corners[begin[v]] up to corners[begin[v + 1]].
struct Corners {
  std::vector<uint32_t> begin;
  std::vector<Corner> corners;
};

Corners CornersByVertex(const TriangleSoup& soup) {
  Corners by_vertex;
  by_vertex.begin.assign(soup.positions.size() + 1, 0);
  for (const Triangle& triangle : soup.triangles) {
    if (RepeatsVertex(triangle)) continue;
    for (const uint32_t v : triangle) ++by_vertex.begin[v + 1];
  }
  for (size_t v = 1; v < by_vertex.begin.size(); ++v) {
    by_vertex.begin[v] += by_vertex.begin[v - 1];
  }
  by_vertex.corners.resize(by_vertex.begin.back());
  std::vector<uint32_t> fill(by_vertex.begin.begin(),
                             by_vertex.begin.end() - 1);
  for (size_t face = 0; face < soup.triangles.size(); ++face) {
    if (RepeatsVertex(soup.triangles[face])) continue;
    for (uint32_t i = 0; i < 3; ++i) {
      by_vertex.corners[fill[soup.triangles[face][i]]++] =
          static_cast<Corner>(3 * face + i);
    }
  }
  return by_vertex;
}

}  // namespace

void SplitTouching(TriangleSoup& soup) {
  const Corners by_vertex = CornersByVertex(soup);
  const auto vertices = static_cast<uint32_t>(soup.positions.size());
  // The other ends of edges at a vertex, each with the number of its corner.
  std::vector<std::pair<uint32_t, uint32_t>> spokes;
  // By corner, what it is to name; written at the end, since spokes are named
  // by the vertices as they were.
  std::vector<std::pair<Corner, uint32_t>> renamed;
  for (uint32_t v = 0; v < vertices; ++v) {
    const uint32_t begin = by_vertex.begin[v];
    const uint32_t count = by_vertex.begin[v + 1] - begin;
    spokes.clear();
    for (uint32_t i = 0; i < count; ++i) {
      const Corner corner = by_vertex.corners[begin + i];
      for (const uint32_t other : soup.triangles[corner / 3]) {
        if (other != v) spokes.emplace_back(other, i);
      }
    }
    std::ranges::sort(spokes);
    DisjointSets fans(count);
    for (size_t i = 1; i < spokes.size(); ++i) {
      if (spokes[i].first != spokes[i - 1].first) continue;
      fans.Join(spokes[i].second, spokes[i - 1].second);
      // Once an edge, from its lower end.
      const bool is_second = i == 1 || spokes[i - 2].first != spokes[i].first;
      soup.reading.seam_edges += is_second && v < spokes[i].first;
    }
    if (count == 0 || fans.count() == 1) continue;
    std::vector<uint32_t> names(count, v);
    for (uint32_t i = 1; i < count; ++i) {
      const uint32_t fan = fans.Find(i);
      if (fan == i) {
        names[i] = static_cast<uint32_t>(soup.positions.size());
        soup.positions.push_back(soup.positions[v]);
      }
      if (fan == 0) continue;
      renamed.emplace_back(by_vertex.corners[begin + i], names[fan]);
    }
  }
  for (const auto& [corner, name] : renamed) {
    soup.triangles[corner / 3][corner % 3] = name;
  }
}

}  // namespace geodesic
