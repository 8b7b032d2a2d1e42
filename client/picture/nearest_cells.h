// Where one source's cell ends and another's begins, inside of triangles.

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

// A field tells the distance of each vertex from its nearest source alone. A
// triangle whose corners have different nearest sources needs that from the
// others too: it is found by unfolding triangles, as if the distances came from
// points in their plane. Then the points of a triangle that are as far from two
// sources lie on a straight line, exactly so in a plane, for the squares of
// distances from points differ by an affine function.
class NearestCells {
 public:
  // All must outlive the object. Linear in the triangles.
  // REQUIRES: one distance and nearest source per vertex; indices in range.
  NearestCells(const MeshArrays& mesh, std::span<const double> distances,
               std::span<const uint32_t> nearest_sources);

  struct Nearest {
    uint32_t source = 0;
    // From that source to the triangle's corners.
    std::array<double, 3> corner_distances;
  };
  // REQUIRES: the distances of the triangle's corners are finite.
  Nearest At(const Triangle& triangle, const Barycentric& weights) const;

 private:
  using VertexAndSource = std::pair<uint32_t, uint32_t>;

  // From a source to a vertex; +inf if that is not known.
  double Distance(uint32_t vertex, uint32_t source) const;
  // What the triangle says about the distances of its corners from the sources
  // that are nearest to its other corners.
  void Relax(const Triangle& triangle);
  // Over the triangle's other two corners.
  double Unfolded(uint32_t vertex, uint32_t a, uint32_t b,
                  uint32_t source) const;

  const MeshArrays& mesh_;
  std::span<const double> distances_;
  std::span<const uint32_t> nearest_sources_;
  // Of sources that are not the vertex's nearest.
  absl::flat_hash_map<VertexAndSource, double> others_;
};

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_PICTURE_NEAREST_CELLS_H_
