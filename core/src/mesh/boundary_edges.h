// The edges of a triangle soup that bound one face.

#ifndef GEODESIC_MESH_BOUNDARY_EDGES_H_
#define GEODESIC_MESH_BOUNDARY_EDGES_H_

#include <compare>
#include <cstdint>
#include <vector>

#include "geodesic/triangle_soup.h"

namespace geodesic {

struct VertexPair {
  uint32_t low = 0;
  uint32_t high = 0;  // above `low`

  friend auto operator<=>(const VertexPair&, const VertexPair&) = default;
};

struct BoundaryEdges {
  // Edges of one face, in order.
  std::vector<VertexPair> edges;
  // Edges between two ends of these, those among them; in order.
  std::vector<VertexPair> around;
};

// Faces that name a vertex twice are passed over. O(V + F), and O(B log B) for
// B edges between vertices at the boundary. REQUIRES: the triangles name
// vertices of the soup.
BoundaryEdges FindBoundaryEdges(const TriangleSoup& soup);

}  // namespace geodesic

#endif  // GEODESIC_MESH_BOUNDARY_EDGES_H_
