// Finds the borders between the cells of sources inside triangles.

#ifndef GEODESIC_CLIENT_PICTURE_NEAREST_CELLS_H_
#define GEODESIC_CLIENT_PICTURE_NEAREST_CELLS_H_

#include <array>
#include <cstdint>
#include <span>
#include <utility>

#include "absl/container/flat_hash_map.h"
#include "client/picture/rasterizer.h"
#include "geodesic_client/mesh.h"

namespace geodesic::client {

// A field holds the distance of each vertex from its nearest source only. In a
// triangle whose corners have different nearest sources, the distances from the
// other corners' sources are needed too. They are found by unfolding triangles,
// as if the distances came from points in their plane. The border between two
// cells is then straight within a triangle, because the squares of distances
// from two points of a plane differ by an affine function.
class NearestCells {
 public:
  // The arguments must outlive the object. Linear in the triangles.
  // REQUIRES: one distance and nearest source per vertex; indices in range.
  NearestCells(const MeshArrays& mesh, std::span<const double> distances,
               std::span<const uint32_t> nearest_sources);

  struct Nearest {
    uint32_t source = 0;
    // The distances of the triangle's corners from that source.
    std::array<double, 3> corner_distances;
  };
  // REQUIRES: the distances of the triangle's corners are finite.
  Nearest At(const Triangle& triangle, const Barycentric& weights) const;

 private:
  using VertexAndSource = std::pair<uint32_t, uint32_t>;

  // The distance from a source to a vertex; +infinity if it is not known.
  double Distance(uint32_t vertex, uint32_t source) const;
  // Updates the distances of the triangle's corners from the sources that are
  // nearest to its other corners.
  void Relax(const Triangle& triangle);
  // The distance from `source` to `vertex`, unfolded over the triangle's other
  // corners `a` and `b`.
  double Unfolded(uint32_t vertex, uint32_t a, uint32_t b,
                  uint32_t source) const;

  const MeshArrays& mesh_;
  std::span<const double> distances_;
  std::span<const uint32_t> nearest_sources_;
  // Distances from sources that are not the vertex's nearest.
  absl::flat_hash_map<VertexAndSource, double> others_;
};

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_PICTURE_NEAREST_CELLS_H_
