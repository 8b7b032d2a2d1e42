// Which half-edges lie on the sides of an edge.

#ifndef GEODESIC_MESH_CONNECTIVITY_H_
#define GEODESIC_MESH_CONNECTIVITY_H_

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "geodesic/mesh.h"

namespace geodesic {

// The faces of a mesh by half-edges, and the half-edges that leave each vertex
// v: outgoing[outgoing_begin[v]] up to outgoing[outgoing_begin[v + 1]].
struct Incidence {
  std::span<const Triangle> triangles;
  std::span<const uint32_t> outgoing_begin;
  std::span<const HalfEdge> outgoing;
  // Where vertices were joined, what the faces named before, and their numbers:
  // those of triangles[i] are named[faces[i]]. Else empty.
  std::span<const Triangle> named;
  std::span<const uint32_t> faces;

  uint32_t vertex_count() const { return outgoing_begin.size() - 1; }
  std::span<const HalfEdge> Outgoing(uint32_t v) const {
    return outgoing.subspan(outgoing_begin[v],
                            outgoing_begin[v + 1] - outgoing_begin[v]);
  }
  uint32_t From(HalfEdge h) const { return triangles[h / 3][h % 3]; }
  // The ends of h as they were named, the lower one first.
  std::pair<uint32_t, uint32_t> NamedEnds(HalfEdge h) const {
    const Triangle& corners = named[faces[h / 3]];
    return std::minmax({corners[h % 3], corners[(h + 1) % 3]});
  }
};

struct Connectivity {
  // What lies beyond each half-edge 3f + i. Irregular edge number k is
  // kIrregularExit + k.
  std::vector<Exit> exits;
  // The half-edges of irregular edge k, in order: [begin[k], begin[k + 1]).
  std::vector<uint32_t> irregular_begin;  // empty if there are none
  std::vector<HalfEdge> irregular_half_edges;
  // Of each vertex, whether the faces around it are one closed fan in which all
  // agree: the usual case.
  std::vector<uint8_t> is_closed_fan;
};

// Sides with the same ends are one edge. Where vertices were joined, those that
// had the same ends before are one, and those that had none beside them
// another. REQUIRES: indices below vertex_count(), no face repeats a vertex.
// O(V + F) time, and O(F log F) at the irregular edges' ends, whatever the
// valence (OpenMesh's add_face walks around vertices, which is quadratic in the
// valence of a hostile fan).
Connectivity FindConnectivity(const Incidence& incidence);

}  // namespace geodesic

#endif  // GEODESIC_MESH_CONNECTIVITY_H_
