#include "server/rpc/messages/field_translation.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "absl/strings/ascii.h"
#include "absl/strings/str_cat.h"
#include "geodesic/algorithm.h"
#include "geodesic/field_path.h"
#include "server/rpc/messages/surface_translation.h"

namespace geodesic::server {
namespace {

absl::StatusOr<FieldExtras> ExtrasFrom(const v1::ComputeFieldRequest& request) {
  FieldExtras extras{.settled_order = request.progressive()};
  for (int i = 0; i < request.quantities_size(); ++i) {
    switch (request.quantities(i)) {
      case v1::FIELD_QUANTITY_NEAREST_SOURCE:
        extras.nearest_sources = true;
        break;
      case v1::FIELD_QUANTITY_GRADIENT:
        extras.gradients = true;
        break;
      default:
        return Unknown(absl::StrCat("quantities[", i, "]"),
                       request.quantities(i));
    }
  }
  if (request.progressive() && request.quantities_size() > 0) {
    return InvalidField("quantities",
                        "quantities of a progressive field are not sent: ask "
                        "for them when it is finished");
  }
  return extras;
}

}  // namespace

absl::Status Unknown(const std::string& field, int number) {
  return InvalidField(field, absl::StrCat(field, " is ", number,
                                          ", which this server does not know"));
}

// ALGORITHM_FWP_CH for "fwp-ch".
v1::Algorithm ToProto(Algorithm algorithm) {
  std::string name = "ALGORITHM_" + std::string(AlgorithmName(algorithm));
  absl::AsciiStrToUpper(&name);
  std::ranges::replace(name, '-', '_');
  v1::Algorithm result = v1::ALGORITHM_UNSPECIFIED;
  v1::Algorithm_Parse(name, &result);
  return result;
}

v1::FieldOrigin ToProto(FieldOrigin origin) {
  switch (origin) {
    case FieldOrigin::kComputed:
      return v1::FIELD_ORIGIN_COMPUTED;
    case FieldOrigin::kJoined:
      return v1::FIELD_ORIGIN_JOINED;
    case FieldOrigin::kCached:
      return v1::FIELD_ORIGIN_CACHED;
  }
  return v1::FIELD_ORIGIN_UNSPECIFIED;
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

v1::AnswerHeader MakeHeader(const ResidentMesh& mesh, Algorithm algorithm,
                            const std::string& version) {
  v1::AnswerHeader header;
  header.set_mesh_digest(mesh.digest);
  header.set_vertex_count(mesh.mesh->vertex_count());
  header.set_algorithm(ToProto(algorithm));
  header.set_relative_tolerance(kRelativeTolerance);
  header.set_server_version(version);
  return header;
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

absl::StatusOr<v1::ValueType> ResolveValueType(v1::ValueType type) {
  switch (type) {
    case v1::VALUE_TYPE_UNSPECIFIED:
    case v1::VALUE_TYPE_FLOAT64:
      return v1::VALUE_TYPE_FLOAT64;
    case v1::VALUE_TYPE_FLOAT32:
      return v1::VALUE_TYPE_FLOAT32;
    default:
      return Unknown("value_type", type);
  }
}

absl::StatusOr<bool> IsBatch(v1::Priority priority) {
  switch (priority) {
    case v1::PRIORITY_UNSPECIFIED:
    case v1::PRIORITY_INTERACTIVE:
      return false;
    case v1::PRIORITY_BATCH:
      return true;
    default:
      return Unknown("priority", priority);
  }
}

absl::Status Translate(const v1::ComputeFieldRequest& request,
                       const Limits& limits, FieldRequest& result) {
  absl::Status status = AddSources(request.sources(), limits, result.query);
  if (!status.ok()) return status;
  status = AddTargets(request.targets(), limits, result.query);
  if (!status.ok()) return status;
  if (request.has_radius()) result.reach.radius = request.radius();
  if (request.has_stop_after_targets()) {
    // The largest number would mean no limit to the engine.
    result.reach.targets = std::min(request.stop_after_targets(),
                                    std::numeric_limits<uint64_t>::max() - 1);
  }
  absl::StatusOr<FieldExtras> extras = ExtrasFrom(request);
  if (!extras.ok()) return extras.status();
  result.extras = *extras;
  if (request.has_resumption()) {
    if (request.progressive()) {
      return InvalidField("resumption", "a progressive field is not resumed");
    }
    result.must_be_kept = true;
  }
  return absl::OkStatus();
}

}  // namespace geodesic::server
