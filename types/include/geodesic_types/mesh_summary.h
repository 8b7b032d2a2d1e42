// What there is to know of a mesh.

#ifndef GEODESIC_TYPES_MESH_SUMMARY_H_
#define GEODESIC_TYPES_MESH_SUMMARY_H_

#include <cstdint>
#include <optional>

#include "geodesic_types/places.h"

namespace geodesic {

// Facts about a mesh that people ask for before they query it.
struct MeshSummary {
  uint64_t vertices = 0;
  uint64_t faces = 0;
  uint64_t edges = 0;
  uint64_t boundary_edges = 0;
  uint64_t boundary_loops = 0;
  // Connected pieces that have at least one face.
  uint64_t components = 0;
  // Vertices without a face, but for those that were joined into others.
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
  // Faces that name a vertex twice, which are no part of the surface.
  uint64_t left_out_faces = 0;
  // Edges that were joined, and vertices that are others' repeats.
  uint64_t seam_edges = 0;
  uint64_t joined_vertices = 0;
  // Polygons whose sides cross, and the number of the first. Not in the
  // protocol, whose notes tell of them.
  uint64_t crossing_polygons = 0;
  uint64_t first_crossing_polygon = 0;
  // Boundary edges that lie close to another one, end by end, and were not
  // joined: closer than a fiftieth of its length, and of the mean length of
  // boundary edges. And the distance within which each of them lies, in the
  // unit of the file.
  uint64_t close_edges = 0;
  double close_edge_distance = 0;
  // Other boundary edges that lie along edges of faces beside them: nothing
  // joins them.
  uint64_t touching_edges = 0;
  Point bounding_box_min{};
  Point bounding_box_max{};
  // In the unit of the file; each edge counts once.
  double mean_edge_length = 0;
  // The paper's g: mean over the faces with area of P*H / (2*sqrt(3)*S), with
  // P half the perimeter, H the longest edge, S the area (Xu et al. 2015,
  // section 6). 1 for equilateral faces.
  double anisotropy = 0;
};

// Calls visit(name, fact) for each that is told to users, by the name that they
// know it by. `Summary` is a MeshSummary, constant or not.
template <typename Summary, typename Visit>
void ForEachFact(Summary& summary, Visit visit) {
  visit("vertices", summary.vertices);
  visit("faces", summary.faces);
  visit("edges", summary.edges);
  visit("boundary_edges", summary.boundary_edges);
  visit("boundary_loops", summary.boundary_loops);
  visit("components", summary.components);
  visit("isolated_vertices", summary.isolated_vertices);
  visit("non_manifold_edges", summary.non_manifold_edges);
  visit("non_manifold_vertices", summary.non_manifold_vertices);
  visit("inconsistent_edges", summary.inconsistent_edges);
  visit("is_orientable", summary.is_orientable);
  visit("genus", summary.genus);
  visit("saddle_vertices", summary.saddle_vertices);
  visit("degenerate_faces", summary.degenerate_faces);
  visit("left_out_faces", summary.left_out_faces);
  visit("seam_edges", summary.seam_edges);
  visit("joined_vertices", summary.joined_vertices);
  visit("close_edges", summary.close_edges);
  visit("touching_edges", summary.touching_edges);
  visit("close_edge_distance", summary.close_edge_distance);
  visit("bounding_box_min", summary.bounding_box_min);
  visit("bounding_box_max", summary.bounding_box_max);
  visit("mean_edge_length", summary.mean_edge_length);
  visit("anisotropy", summary.anisotropy);
}

}  // namespace geodesic

#endif  // GEODESIC_TYPES_MESH_SUMMARY_H_
