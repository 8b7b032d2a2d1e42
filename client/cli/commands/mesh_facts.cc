#include "client/cli/commands/mesh_facts.h"

#include "absl/strings/str_cat.h"

namespace geodesic::client {
namespace {

std::string PointText(const Point& point) {
  return absl::StrCat(ShortNumber(point[0]), " ", ShortNumber(point[1]), " ",
                      ShortNumber(point[2]));
}

// Whether the faces are turned alike, or could be.
std::string Orientation(const MeshInfo& mesh) {
  if (!mesh.orientable) return "not orientable";
  if (mesh.inconsistent_edge_count == 0) return "consistent";
  return absl::StrCat("orientable, but the faces at ",
                      GroupedNumber(mesh.inconsistent_edge_count),
                      " edges are turned against each other");
}

}  // namespace

std::string Genus(const MeshInfo& mesh) {
  return mesh.genus.has_value() ? absl::StrCat(*mesh.genus) : "none";
}

std::vector<Fact> FactsOf(const MeshInfo& mesh) {
  return {
      {"digest", mesh.digest},
      {"vertices", GroupedNumber(mesh.vertex_count)},
      {"faces", GroupedNumber(mesh.face_count)},
      {"edges", GroupedNumber(mesh.edge_count)},
      {"boundary",
       absl::StrCat(GroupedNumber(mesh.boundary_edge_count), " edges in ",
                    GroupedNumber(mesh.boundary_loop_count), " loops")},
      {"components", GroupedNumber(mesh.component_count)},
      {"isolated vertices", GroupedNumber(mesh.isolated_vertex_count)},
      {"non-manifold",
       absl::StrCat(GroupedNumber(mesh.non_manifold_edge_count), " edges, ",
                    GroupedNumber(mesh.non_manifold_vertex_count),
                    " vertices")},
      {"orientation", Orientation(mesh)},
      {"genus", Genus(mesh)},
      {"saddle vertices", GroupedNumber(mesh.saddle_vertex_count)},
      {"degenerate faces", GroupedNumber(mesh.degenerate_face_count)},
      {"bounding box", absl::StrCat(PointText(mesh.bounding_box_min), "  to  ",
                                    PointText(mesh.bounding_box_max))},
      {"mean edge length", ShortNumber(mesh.mean_edge_length)},
      {"anisotropy", ShortNumber(mesh.anisotropy)},
      {"resident", ByteCount(mesh.resident_bytes)},
      {"on disk", ByteCount(mesh.stored_bytes)}};
}

}  // namespace geodesic::client
