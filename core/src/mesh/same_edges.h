// Faces that have all edges in common, as a face that is given twice.

#ifndef GEODESIC_MESH_SAME_EDGES_H_
#define GEODESIC_MESH_SAME_EDGES_H_

#include <algorithm>
#include <array>

#include "geodesic/mesh.h"

namespace geodesic {

// Whether the faces of two half-edges have the same three edges. Where sheets
// that were joined lie on each other, faces of the same corners may have others
// (connectivity.cc).
inline bool HaveSameEdges(const Mesh& mesh, HalfEdge a, HalfEdge b) {
  const auto edges = [&mesh](HalfEdge h) {
    std::array<HalfEdge, 3> firsts = {mesh.FirstOfEdge(h),
                                      mesh.FirstOfEdge(Next(h)),
                                      mesh.FirstOfEdge(Prev(h))};
    std::ranges::sort(firsts);
    return firsts;
  };
  return edges(a) == edges(b);
}

}  // namespace geodesic

#endif  // GEODESIC_MESH_SAME_EDGES_H_
