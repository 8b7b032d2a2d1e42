#include "server/rpc/messages/mesh_translation.h"

#include <string_view>

#include "absl/strings/str_cat.h"
#include "geodesic/field_path.h"
#include "server/rpc/messages/surface_translation.h"

namespace geodesic::server {
v1::Mesh ToProto(const MeshDescription& mesh) {
  const MeshSummary& summary = mesh.summary;
  v1::Mesh proto;
  proto.set_digest(mesh.digest);
  proto.set_vertex_count(summary.vertices);
  proto.set_face_count(summary.faces);
  proto.set_edge_count(summary.edges);
  proto.set_boundary_edge_count(summary.boundary_edges);
  proto.set_boundary_loop_count(summary.boundary_loops);
  proto.set_component_count(summary.components);
  proto.set_isolated_vertex_count(summary.isolated_vertices);
  if (summary.genus.has_value()) proto.set_genus(*summary.genus);
  proto.set_saddle_vertex_count(summary.saddle_vertices);
  proto.set_degenerate_face_count(summary.degenerate_faces);
  SetPoint(summary.bounding_box_min, *proto.mutable_bounding_box_min());
  SetPoint(summary.bounding_box_max, *proto.mutable_bounding_box_max());
  proto.set_mean_edge_length(summary.mean_edge_length);
  proto.set_anisotropy(summary.anisotropy);
  proto.set_resident_bytes(mesh.resident_bytes);
  proto.set_stored_bytes(mesh.stored_bytes);
  proto.set_non_manifold_edge_count(summary.non_manifold_edges);
  proto.set_non_manifold_vertex_count(summary.non_manifold_vertices);
  proto.set_inconsistent_edge_count(summary.inconsistent_edges);
  proto.set_orientable(summary.is_orientable);
  return proto;
}

v1::FileDigest ToProto(const FileKey& file) {
  v1::FileDigest proto;
  for (const auto& [format, value] : kMeshFormats) {
    if (format == file.format) proto.set_format(value);
  }
  proto.set_sha256(file.sha256);
  return proto;
}

absl::StatusOr<UploadFormat> FromProto(v1::MeshFormat format,
                                       std::string_view field) {
  for (const auto& [known, value] : kMeshFormats) {
    if (value == format) return known;
  }
  return InvalidField(
      field, absl::StrCat(absl::string_view(field.data(), field.size()), " is ",
                          static_cast<int>(format),
                          "; it must be one of the formats that "
                          "GetCapabilities lists"));
}

absl::StatusOr<UploadHeader> FromProto(const v1::UploadHeader& header) {
  absl::StatusOr<UploadFormat> format =
      FromProto(header.format(), "header.format");
  if (!format.ok()) return format.status();
  return UploadHeader{.format = *format,
                      .size_bytes = header.size_bytes(),
                      .vertex_count = header.vertex_count(),
                      .face_count = header.face_count(),
                      .expected_digest = header.expected_digest()};
}

}  // namespace geodesic::server
