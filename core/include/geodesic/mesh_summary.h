// Facts about a mesh that people ask for before they query it.

#ifndef GEODESIC_MESH_SUMMARY_H_
#define GEODESIC_MESH_SUMMARY_H_

#include <cstdint>
#include <optional>

#include "geodesic/mesh.h"

namespace geodesic {

struct MeshSummary {
  uint64_t vertices = 0;
  uint64_t faces = 0;
  uint64_t edges = 0;
  uint64_t boundary_edges = 0;
  uint64_t boundary_loops = 0;
  // Connected pieces that have at least one face.
  uint64_t components = 0;
  // Vertices without a face.
  uint64_t isolated_vertices = 0;
  // Edges of three faces or more, and vertices at such edges or where several
  // fans of faces touch.
  uint64_t non_manifold_edges = 0;
  uint64_t non_manifold_vertices = 0;
  // Edges along which two faces run in the same direction.
  uint64_t inconsistent_edges = 0;
  // Whether faces can be turned over such that they agree across all edges of
  // two faces.
  bool is_orientable = true;
  // Sum of the genera of the components; none where the surface is not
  // orientable or has non-manifold edges.
  std::optional<int64_t> genus;
  // Interior vertices whose cone angle exceeds 2 pi.
  uint64_t saddle_vertices = 0;
  // Faces without area.
  uint64_t degenerate_faces = 0;
  Point bounding_box_min{};
  Point bounding_box_max{};
  // In the unit of the file; each edge counts once.
  double mean_edge_length = 0;
  // The paper's g: mean over the faces with area of P*H / (2*sqrt(3)*S), with
  // P half the perimeter, H the longest edge, S the area (Xu et al. 2015,
  // section 6). 1 for equilateral faces.
  double anisotropy = 0;
};

// O(V + F). Thread-safe.
MeshSummary Summarize(const Mesh& mesh);

}  // namespace geodesic

#endif  // GEODESIC_MESH_SUMMARY_H_
