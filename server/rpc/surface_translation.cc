#include "server/rpc/surface_translation.h"

#include <cstdint>
#include <limits>
#include <utility>
#include <variant>

#include "absl/strings/str_cat.h"
#include "server/engine/argument_checks.h"
#include "server/engine/status_details.h"

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

absl::Status CheckCurvePoints(
    const google::protobuf::RepeatedPtrField<v1::Source>& sources,
    const Limits& limits) {
  uint64_t points = 0;
  for (const v1::Source& source : sources) {
    points += source.curve().points_size();
  }
  return CheckCount("curve points", points, "max_curve_points",
                    limits.max_curve_points);
}

absl::Status AddAll(
    const google::protobuf::RepeatedPtrField<v1::Source>& sources, Query& query,
    SourceNumbers& numbers) {
  for (int i = 0; i < sources.size(); ++i) {
    const v1::Source& source = sources[i];
    const std::string field = absl::StrCat("sources[", i, "]");
    absl::StatusOr<SurfacePoint> point;
    switch (source.place_case()) {
      case v1::Source::kVertex:
        point = VertexFrom(source.vertex(), field);
        break;
      case v1::Source::kEdge:
        point = EdgeFrom(source.edge(), field);
        break;
      case v1::Source::kFace:
        point = FaceFrom(source.face(), field);
        break;
      case v1::Source::kCurve: {
        absl::StatusOr<std::vector<SurfacePoint>> points = FromProto(
            source.curve().points(), absl::StrCat(field, ".curve.points"));
        if (!points.ok()) return points.status();
        query.curves.push_back({*std::move(points), source.offset()});
        numbers.curves.push_back(i);
        continue;
      }
      case v1::Source::PLACE_NOT_SET:
        return NoPlace(field);
    }
    if (!point.ok()) return point.status();
    query.sources.push_back({*point, source.offset()});
    numbers.points.push_back(i);
  }
  return absl::OkStatus();
}

}  // namespace

absl::Status AddSources(
    const google::protobuf::RepeatedPtrField<v1::Source>& sources,
    const Limits& limits, Query& query, SourceNumbers& numbers) {
  absl::Status status =
      CheckCount("sources", sources.size(), "max_sources", limits.max_sources);
  status.Update(CheckCurvePoints(sources, limits));
  return status.ok() ? AddAll(sources, query, numbers) : status;
}

absl::Status AddRows(
    const google::protobuf::RepeatedPtrField<v1::Source>& sources,
    const Limits& limits, Query& query, SourceNumbers& numbers) {
  absl::Status status = CheckCount("rows", sources.size(), "max_matrix_rows",
                                   limits.max_matrix_rows);
  status.Update(CheckCurvePoints(sources, limits));
  return status.ok() ? AddAll(sources, query, numbers) : status;
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
