#include "client/cli/commands/json.h"

#include <string>

#include "geodesic_client/errors.h"

namespace geodesic::client {

Json ToJson(const MeshInfo& mesh) {
  return {{"digest", mesh.digest},
          {"vertices", mesh.vertex_count},
          {"faces", mesh.face_count},
          {"edges", mesh.edge_count},
          {"boundary_edges", mesh.boundary_edge_count},
          {"boundary_loops", mesh.boundary_loop_count},
          {"components", mesh.component_count},
          {"isolated_vertices", mesh.isolated_vertex_count},
          {"non_manifold_edges", mesh.non_manifold_edge_count},
          {"non_manifold_vertices", mesh.non_manifold_vertex_count},
          {"inconsistent_edges", mesh.inconsistent_edge_count},
          {"orientable", mesh.orientable},
          {"genus", mesh.genus.has_value() ? Json(*mesh.genus) : Json()},
          {"saddle_vertices", mesh.saddle_vertex_count},
          {"degenerate_faces", mesh.degenerate_face_count},
          {"bounding_box_min", mesh.bounding_box_min},
          {"bounding_box_max", mesh.bounding_box_max},
          {"mean_edge_length", mesh.mean_edge_length},
          {"anisotropy", mesh.anisotropy},
          {"resident_bytes", mesh.resident_bytes},
          {"stored_bytes", mesh.stored_bytes}};
}

Json ToJson(const FieldStatistics& statistics) {
  return {{"iterations", statistics.iterations},
          {"windows_created", statistics.windows_created},
          {"windows_propagated", statistics.windows_propagated},
          {"peak_wavefront", statistics.peak_wavefront},
          {"mean_wavefront", statistics.mean_wavefront},
          {"peak_windows", statistics.peak_windows},
          {"peak_solver_bytes", statistics.peak_solver_bytes},
          {"solve_seconds", statistics.solve_seconds}};
}

void PrintJson(const Json& json, std::ostream* out) {
  *out << json.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
}

Json ErrorToJson(const absl::Status& status, ExitCode exit_code) {
  return {{"error",
           {{"code", absl::StatusCodeToString(status.code())},
            {"reason", ErrorReason(status)},
            {"message", std::string(status.message())},
            {"exit_code", static_cast<int>(exit_code)}}}};
}

}  // namespace geodesic::client
