#include "translate.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <utility>
#include <variant>

#include "absl/strings/ascii.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"
#include "codec/algorithms.h"
#include "codec/mesh_summary.h"
#include "geodesic_types/algorithms.h"

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

template <typename List>
std::vector<std::string> NamesOf(const List& list) {
  std::vector<std::string> names;
  for (const auto& info : list) names.emplace_back(info.name);
  return names;
}

}  // namespace

Approximation FromProto(const v1::Approximation& approximation) {
  Approximation result;
  if (approximation.has_neighbours()) {
    result.neighbours = approximation.neighbours();
  }
  if (approximation.has_lambda()) result.lambda = approximation.lambda();
  if (approximation.has_samples()) result.samples = approximation.samples();
  return result;
}

MeshInfo FromProto(const v1::Mesh& mesh) {
  MeshInfo info;
  info.digest = mesh.digest();
  codec::FromProto(mesh, info);
  info.notes = {mesh.notes().begin(), mesh.notes().end()};
  info.resident_bytes = mesh.resident_bytes();
  info.stored_bytes = mesh.stored_bytes();
  info.landmark_count = mesh.landmark_count();
  for (const v1::PreparedMethod& method : mesh.prepared_methods()) {
    info.prepared_methods.push_back(
        {.algorithm = AlgorithmName(method.algorithm()),
         .approximation = FromProto(method.approximation()),
         .bytes = method.prepared_bytes(),
         .prepare_seconds = method.prepare_seconds()});
  }
  return info;
}

FieldOrigin FromProto(v1::AnswerOrigin origin) {
  switch (origin) {
    case v1::ANSWER_ORIGIN_JOINED:
      return FieldOrigin::kJoined;
    case v1::ANSWER_ORIGIN_CACHED:
      return FieldOrigin::kCached;
    default:
      return FieldOrigin::kComputed;
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
  const auto add = [](const auto& from, std::vector<AlgorithmCapability>* to) {
    for (const v1::AlgorithmCapability& algorithm : from) {
      to->push_back({.name = algorithm.name(),
                     .summary = algorithm.summary(),
                     .is_default = algorithm.is_default()});
    }
  };
  add(response.algorithms(), &capabilities.algorithms);
  add(response.approximate_algorithms(), &capabilities.approximate_algorithms);
  for (const int format : response.formats()) {
    capabilities.formats.push_back(
        NameWithoutPrefix(v1::MeshFormat_Name(format), "MESH_FORMAT_"));
  }
  const v1::Limits& limits = response.limits();
  capabilities.limits = {
      .max_upload_bytes = limits.max_upload_bytes(),
      .max_vertices = limits.max_vertices(),
      .max_faces = limits.max_faces(),
      .max_sources = limits.max_sources(),
      .max_message_bytes = limits.max_message_bytes(),
      .max_concurrent_jobs = limits.max_concurrent_jobs(),
      .max_queued_jobs = limits.max_queued_jobs(),
      .mesh_store_bytes = limits.mesh_store_bytes(),
      .field_cache_bytes = limits.field_cache_bytes(),
      .max_curve_points = limits.max_curve_points(),
      .max_targets = limits.max_targets(),
      .max_levels = limits.max_levels(),
      .max_samples = limits.max_samples(),
      .max_pairs = limits.max_pairs(),
      .max_matrix_rows = limits.max_matrix_rows(),
      .max_matrix_values = limits.max_matrix_values(),
      .mesh_disk_bytes = limits.mesh_disk_bytes(),
      .field_disk_bytes = limits.field_disk_bytes(),
      .max_queued_jobs_per_client = limits.max_queued_jobs_per_client(),
      .landmark_memory_bytes = limits.landmark_memory_bytes(),
      .prepared_memory_bytes = limits.prepared_memory_bytes()};
  return capabilities;
}

SolveProgress FromProto(const v1::SolveProgress& progress,
                        uint64_t vertex_count) {
  return {.settled_radius = progress.settled_radius(),
          .vertices_reached = progress.vertices_reached(),
          .vertex_count = vertex_count,
          .live_windows = progress.live_windows(),
          .windows_propagated = progress.windows_propagated()};
}

v1::Approximation ToProto(const Approximation& approximation) {
  v1::Approximation message;
  if (approximation.neighbours.has_value()) {
    message.set_neighbours(*approximation.neighbours);
  }
  if (approximation.lambda.has_value()) {
    message.set_lambda(*approximation.lambda);
  }
  if (approximation.samples.has_value()) {
    message.set_samples(*approximation.samples);
  }
  return message;
}

v1::Priority ToProto(Priority priority) {
  return priority == Priority::kBatch ? v1::PRIORITY_BATCH
                                      : v1::PRIORITY_INTERACTIVE;
}

v1::ValueType ToProto(ValueType type) {
  return type == ValueType::kFloat32 ? v1::VALUE_TYPE_FLOAT32
                                     : v1::VALUE_TYPE_FLOAT64;
}

std::string AlgorithmName(v1::Algorithm algorithm) {
  return NameWithoutPrefix(v1::Algorithm_Name(algorithm), "ALGORITHM_");
}

absl::StatusOr<v1::Algorithm> ToProto(std::string_view algorithm) {
  if (algorithm.empty()) return v1::ALGORITHM_UNSPECIFIED;
  if (const auto exact = AlgorithmFromName(algorithm); exact.ok()) {
    return codec::ToProto(*exact);
  }
  if (const auto method = ApproximateMethodFromName(algorithm); method.ok()) {
    return codec::ToProto(*method);
  }
  return absl::InvalidArgumentError(absl::StrCat(
      "unknown algorithm '", std::string(algorithm), "'; known are ",
      absl::StrJoin(AlgorithmNames(), ", "), ", and approximate ",
      absl::StrJoin(ApproximateAlgorithmNames(), ", ")));
}

std::vector<std::string> AlgorithmNames() { return NamesOf(kAlgorithms); }

std::vector<std::string> ApproximateAlgorithmNames() {
  return NamesOf(kApproximateMethods);
}

bool IsApproximate(std::string_view algorithm) {
  return ApproximateMethodFromName(algorithm).ok();
}

std::string_view FieldOriginName(FieldOrigin origin) {
  constexpr std::array kNames = {"computed", "joined", "cached"};
  return kNames.at(static_cast<size_t>(origin));
}

}  // namespace geodesic::client
