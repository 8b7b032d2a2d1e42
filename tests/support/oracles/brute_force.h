// Oracle: geodesic distances on a small mesh, by unfolding every face sequence
// that a straight line can take.
//
// A shortest path is a chain of straight pieces, each a straight line through
// unfolded faces, that bends at vertices only. So (1) from each vertex and each
// point of interest every sequence of faces is unfolded along which some ray
// runs, and each of them that a ray meets gives a direct distance; (2) Dijkstra
// runs over all direct distances. Nothing is assumed about which vertices are
// pseudo-sources and no window is compared with another. The only pruning is by
// length: a window is given up when nothing behind it can be reached in less
// than a known path. Edges may have any number of faces: rays run into each of
// them. Distances from a curve are direct distances of its straight pieces from
// everywhere else, the other way round.
//
// In long double throughout: relative errors are near 1e-17 on ordinary faces.

#ifndef GEODESIC_TESTS_SUPPORT_ORACLES_BRUTE_FORCE_H_
#define GEODESIC_TESTS_SUPPORT_ORACLES_BRUTE_FORCE_H_

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "geodesic/query.h"
#include "geodesic/triangle_soup.h"
#include "tests/support/vec.h"

namespace geodesic::test {

class BruteForce {
 public:
  // Unfolds from every vertex and every point. `curves` are sources that are
  // curves. Meant for up to some hundred
  // faces; on long thin ones even those may take for ever, so that it gives up
  // after `most_windows`.
  explicit BruteForce(
      const TriangleSoup& soup, const std::vector<SurfacePoint>& points = {},
      const std::vector<Source>& curves = {},
      uint64_t most_windows = std::numeric_limits<uint64_t>::max());

  // False if it has given up: then it knows nothing.
  bool is_complete() const { return is_complete_; }

  // One distance per vertex, then one per point, +infinity where no path leads.
  // REQUIRES: every source is at a vertex or at one of the points.
  std::vector<double> Distances(std::span<const Source> sources) const;
  std::vector<double> Distances(uint32_t source) const;
  // The same with all of the curves as sources too.
  std::vector<double> DistancesFromAll(std::span<const Source> sources) const;

 private:
  uint32_t NodeAt(const SurfacePoint& point) const;
  std::vector<Real> Seeds(std::span<const Source> sources) const;
  std::vector<double> Spread(std::vector<Real> distances) const;

  uint32_t vertex_count_;
  bool is_complete_ = true;
  std::vector<SurfacePoint> points_;
  std::vector<double> curve_offsets_;
  // Nodes are the vertices, then the points. direct_[v][w] is the least length
  // of a straight line, or an edge, from node v to node w.
  std::vector<std::vector<Real>> direct_;
  // The same from node v to the straight pieces of each curve.
  std::vector<std::vector<Real>> to_curves_;
};

}  // namespace geodesic::test

#endif  // GEODESIC_TESTS_SUPPORT_ORACLES_BRUTE_FORCE_H_
