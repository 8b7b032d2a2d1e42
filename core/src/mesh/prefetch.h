// Fetches parts of a mesh into cache before they are needed.

#ifndef GEODESIC_MESH_PREFETCH_H_
#define GEODESIC_MESH_PREFETCH_H_

#include <cstdint>

#include "geodesic/mesh.h"

namespace geodesic {

// The face of h.
inline void PrefetchFace(const Mesh& mesh, HalfEdge h) {
  const HalfEdge first = h - h % 3;
  __builtin_prefetch(&mesh.frame(first));
  __builtin_prefetch(&mesh.frame(first + 1));
  __builtin_prefetch(&mesh.frame(first + 2));
  __builtin_prefetch(&mesh.TriangleOf(h));
}

// The faces around v.
inline void PrefetchFan(const Mesh& mesh, uint32_t v) {
  for (const HalfEdge h : mesh.Outgoing(v)) PrefetchFace(mesh, h);
}

}  // namespace geodesic

#endif  // GEODESIC_MESH_PREFETCH_H_
