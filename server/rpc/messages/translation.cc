#include "server/rpc/messages/translation.h"

#include <algorithm>
#include <initializer_list>
#include <limits>
#include <variant>
#include <vector>

#include "absl/strings/ascii.h"
#include "absl/strings/str_cat.h"
#include "codec/algorithms.h"
#include "codec/mesh_format.h"
#include "codec/mesh_summary.h"
#include "codec/places.h"
#include "geodesic_types/algorithms.h"
#include "geodesic_types/field_path.h"
#include "server/engine/base/argument_checks.h"

namespace geodesic::server {
namespace {

// `things` is what the limit counts, `limit_name` its name, both for messages.
absl::Status AddAll(
    const google::protobuf::RepeatedPtrField<v1::Source>& sources,
    const char* things, const char* limit_name, uint64_t limit,
    uint64_t max_curve_points, Query& query) {
  absl::Status status = CheckCount(things, sources.size(), limit_name, limit);
  uint64_t curve_points = 0;
  for (const v1::Source& source : sources) {
    curve_points += source.curve().points_size();
  }
  status.Update(CheckCount("curve points", curve_points, "max_curve_points",
                           max_curve_points));
  if (!status.ok()) return status;
  query.sources.reserve(sources.size());
  for (int i = 0; i < sources.size(); ++i) {
    absl::StatusOr<Source> source = codec::FromProto(sources[i], "");
    // Only what is wrong is named.
    if (!source.ok()) {
      return codec::FromProto(sources[i], absl::StrCat("sources[", i, "]"))
          .status();
    }
    query.sources.push_back(*std::move(source));
  }
  return absl::OkStatus();
}

// `things` may come as messages, or as numbers of vertices, e.g. "pairs" and
// "vertex_pairs".
absl::Status CheckOneForm(const std::string& things, int messages,
                          int vertices) {
  if (messages == 0 || vertices == 0) return absl::OkStatus();
  const std::string packed = absl::StrCat("vertex_", things);
  return InvalidField(packed, absl::StrCat("the request has ", things, " and ",
                                           packed, ": use one"));
}

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
      case v1::FIELD_QUANTITY_CERTIFIED_ERROR:
        extras.certified_errors = true;
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

absl::StatusOr<std::vector<SurfacePoint>> ReadPoints(
    const google::protobuf::RepeatedPtrField<v1::SurfacePoint>& points,
    const PackedVertices& vertices, const std::string& name, uint64_t limit) {
  absl::Status status = CheckOneForm(name, points.size(), vertices.size());
  status.Update(
      CheckCount(name, points.size() + vertices.size(), "max_targets", limit));
  if (!status.ok()) return status;
  if (vertices.empty()) return codec::FromProto(points, name);
  std::vector<SurfacePoint> places;
  places.reserve(vertices.size());
  for (const uint32_t v : vertices) places.push_back(VertexPoint{v});
  return places;
}

absl::Status AddTargets(
    const google::protobuf::RepeatedPtrField<v1::SurfacePoint>& targets,
    const PackedVertices& vertex_targets, const Limits& limits, Query& query) {
  absl::StatusOr<std::vector<SurfacePoint>> points =
      ReadPoints(targets, vertex_targets, "targets", limits.max_targets);
  if (points.ok()) query.targets = *std::move(points);
  return points.status();
}

absl::StatusOr<LineQuestion> ReadLines(const v1::TraceLinesRequest& request,
                                       const Limits& limits) {
  LineQuestion lines;
  absl::StatusOr<std::vector<SurfacePoint>> sources =
      ReadPoints(request.sources(), request.vertex_sources(), "sources",
                 limits.max_targets);
  if (!sources.ok()) return sources.status();
  lines.sources = *std::move(sources);
  const auto& vectors = request.vectors();
  if (vectors.size() % 3 != 0) {
    return InvalidField("vectors",
                        absl::StrCat("vectors has ", vectors.size(),
                                     " numbers; a vector has three"));
  }
  if ((vectors.empty() ? 0 : 1) + (request.angles_size() > 0 ? 1 : 0) +
          (request.towards_size() > 0 ? 1 : 0) >
      1) {
    return InvalidField("vectors",
                        "the request has directions in several forms: angles, "
                        "vectors and towards; use one");
  }
  absl::Status status =
      CheckCount("lines",
                 std::max({request.angles_size(), vectors.size() / 3,
                           request.towards_size(), request.lengths_size()}),
                 "max_targets", limits.max_targets);
  if (!status.ok()) return status;
  lines.directions.assign(request.angles().begin(), request.angles().end());
  for (int i = 0; i < vectors.size(); i += 3) {
    lines.directions.push_back(
        Point{vectors[i], vectors[i + 1], vectors[i + 2]});
  }
  const absl::StatusOr<std::vector<SurfacePoint>> towards =
      codec::FromProto(request.towards(), "towards");
  if (!towards.ok()) return towards.status();
  lines.directions.insert(lines.directions.end(), towards->begin(),
                          towards->end());
  lines.lengths.assign(request.lengths().begin(), request.lengths().end());
  return lines;
}

absl::Status AddSources(
    const google::protobuf::RepeatedPtrField<v1::Source>& sources,
    const Limits& limits, Query& query) {
  return AddAll(sources, "sources", "max_sources", limits.max_sources,
                limits.max_curve_points, query);
}

absl::Status AddRows(
    const google::protobuf::RepeatedPtrField<v1::Source>& sources,
    const PackedVertices& vertex_sources, const Limits& limits, Query& query) {
  absl::Status status =
      CheckOneForm("sources", sources.size(), vertex_sources.size());
  status.Update(CheckCount("rows", vertex_sources.size(), "max_matrix_rows",
                           limits.max_matrix_rows));
  if (!status.ok()) return status;
  query.sources.reserve(vertex_sources.size());
  for (const uint32_t v : vertex_sources) {
    query.sources.push_back({VertexPoint{v}, 0});
  }
  return AddAll(sources, "rows", "max_matrix_rows", limits.max_matrix_rows,
                limits.max_curve_points, query);
}

absl::Status AddPairs(const v1::ComputePairsRequest& request,
                      const Limits& limits, std::vector<PointPair>& pairs) {
  const PackedVertices& vertices = request.vertex_pairs();
  absl::Status status =
      CheckOneForm("pairs", request.pairs_size(), vertices.size());
  if (!status.ok()) return status;
  if (vertices.size() % 2 != 0) {
    return InvalidField("vertex_pairs",
                        absl::StrCat("vertex_pairs has ", vertices.size(),
                                     " vertices; a pair has two"));
  }
  const size_t count = request.pairs_size() + vertices.size() / 2;
  status = CheckCount("pairs", count, "max_pairs", limits.max_pairs);
  if (!status.ok()) return status;
  pairs.reserve(count);
  for (int i = 0; i < vertices.size(); i += 2) {
    pairs.push_back({VertexPoint{vertices[i]}, VertexPoint{vertices[i + 1]}});
  }
  for (int i = 0; i < request.pairs_size(); ++i) {
    const std::string field = absl::StrCat("pairs[", i, "].");
    const v1::PointPair& pair = request.pairs(i);
    absl::StatusOr<SurfacePoint> source =
        codec::FromProto(pair.source(), field + "source");
    if (!source.ok()) return source.status();
    absl::StatusOr<SurfacePoint> target =
        codec::FromProto(pair.target(), field + "target");
    if (!target.ok()) return target.status();
    pairs.push_back({*source, *target});
  }
  return absl::OkStatus();
}

absl::Status Unknown(const std::string& field, int number) {
  return InvalidField(field, absl::StrCat(field, " is ", number,
                                          ", which this server does not know"));
}

double RelativeTolerance(const AlgorithmChoice& choice,
                         double certified_error) {
  return std::holds_alternative<MethodChoice>(choice)
             ? std::numeric_limits<double>::infinity()
             : std::max(certified_error, kRelativeTolerance);
}

v1::AnswerOrigin ToProto(FieldOrigin origin) {
  switch (origin) {
    case FieldOrigin::kComputed:
      return v1::ANSWER_ORIGIN_COMPUTED;
    case FieldOrigin::kJoined:
      return v1::ANSWER_ORIGIN_JOINED;
    case FieldOrigin::kCached:
      return v1::ANSWER_ORIGIN_CACHED;
  }
  return v1::ANSWER_ORIGIN_UNSPECIFIED;
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

v1::PairCounts ToProto(const PairCounts& counts) {
  v1::PairCounts proto;
  proto.set_searched(counts.searched);
  proto.set_from_fields(counts.from_fields);
  proto.set_from_cache(counts.from_cache);
  return proto;
}

v1::AnswerHeader MakeHeader(const ResidentMesh& mesh,
                            const AlgorithmChoice& algorithm,
                            const std::string& version) {
  v1::AnswerHeader header;
  header.set_mesh_digest(mesh.digest);
  header.set_vertex_count(mesh.mesh->vertex_count());
  for (std::string& note : Notes(mesh.summary)) {
    header.add_mesh_notes(std::move(note));
  }
  header.set_algorithm(codec::ToProto(algorithm));
  header.set_server_version(version);
  if (const auto* method = std::get_if<MethodChoice>(&algorithm)) {
    *header.mutable_approximation() = codec::ToProto(*method);
  }
  return header;
}

absl::StatusOr<AlgorithmChoice> ReadAlgorithm(
    const QuestionInfo& question, v1::Algorithm algorithm,
    const v1::Approximation& approximation, double tolerance) {
  absl::StatusOr<AlgorithmChoice> choice =
      codec::FromProto(algorithm, approximation);
  if (!choice.ok()) return choice;
  if (const auto* method = std::get_if<MethodChoice>(&*choice)) {
    absl::Status status = Validate(*method);
    if (!status.ok()) {
      return WithFieldPath(
          status, absl::StrCat("approximation.", *FieldPathOf(status)));
    }
  }
  absl::Status status = CheckAlgorithm(question, *choice, tolerance);
  if (!status.ok()) return status;
  return choice;
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
  status = AddTargets(request.targets(), request.vertex_targets(), limits,
                      result.query);
  if (!status.ok()) return status;
  if (request.has_stop_after_targets()) {
    // To the engine the largest number means no limit.
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

v1::Mesh ToProto(const MeshDescription& mesh) {
  v1::Mesh proto;
  proto.set_digest(mesh.digest);
  codec::ToProto(mesh.summary, proto);
  for (std::string& note : Notes(mesh.summary)) {
    proto.add_notes(std::move(note));
  }
  proto.set_resident_bytes(mesh.resident_bytes);
  proto.set_stored_bytes(mesh.stored_bytes);
  proto.set_landmark_count(mesh.landmarks);
  for (const MethodDescription& method : mesh.methods) {
    v1::PreparedMethod& prepared = *proto.add_prepared_methods();
    prepared.set_algorithm(codec::ToProto(method.choice.method));
    *prepared.mutable_approximation() = codec::ToProto(method.choice);
    prepared.set_prepared_bytes(method.bytes);
    prepared.set_prepare_seconds(method.prepare_seconds);
  }
  return proto;
}

v1::MeshFormat ToProto(const UploadFormat& format) {
  return format == kArrays ? v1::MESH_FORMAT_ARRAYS : codec::ToProto(*format);
}

v1::FileDigest ToProto(const FileKey& file) {
  v1::FileDigest proto;
  proto.set_format(ToProto(file.format));
  proto.set_sha256(file.sha256);
  if (file.welding.kind == Welding::Kind::kWithin) {
    proto.set_weld_distance(file.welding.distance);
  }
  proto.set_keep_seams(file.welding.kind == Welding::Kind::kNone);
  return proto;
}

namespace {

// Of an UploadHeader or a FileDigest, whose path is `path`. Arrays are joined
// only if that is asked for.
template <typename Message>
absl::StatusOr<Welding> WeldingFromProto(const Message& message,
                                         const UploadFormat& format,
                                         const std::string& path) {
  if (message.has_weld_distance() && message.keep_seams()) {
    return InvalidField(absl::StrCat(path, "keep_seams"),
                        absl::StrCat(path, "keep_seams and ", path,
                                     "weld_distance exclude each other"));
  }
  if (message.has_weld_distance()) {
    const Welding welding{.kind = Welding::Kind::kWithin,
                          .distance = message.weld_distance()};
    const absl::Status status = Validate(welding);
    if (status.ok()) return welding;
    const std::string field = absl::StrCat(path, "weld_distance");
    return InvalidField(field, absl::StrCat(field, ": ", status.message()));
  }
  const bool keeps = message.keep_seams() || format == kArrays;
  return Welding{.kind = keeps ? Welding::Kind::kNone : Welding::Kind::kSeams};
}

}  // namespace

absl::StatusOr<FileKey> FromProto(const v1::FileDigest& file,
                                  const std::string& path) {
  absl::StatusOr<UploadFormat> format =
      FromProto(file.format(), absl::StrCat(path, ".format"));
  if (!format.ok()) return format.status();
  absl::StatusOr<Welding> welding =
      WeldingFromProto(file, *format, absl::StrCat(path, "."));
  if (!welding.ok()) return welding.status();
  return FileKey{*format, file.sha256(), *welding};
}

absl::StatusOr<UploadFormat> FromProto(v1::MeshFormat format,
                                       std::string_view field) {
  if (format == v1::MESH_FORMAT_ARRAYS) return kArrays;
  const UploadFormat known = codec::FromProto(format);
  if (known.has_value()) return known;
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
  absl::StatusOr<Welding> welding =
      WeldingFromProto(header, *format, "header.");
  if (!welding.ok()) return welding.status();
  return UploadHeader{.format = *format,
                      .size_bytes = header.size_bytes(),
                      .vertex_count = header.vertex_count(),
                      .face_count = header.face_count(),
                      .expected_digest = header.expected_digest(),
                      .welding = *welding};
}

}  // namespace geodesic::server
