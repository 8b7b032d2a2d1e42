// Which half-edges lie on the sides of an edge.

#ifndef GEODESIC_CONNECTIVITY_H_
#define GEODESIC_CONNECTIVITY_H_

#include <cstdint>
#include <span>
#include <vector>

#include "geodesic/mesh.h"

namespace geodesic {

struct Connectivity {
  // What lies beyond each half-edge 3f + i. Irregular edge number k is
  // kIrregularExit + k.
  std::vector<Exit> exits;
  // The half-edges of irregular edge k, in order: [begin[k], begin[k + 1]).
  std::vector<uint32_t> crowds_begin;  // empty if there are none
  std::vector<HalfEdge> crowds;
};

// REQUIRES: indices below vertex_count, no face repeats a vertex.
// O(V + F log F) time whatever the valence (OpenMesh's add_face walks around
// vertices, which is quadratic in the valence of a hostile fan).
Connectivity FindConnectivity(std::span<const Triangle> triangles,
                              uint32_t vertex_count);

}  // namespace geodesic

#endif  // GEODESIC_CONNECTIVITY_H_
