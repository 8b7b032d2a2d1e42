#include "server/rpc/message_translation.h"

#include <cstdint>
#include <limits>
#include <string>

#include "absl/strings/str_cat.h"
#include "server/engine/status_details.h"

namespace geodesic::server {
namespace {

void SetPoint(const Point& from, v1::Point& to) {
  to.set_x(from[0]);
  to.set_y(from[1]);
  to.set_z(from[2]);
}

v1::MeshFormat ToProto(UploadFormat format) {
  switch (format) {
    case UploadFormat::kArrays:
      return v1::MESH_FORMAT_ARRAYS;
    case UploadFormat::kObj:
      return v1::MESH_FORMAT_OBJ;
    case UploadFormat::kPly:
      return v1::MESH_FORMAT_PLY;
    case UploadFormat::kOff:
      return v1::MESH_FORMAT_OFF;
    case UploadFormat::kStl:
      return v1::MESH_FORMAT_STL;
  }
  return v1::MESH_FORMAT_UNSPECIFIED;
}

}  // namespace

v1::Mesh ToProto(const ResidentMesh& mesh) {
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
  proto.set_genus(summary.genus);
  proto.set_saddle_vertex_count(summary.saddle_vertices);
  proto.set_degenerate_face_count(summary.degenerate_faces);
  SetPoint(summary.bounding_box_min, *proto.mutable_bounding_box_min());
  SetPoint(summary.bounding_box_max, *proto.mutable_bounding_box_max());
  proto.set_mean_edge_length(summary.mean_edge_length);
  proto.set_anisotropy(summary.anisotropy);
  proto.set_resident_bytes(mesh.mesh->resident_bytes());
  return proto;
}

v1::Algorithm ToProto(Algorithm algorithm) {
  switch (algorithm) {
    case Algorithm::kFwpCh:
      return v1::ALGORITHM_FWP_CH;
    case Algorithm::kFwpMmp:
      return v1::ALGORITHM_FWP_MMP;
    case Algorithm::kIch:
      return v1::ALGORITHM_ICH;
    case Algorithm::kMmp:
      return v1::ALGORITHM_MMP;
    case Algorithm::kCh:
      return v1::ALGORITHM_CH;
    case Algorithm::kLcMmp:
      return v1::ALGORITHM_LC_MMP;
    case Algorithm::kLcCh:
      return v1::ALGORITHM_LC_CH;
  }
  return v1::ALGORITHM_UNSPECIFIED;
}

v1::FieldOrigin ToProto(FieldOrigin origin) {
  switch (origin) {
    case FieldOrigin::kSolved:
      return v1::FIELD_ORIGIN_SOLVED;
    case FieldOrigin::kJoined:
      return v1::FIELD_ORIGIN_JOINED;
    case FieldOrigin::kCached:
      return v1::FIELD_ORIGIN_CACHED;
  }
  return v1::FIELD_ORIGIN_UNSPECIFIED;
}

v1::FileDigest ToProto(const FileKey& file) {
  v1::FileDigest proto;
  proto.set_format(ToProto(file.format));
  proto.set_sha256(file.sha256);
  return proto;
}

v1::SolveProgress ToProto(const Progress& progress) {
  v1::SolveProgress proto;
  proto.set_settled_radius(progress.settled_radius);
  proto.set_vertices_reached(progress.vertices_reached);
  proto.set_live_windows(progress.live_windows);
  proto.set_windows_propagated(progress.windows_propagated);
  return proto;
}

v1::SolveStatistics ToProto(const SolveStatistics& statistics) {
  v1::SolveStatistics proto;
  proto.set_iterations(statistics.iterations);
  proto.set_windows_created(statistics.windows_created);
  proto.set_windows_propagated(statistics.windows_propagated);
  proto.set_peak_wavefront(statistics.peak_wavefront);
  proto.set_mean_wavefront(statistics.mean_wavefront);
  proto.set_peak_windows(statistics.peak_windows);
  proto.set_peak_solver_bytes(statistics.peak_solver_bytes);
  proto.set_solve_seconds(statistics.solve_seconds);
  return proto;
}

absl::StatusOr<UploadFormat> FromProto(v1::MeshFormat format,
                                       std::string_view field) {
  switch (format) {
    case v1::MESH_FORMAT_ARRAYS:
      return UploadFormat::kArrays;
    case v1::MESH_FORMAT_OBJ:
      return UploadFormat::kObj;
    case v1::MESH_FORMAT_PLY:
      return UploadFormat::kPly;
    case v1::MESH_FORMAT_OFF:
      return UploadFormat::kOff;
    case v1::MESH_FORMAT_STL:
      return UploadFormat::kStl;
    default:
      return InvalidField(
          field, absl::StrCat(absl::string_view(field.data(), field.size()),
                              " is ", static_cast<int>(format),
                              "; it must be one of the formats that "
                              "GetCapabilities lists"));
  }
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

absl::StatusOr<Algorithm> FromProto(v1::Algorithm algorithm) {
  if (algorithm == v1::ALGORITHM_UNSPECIFIED) return kDefaultAlgorithm;
  for (const AlgorithmInfo& info : kAlgorithms) {
    if (ToProto(info.algorithm) == algorithm) return info.algorithm;
  }
  return InvalidField("algorithm",
                      absl::StrCat("algorithm is ", static_cast<int>(algorithm),
                                   ", which this server does not know; "
                                   "GetCapabilities lists those it does"));
}

absl::StatusOr<FieldRequest> FromProto(const v1::ComputeFieldRequest& request) {
  FieldRequest result{.mesh_digest = request.mesh_digest()};
  absl::StatusOr<Algorithm> algorithm = FromProto(request.algorithm());
  if (!algorithm.ok()) return algorithm.status();
  result.query.algorithm = *algorithm;
  result.query.sources.reserve(request.sources_size());
  for (int i = 0; i < request.sources_size(); ++i) {
    const v1::Source& source = request.sources(i);
    if (source.place_case() != v1::Source::kVertex) {
      return InvalidField(absl::StrCat("sources[", i, "]"),
                          absl::StrCat("sources[", i, "] is not at a vertex"));
    }
    // Wider than what any mesh holds; the rest is for the engine to judge.
    if (source.vertex() > std::numeric_limits<uint32_t>::max()) {
      return InvalidField(
          absl::StrCat("sources[", i, "].vertex"),
          absl::StrCat("sources[", i, "].vertex ", source.vertex(),
                       " is out of range: vertices are numbered in 32 bits"));
    }
    result.query.sources.push_back(
        {VertexPoint{static_cast<uint32_t>(source.vertex())}, source.offset()});
  }
  return result;
}

}  // namespace geodesic::server
