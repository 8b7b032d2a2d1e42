#include "translate.h"

#include <algorithm>

#include "absl/strings/ascii.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"

namespace geodesic::client {
namespace {

// "fwp-ch" for ("ALGORITHM_FWP_CH", "ALGORITHM_").
std::string NameWithoutPrefix(const std::string& name,
                              std::string_view prefix) {
  std::string word = absl::AsciiStrToLower(
      name.starts_with(prefix) ? name.substr(prefix.size()) : name);
  std::ranges::replace(word, '_', '-');
  return word;
}

Point FromProto(const v1::Point& point) {
  return {point.x(), point.y(), point.z()};
}

}  // namespace

MeshInfo FromProto(const v1::Mesh& mesh) {
  return {.digest = mesh.digest(),
          .vertex_count = mesh.vertex_count(),
          .face_count = mesh.face_count(),
          .edge_count = mesh.edge_count(),
          .boundary_edge_count = mesh.boundary_edge_count(),
          .boundary_loop_count = mesh.boundary_loop_count(),
          .component_count = mesh.component_count(),
          .isolated_vertex_count = mesh.isolated_vertex_count(),
          .genus = mesh.genus(),
          .saddle_vertex_count = mesh.saddle_vertex_count(),
          .degenerate_face_count = mesh.degenerate_face_count(),
          .bounding_box_min = FromProto(mesh.bounding_box_min()),
          .bounding_box_max = FromProto(mesh.bounding_box_max()),
          .mean_edge_length = mesh.mean_edge_length(),
          .anisotropy = mesh.anisotropy(),
          .resident_bytes = mesh.resident_bytes()};
}

FieldOrigin FromProto(v1::FieldOrigin origin) {
  switch (origin) {
    case v1::FIELD_ORIGIN_JOINED:
      return FieldOrigin::kJoined;
    case v1::FIELD_ORIGIN_CACHED:
      return FieldOrigin::kCached;
    default:
      return FieldOrigin::kSolved;
  }
}

FieldStatistics FromProto(const v1::SolveStatistics& statistics) {
  return {.iterations = statistics.iterations(),
          .windows_created = statistics.windows_created(),
          .windows_propagated = statistics.windows_propagated(),
          .peak_wavefront = statistics.peak_wavefront(),
          .mean_wavefront = statistics.mean_wavefront(),
          .peak_windows = statistics.peak_windows(),
          .peak_solver_bytes = statistics.peak_solver_bytes(),
          .solve_seconds = statistics.solve_seconds()};
}

Capabilities FromProto(const v1::GetCapabilitiesResponse& response) {
  Capabilities capabilities;
  capabilities.version = response.version();
  for (const v1::AlgorithmCapability& algorithm : response.algorithms()) {
    capabilities.algorithms.push_back({.name = algorithm.name(),
                                       .summary = algorithm.summary(),
                                       .is_default = algorithm.is_default()});
  }
  for (const int format : response.formats()) {
    capabilities.formats.push_back(
        NameWithoutPrefix(v1::MeshFormat_Name(format), "MESH_FORMAT_"));
  }
  const v1::Limits& limits = response.limits();
  capabilities.limits = {.max_upload_bytes = limits.max_upload_bytes(),
                         .max_vertices = limits.max_vertices(),
                         .max_faces = limits.max_faces(),
                         .max_sources = limits.max_sources(),
                         .max_message_bytes = limits.max_message_bytes(),
                         .max_concurrent_jobs = limits.max_concurrent_jobs(),
                         .max_queued_jobs = limits.max_queued_jobs(),
                         .mesh_store_bytes = limits.mesh_store_bytes(),
                         .field_cache_bytes = limits.field_cache_bytes()};
  return capabilities;
}

v1::MeshFormat ToProto(MeshFormat format) {
  switch (format) {
    case MeshFormat::kObj:
      return v1::MESH_FORMAT_OBJ;
    case MeshFormat::kPly:
      return v1::MESH_FORMAT_PLY;
    case MeshFormat::kOff:
      return v1::MESH_FORMAT_OFF;
    case MeshFormat::kStl:
      return v1::MESH_FORMAT_STL;
  }
  return v1::MESH_FORMAT_UNSPECIFIED;
}

std::string AlgorithmName(v1::Algorithm algorithm) {
  return NameWithoutPrefix(v1::Algorithm_Name(algorithm), "ALGORITHM_");
}

absl::StatusOr<v1::Algorithm> AlgorithmFromName(std::string_view name) {
  if (name.empty()) return v1::ALGORITHM_UNSPECIFIED;
  for (int value = v1::Algorithm_MIN; value <= v1::Algorithm_MAX; ++value) {
    if (!v1::Algorithm_IsValid(value) || value == v1::ALGORITHM_UNSPECIFIED) {
      continue;
    }
    const auto algorithm = static_cast<v1::Algorithm>(value);
    if (AlgorithmName(algorithm) == name) return algorithm;
  }
  return absl::InvalidArgumentError(
      absl::StrCat("unknown algorithm '", std::string(name), "'; known are ",
                   absl::StrJoin(AlgorithmNames(), ", ")));
}

std::vector<std::string> AlgorithmNames() {
  std::vector<std::string> names;
  for (int value = v1::Algorithm_MIN; value <= v1::Algorithm_MAX; ++value) {
    if (v1::Algorithm_IsValid(value) && value != v1::ALGORITHM_UNSPECIFIED) {
      names.push_back(AlgorithmName(static_cast<v1::Algorithm>(value)));
    }
  }
  return names;
}

std::string_view FieldOriginName(FieldOrigin origin) {
  switch (origin) {
    case FieldOrigin::kSolved:
      return "solved";
    case FieldOrigin::kJoined:
      return "joined";
    case FieldOrigin::kCached:
      return "cached";
  }
  return "unknown";
}

}  // namespace geodesic::client
