// Converts between messages of geodesic.v1 and the plain types of the public
// headers.

#ifndef GEODESIC_CLIENT_TRANSLATE_H_
#define GEODESIC_CLIENT_TRANSLATE_H_

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "codec/places.h"
#include "geodesic/v1/answer.pb.h"
#include "geodesic/v1/capabilities_service.pb.h"
#include "geodesic/v1/mesh.pb.h"
#include "geodesic/v1/query.pb.h"
#include "geodesic/v1/question_service.pb.h"
#include "geodesic/v1/surface.pb.h"
#include "geodesic_client/answer.h"
#include "geodesic_client/capabilities.h"
#include "geodesic_client/field.h"
#include "geodesic_client/mesh.h"
#include "geodesic_types/places.h"

namespace geodesic::client {

Approximation FromProto(const v1::Approximation& approximation);
MeshInfo FromProto(const v1::Mesh& mesh);
FieldOrigin FromProto(v1::AnswerOrigin origin);
FieldStatistics FromProto(const v1::SolveStatistics& statistics);
Capabilities FromProto(const v1::GetCapabilitiesResponse& response);
// `vertex_count` comes from the answer's header.
SolveProgress FromProto(const v1::SolveProgress& progress,
                        uint64_t vertex_count);
v1::Approximation ToProto(const Approximation& approximation);
v1::ValueType ToProto(ValueType type);
v1::Priority ToProto(Priority priority);

// "fwp-ch" for ALGORITHM_FWP_CH. The name follows from the protocol's name.
std::string AlgorithmName(v1::Algorithm algorithm);

// ALGORITHM_UNSPECIFIED for an empty name. Errors: INVALID_ARGUMENT naming the
// algorithm and those that are known.
absl::StatusOr<v1::Algorithm> ToProto(std::string_view algorithm);

inline bool HasOffset(const SurfacePoint&) { return false; }
inline bool HasOffset(const Source& source) { return source.offset != 0; }

// The numbers of places, if each is a vertex and nothing else; empty otherwise.
template <typename Place>
std::vector<uint32_t> PackedVertices(std::span<const Place> places) {
  std::vector<uint32_t> vertices;
  vertices.reserve(places.size());
  for (const Place& place : places) {
    const VertexPoint* const vertex = AsVertex(place);
    if (vertex == nullptr || HasOffset(place)) return {};
    vertices.push_back(vertex->vertex);
  }
  return vertices;
}

// The targets of a question; vertices in the short form.
template <typename Request>
void AddTargets(std::span<const SurfacePoint> targets, Request& request) {
  const std::vector<uint32_t> vertices = PackedVertices(targets);
  request.mutable_vertex_targets()->Add(vertices.begin(), vertices.end());
  if (!vertices.empty()) return;
  for (const SurfacePoint& target : targets) {
    *request.add_targets() = codec::ToProto(target);
  }
}

// The same of sources, where the question has a short form.
template <typename Request, typename Place>
void AddSources(const std::vector<Place>& sources, Request& request) {
  if constexpr (requires { request.vertex_sources(); }) {
    const std::vector<uint32_t> vertices =
        PackedVertices(std::span<const Place>(sources));
    request.mutable_vertex_sources()->Add(vertices.begin(), vertices.end());
    if (!vertices.empty()) return;
  }
  for (const Place& source : sources) {
    *request.add_sources() = codec::ToProto(source);
  }
}

// Puts the directions of lines, of one kind, into a request.
struct Directions {
  void operator()(const std::vector<double>& angles) const {
    request.mutable_angles()->Add(angles.begin(), angles.end());
  }
  void operator()(const std::vector<Point>& vectors) const {
    for (const Point& vector : vectors) {
      request.mutable_vectors()->Add(vector.begin(), vector.end());
    }
  }
  void operator()(const std::vector<SurfacePoint>& towards) const {
    for (const SurfacePoint& place : towards) {
      *request.add_towards() = codec::ToProto(place);
    }
  }

  v1::TraceLinesRequest& request;
};

// A request with the members of `query`, but for pairs.
// Errors: INVALID_ARGUMENT for an unknown algorithm.
template <typename Request, typename Query>
absl::StatusOr<Request> MakeRequest(const Query& query) {
  absl::StatusOr<v1::Algorithm> algorithm = ToProto(query.algorithm);
  if (!algorithm.ok()) return algorithm.status();
  Request request;
  request.set_mesh_digest(query.mesh_digest);
  request.set_algorithm(*algorithm);
  request.set_priority(ToProto(query.priority));
  if constexpr (requires { query.approximation; }) {
    if (query.approximation != Approximation()) {
      *request.mutable_approximation() = ToProto(query.approximation);
    }
  }
  if constexpr (requires { query.tolerance; }) {
    if (query.tolerance != 0) request.set_tolerance(query.tolerance);
  }
  if constexpr (requires { query.sources; }) {
    AddSources(query.sources, request);
  }
  if constexpr (requires { query.targets; }) {
    AddTargets<Request>(query.targets, request);
  }
  if constexpr (requires { query.source; }) {
    *request.mutable_source() = codec::ToProto(query.source);
  }
  if constexpr (requires { query.value_type; }) {
    request.set_value_type(ToProto(query.value_type));
  }
  if constexpr (requires { query.radius; }) {
    if (query.radius.has_value()) request.set_radius(*query.radius);
  }
  if constexpr (requires { query.count; }) request.set_count(query.count);
  if constexpr (requires { query.levels; }) {
    request.mutable_levels()->Add(query.levels.begin(), query.levels.end());
    if (query.chord_error != 0) request.set_chord_error(query.chord_error);
  }
  if constexpr (requires { query.directions; }) {
    std::visit(Directions{request}, query.directions);
    request.mutable_lengths()->Add(query.lengths.begin(), query.lengths.end());
  }
  if constexpr (requires { query.paths; }) request.set_paths(query.paths);
  if constexpr (requires { query.sparse; }) {
    request.set_layout(query.sparse ? v1::MATRIX_LAYOUT_SPARSE
                                    : v1::MATRIX_LAYOUT_DENSE);
  }
  if constexpr (requires { query.stop_after_targets; }) {
    if (query.stop_after_targets.has_value()) {
      request.set_stop_after_targets(*query.stop_after_targets);
    }
    const auto add = [&request](bool is_wanted, v1::FieldQuantity quantity) {
      if (is_wanted) request.add_quantities(quantity);
    };
    add(query.nearest_sources, v1::FIELD_QUANTITY_NEAREST_SOURCE);
    add(query.gradients, v1::FIELD_QUANTITY_GRADIENT);
    add(query.certified_errors, v1::FIELD_QUANTITY_CERTIFIED_ERROR);
  }
  return request;
}

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_TRANSLATE_H_
