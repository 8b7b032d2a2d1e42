#include "server/rpc/messages/surface_translation.h"

#include <cstdint>
#include <limits>
#include <utility>
#include <variant>

#include "absl/strings/str_cat.h"
#include "geodesic/field_path.h"
#include "server/engine/base/argument_checks.h"

namespace geodesic::server {
namespace {

absl::StatusOr<uint32_t> Number(uint64_t number, const std::string& field) {
  // Wider than what any mesh holds; the rest is for the engine to judge.
  if (number > std::numeric_limits<uint32_t>::max()) {
    return InvalidField(field, absl::StrCat(field, " ", number,
                                            " is out of range: numbers of "
                                            "vertices and faces have 32 bits"));
  }
  return static_cast<uint32_t>(number);
}

absl::StatusOr<SurfacePoint> VertexFrom(uint64_t vertex,
                                        const std::string& field) {
  const absl::StatusOr<uint32_t> number =
      Number(vertex, absl::StrCat(field, ".vertex"));
  if (!number.ok()) return number.status();
  return VertexPoint{*number};
}

absl::StatusOr<SurfacePoint> EdgeFrom(const v1::EdgePoint& edge,
                                      const std::string& field) {
  const absl::StatusOr<uint32_t> from =
      Number(edge.from(), absl::StrCat(field, ".edge.from"));
  if (!from.ok()) return from.status();
  const absl::StatusOr<uint32_t> to =
      Number(edge.to(), absl::StrCat(field, ".edge.to"));
  if (!to.ok()) return to.status();
  return EdgePoint{.from = *from, .to = *to, .t = edge.t()};
}

absl::StatusOr<SurfacePoint> FaceFrom(const v1::FacePoint& face,
                                      const std::string& field) {
  const absl::StatusOr<uint32_t> number =
      Number(face.face(), absl::StrCat(field, ".face.face"));
  if (!number.ok()) return number.status();
  if (face.weights_size() != 3) {
    const std::string weights = absl::StrCat(field, ".face.weights");
    return InvalidField(weights,
                        absl::StrCat(weights, " has ", face.weights_size(),
                                     " values; a face has three corners"));
  }
  return FacePoint{
      .face = *number,
      .weights = {face.weights(0), face.weights(1), face.weights(2)}};
}

absl::Status NoPlace(const std::string& field) {
  return InvalidField(field, absl::StrCat(field, " has no place"));
}

}  // namespace

absl::StatusOr<SurfacePoint> FromProto(const v1::SurfacePoint& point,
                                       const std::string& field) {
  switch (point.place_case()) {
    case v1::SurfacePoint::kVertex:
      return VertexFrom(point.vertex(), field);
    case v1::SurfacePoint::kEdge:
      return EdgeFrom(point.edge(), field);
    case v1::SurfacePoint::kFace:
      return FaceFrom(point.face(), field);
    case v1::SurfacePoint::PLACE_NOT_SET:
      break;
  }
  return NoPlace(field);
}

absl::StatusOr<std::vector<SurfacePoint>> FromProto(
    const google::protobuf::RepeatedPtrField<v1::SurfacePoint>& points,
    const std::string& field) {
  std::vector<SurfacePoint> result;
  result.reserve(points.size());
  for (int i = 0; i < points.size(); ++i) {
    absl::StatusOr<SurfacePoint> point =
        FromProto(points[i], absl::StrCat(field, "[", i, "]"));
    if (!point.ok()) return point.status();
    result.push_back(*point);
  }
  return result;
}

absl::StatusOr<std::vector<SurfacePoint>> TargetsFromProto(
    const google::protobuf::RepeatedPtrField<v1::SurfacePoint>& targets,
    const Limits& limits) {
  absl::Status status =
      CheckCount("targets", targets.size(), "max_targets", limits.max_targets);
  if (!status.ok()) return status;
  return FromProto(targets, "targets");
}

namespace {

absl::StatusOr<std::variant<SurfacePoint, Curve>> PlaceFrom(
    const v1::Source& source, const std::string& field) {
  switch (source.place_case()) {
    case v1::Source::kVertex:
      return VertexFrom(source.vertex(), field);
    case v1::Source::kEdge:
      return EdgeFrom(source.edge(), field);
    case v1::Source::kFace:
      return FaceFrom(source.face(), field);
    case v1::Source::kCurve: {
      absl::StatusOr<std::vector<SurfacePoint>> points = FromProto(
          source.curve().points(), absl::StrCat(field, ".curve.points"));
      if (!points.ok()) return points.status();
      return Curve{*std::move(points)};
    }
    case v1::Source::PLACE_NOT_SET:
      break;
  }
  return NoPlace(field);
}

// `things` and `limit_name` are what the limit counts and is called.
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
    auto place = PlaceFrom(sources[i], absl::StrCat("sources[", i, "]"));
    if (!place.ok()) return place.status();
    query.sources.push_back({*std::move(place), sources[i].offset()});
  }
  return absl::OkStatus();
}

}  // namespace

absl::Status AddSources(
    const google::protobuf::RepeatedPtrField<v1::Source>& sources,
    const Limits& limits, Query& query) {
  return AddAll(sources, "sources", "max_sources", limits.max_sources,
                limits.max_curve_points, query);
}

absl::Status AddRows(
    const google::protobuf::RepeatedPtrField<v1::Source>& sources,
    const Limits& limits, Query& query) {
  return AddAll(sources, "rows", "max_matrix_rows", limits.max_matrix_rows,
                limits.max_curve_points, query);
}

void SetSurfacePoint(const SurfacePoint& from, v1::SurfacePoint& to) {
  if (const auto* vertex = std::get_if<VertexPoint>(&from)) {
    to.set_vertex(vertex->vertex);
  } else if (const auto* edge = std::get_if<EdgePoint>(&from)) {
    to.mutable_edge()->set_from(edge->from);
    to.mutable_edge()->set_to(edge->to);
    to.mutable_edge()->set_t(edge->t);
  } else if (const auto* face = std::get_if<FacePoint>(&from)) {
    to.mutable_face()->set_face(face->face);
    to.mutable_face()->mutable_weights()->Add(face->weights.begin(),
                                              face->weights.end());
  }
}

}  // namespace geodesic::server
