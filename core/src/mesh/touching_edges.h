// Boundary edges that lie along other edges, where no seam can join them.

#ifndef GEODESIC_MESH_TOUCHING_EDGES_H_
#define GEODESIC_MESH_TOUCHING_EDGES_H_

#include <cstdint>
#include <span>

#include "geodesic/mesh.h"
#include "mesh/close_edges.h"

namespace geodesic {

// Where more edges lie together than this, some may go uncounted.
inline constexpr uint32_t kMostCompared = 64;

// How many of these boundary edges lie along another edge of the mesh, of
// another face:
//   along a longer one of `boundary`, as close as `closeness` says, such that
//   its middle lies beside that edge and not both ends are at its ends, as where
//   a corner lies inside an edge;
//   or end to end, in the same coordinates, along an edge that is no boundary.
// O(V + edges), once for each power of two among the lengths. Edges without
// length touch nothing.
uint64_t CountTouchingEdges(const Mesh& mesh,
                            std::span<const HalfEdge> boundary,
                            const Closeness& closeness);

}  // namespace geodesic

#endif  // GEODESIC_MESH_TOUCHING_EDGES_H_
