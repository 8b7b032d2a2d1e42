// Oracle: geodesic distances between the vertices of a small mesh, by
// unfolding every face sequence that a straight line can take.
//
// A shortest path is a chain of straight pieces, each a straight line through
// unfolded faces, that bends at vertices only. So (1) from each vertex every
// sequence of faces is unfolded along which some ray runs, and each vertex
// that a ray meets gives a direct distance; (2) Dijkstra runs over all direct
// distances. Nothing is assumed about which vertices are pseudo-sources and no
// window is compared with another. The only pruning is by length: a window is
// given up when no vertex behind it can be reached in less than a known path.
//
// In long double throughout: relative errors are near 1e-17 on ordinary faces.

#ifndef GEODESIC_TESTS_SUPPORT_BRUTE_FORCE_H_
#define GEODESIC_TESTS_SUPPORT_BRUTE_FORCE_H_

#include <cstdint>
#include <span>
#include <vector>

#include "geodesic/query.h"
#include "geodesic/triangle_soup.h"
#include "tests/support/vec.h"

namespace geodesic::test {

class BruteForce {
 public:
  // Unfolds from every vertex. Meant for up to some hundred faces.
  explicit BruteForce(const TriangleSoup& soup);

  // One distance per vertex, +infinity where no path leads.
  std::vector<double> Distances(std::span<const Source> sources) const;
  std::vector<double> Distances(uint32_t source) const;

 private:
  // direct_[v][w]: the least length of a straight line, or an edge, from v
  // to w.
  std::vector<std::vector<Real>> direct_;
};

}  // namespace geodesic::test

#endif  // GEODESIC_TESTS_SUPPORT_BRUTE_FORCE_H_
