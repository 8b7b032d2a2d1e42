// The edges of a triangle soup that bound one face.

#ifndef GEODESIC_MESH_BOUNDARY_EDGES_H_
#define GEODESIC_MESH_BOUNDARY_EDGES_H_

#include <cstdint>
#include <vector>

#include "absl/status/statusor.h"
#include "geodesic/checkpoint.h"
#include "geodesic/triangle_soup.h"

namespace geodesic {

struct VertexPair {
  uint32_t low = 0;
  uint32_t high = 0;  // above `low`
};

class BoundaryEdges {
 public:
  // Faces that name a vertex twice are passed over. O(V + F), times the
  // logarithm of the most edges at a vertex. Tells the checkpoint of its bytes
  // before it takes them: 16 for a vertex and, if there is a boundary, 4 for a
  // vertex and a face, and 8 for a vertex and 12 for a side at it. Errors:
  // whatever `checkpoint` returns; OUT_OF_RANGE if a triangle names a vertex
  // that the soup does not have.
  static absl::StatusOr<BoundaryEdges> Find(const TriangleSoup& soup,
                                            Checkpoint& checkpoint);

  // In order.
  const std::vector<VertexPair>& edges() const { return edges_; }

  // At the boundary, in order; and the number of one among them.
  const std::vector<uint32_t>& vertices() const { return vertices_; }
  bool Has(uint32_t vertex) const { return numbers_[vertex] != 0; }
  uint32_t NumberOf(uint32_t vertex) const { return numbers_[vertex] - 1; }

  // Whether an edge joins two vertices at the boundary.
  bool AreNeighbours(uint32_t a, uint32_t b) const;

 private:
  // Of the faces that have sides between vertices at the boundary.
  absl::Status FindSides(const std::vector<Triangle>& triangles,
                         const std::vector<uint32_t>& faces,
                         Checkpoint& checkpoint, Progress progress);

  std::vector<VertexPair> edges_;
  std::vector<uint32_t> vertices_;
  std::vector<uint32_t> numbers_;  // from 1; 0 elsewhere
  // Of edges between vertices at the boundary, the high ends of those whose low
  // end has number i, in order: highs_[begin_[i]] up to highs_[begin_[i + 1]].
  std::vector<uint32_t> begin_;
  std::vector<uint32_t> highs_;
};

}  // namespace geodesic

#endif  // GEODESIC_MESH_BOUNDARY_EDGES_H_
