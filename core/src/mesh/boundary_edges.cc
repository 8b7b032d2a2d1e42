#include "mesh/boundary_edges.h"

#include <algorithm>
#include <cstddef>

namespace geodesic {
namespace {

// Spreads a number over 64 bits (the finalizer of splitmix64).
uint64_t Mixed(uint64_t x) {
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

// Whether a vertex may be at the boundary. Where the faces around it close,
// each neighbour follows in one and precedes in another, and what they add up
// to is 0. Elsewhere it is not, but for one chance in 2^64.
std::vector<bool> MayBeAtBoundary(const TriangleSoup& soup) {
  std::vector<uint64_t> balance(soup.positions.size(), 0);
  for (const Triangle& corners : soup.triangles) {
    if (RepeatsVertex(corners)) continue;
    const uint64_t a = Mixed(corners[0]), b = Mixed(corners[1]),
                   c = Mixed(corners[2]);
    balance[corners[0]] += b - c;
    balance[corners[1]] += c - a;
    balance[corners[2]] += a - b;
  }
  std::vector<bool> may_be(balance.size());
  for (size_t v = 0; v < balance.size(); ++v) may_be[v] = balance[v] != 0;
  return may_be;
}

}  // namespace

BoundaryEdges FindBoundaryEdges(const TriangleSoup& soup) {
  const std::vector<bool> may_be = MayBeAtBoundary(soup);
  BoundaryEdges found;
  for (const Triangle& corners : soup.triangles) {
    if (RepeatsVertex(corners)) continue;
    for (int i = 0; i < 3; ++i) {
      const uint32_t a = corners[i], b = corners[(i + 1) % 3];
      if (may_be[a] && may_be[b]) {
        found.around.push_back({std::min(a, b), std::max(a, b)});
      }
    }
  }
  std::ranges::sort(found.around);
  const auto& sides = found.around;
  for (size_t i = 0; i < sides.size();) {
    size_t end = i + 1;
    while (end < sides.size() && sides[end] == sides[i]) ++end;
    if (end - i == 1) found.edges.push_back(sides[i]);
    i = end;
  }
  found.around.erase(std::unique(found.around.begin(), found.around.end()),
                     found.around.end());
  return found;
}

}  // namespace geodesic
