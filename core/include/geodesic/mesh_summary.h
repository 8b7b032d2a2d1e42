// Facts about a mesh that people ask for before they query it.

#ifndef GEODESIC_MESH_SUMMARY_H_
#define GEODESIC_MESH_SUMMARY_H_

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "geodesic/checkpoint.h"
#include "geodesic/mesh.h"

namespace geodesic {

// Figures of a mesh.
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
  // Edges that were joined, and vertices that are others' repeats
  // (join_seams.h).
  uint64_t seam_edges = 0;
  uint64_t joined_vertices = 0;
  // See triangle_soup.h.
  uint64_t crossing_polygons = 0;
  uint64_t first_crossing_polygon = 0;
  // Boundary edges that lie close to another one, end by end, and were not
  // joined: closer than a fiftieth of its length, and of the mean length of
  // boundary edges. And the distance within which each of them lies, in the
  // unit of the file.
  uint64_t close_edges = 0;
  double close_edge_distance = 0;
  // Other boundary edges that lie along edges of faces beside them
  // (touching_edges.h): nothing joins them.
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

// O(V + F). Thread-safe.
MeshSummary Summarize(const Mesh& mesh);
// The same; asks the checkpoint every few milliseconds. Errors: as
// `checkpoint`.
absl::StatusOr<MeshSummary> Summarize(const Mesh& mesh, Checkpoint& checkpoint);

// The part of the summary that Notes tells of: O(F), and less than a part of
// building the mesh.
MeshSummary SummarizeReading(const Mesh& mesh);

// What a user of the mesh has to know: what was joined, left out or guessed,
// and what looks as if it should have been joined. A sentence each, without an
// end, e.g. "joined 646 seam edges". Empty for most meshes.
std::vector<std::string> Notes(const MeshSummary& summary);

}  // namespace geodesic

#endif  // GEODESIC_MESH_SUMMARY_H_
