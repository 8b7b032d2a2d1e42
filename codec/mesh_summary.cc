#include "codec/mesh_summary.h"

namespace geodesic::codec {

void ToProto(const Point& point, v1::Point& proto) {
  proto.set_x(point[0]);
  proto.set_y(point[1]);
  proto.set_z(point[2]);
}

Point FromProto(const v1::Point& proto) {
  return {proto.x(), proto.y(), proto.z()};
}

void ToProto(const MeshSummary& summary, v1::Mesh& proto) {
  proto.set_vertex_count(summary.vertices);
  proto.set_face_count(summary.faces);
  proto.set_edge_count(summary.edges);
  proto.set_boundary_edge_count(summary.boundary_edges);
  proto.set_boundary_loop_count(summary.boundary_loops);
  proto.set_component_count(summary.components);
  proto.set_isolated_vertex_count(summary.isolated_vertices);
  proto.set_non_manifold_edge_count(summary.non_manifold_edges);
  proto.set_non_manifold_vertex_count(summary.non_manifold_vertices);
  proto.set_inconsistent_edge_count(summary.inconsistent_edges);
  proto.set_orientable(summary.is_orientable);
  proto.set_saddle_vertex_count(summary.saddle_vertices);
  proto.set_degenerate_face_count(summary.degenerate_faces);
  proto.set_left_out_face_count(summary.left_out_faces);
  proto.set_seam_edge_count(summary.seam_edges);
  proto.set_joined_vertex_count(summary.joined_vertices);
  proto.set_close_edge_count(summary.close_edges);
  proto.set_touching_edge_count(summary.touching_edges);
  proto.set_close_edge_distance(summary.close_edge_distance);
  proto.set_mean_edge_length(summary.mean_edge_length);
  proto.set_anisotropy(summary.anisotropy);
  if (summary.genus.has_value()) proto.set_genus(*summary.genus);
  ToProto(summary.bounding_box_min, *proto.mutable_bounding_box_min());
  ToProto(summary.bounding_box_max, *proto.mutable_bounding_box_max());
}

void FromProto(const v1::Mesh& proto, MeshSummary& summary) {
  summary.vertices = proto.vertex_count();
  summary.faces = proto.face_count();
  summary.edges = proto.edge_count();
  summary.boundary_edges = proto.boundary_edge_count();
  summary.boundary_loops = proto.boundary_loop_count();
  summary.components = proto.component_count();
  summary.isolated_vertices = proto.isolated_vertex_count();
  summary.non_manifold_edges = proto.non_manifold_edge_count();
  summary.non_manifold_vertices = proto.non_manifold_vertex_count();
  summary.inconsistent_edges = proto.inconsistent_edge_count();
  summary.is_orientable = proto.orientable();
  summary.saddle_vertices = proto.saddle_vertex_count();
  summary.degenerate_faces = proto.degenerate_face_count();
  summary.left_out_faces = proto.left_out_face_count();
  summary.seam_edges = proto.seam_edge_count();
  summary.joined_vertices = proto.joined_vertex_count();
  summary.close_edges = proto.close_edge_count();
  summary.touching_edges = proto.touching_edge_count();
  summary.close_edge_distance = proto.close_edge_distance();
  summary.mean_edge_length = proto.mean_edge_length();
  summary.anisotropy = proto.anisotropy();
  if (proto.has_genus()) summary.genus = proto.genus();
  summary.bounding_box_min = FromProto(proto.bounding_box_min());
  summary.bounding_box_max = FromProto(proto.bounding_box_max());
}

}  // namespace geodesic::codec
