// Boundary edges that lie along other edges, where no seam can join them.

#ifndef GEODESIC_MESH_TOUCHING_EDGES_H_
#define GEODESIC_MESH_TOUCHING_EDGES_H_

#include <cstdint>
#include <span>

#include "absl/status/statusor.h"
#include "geodesic/checkpoint.h"
#include "geodesic/mesh.h"

namespace geodesic {

// How many of these boundary edges lie along another edge:
//   along another one of them, within kTouching of the shorter one, for more
//   than a hundredth of it; but not end to end, which is close (close_edges.h),
//   nor of the same face or one beside it, which are the sides of a strip;
//   or end to end, in the same coordinates, along an edge that is no boundary.
// O(V + edges), once for each power of two among the lengths; where more edges
// than some dozens lie together, some may go uncounted. Edges without length
// touch nothing. Errors: whatever `checkpoint` returns, asked every few
// milliseconds.
absl::StatusOr<uint64_t> CountTouchingEdges(const Mesh& mesh,
                                            std::span<const HalfEdge> boundary,
                                            Checkpoint& checkpoint);

}  // namespace geodesic

#endif  // GEODESIC_MESH_TOUCHING_EDGES_H_
