#include "server/rpc/messages/surface_translation.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>
#include <variant>

#include "absl/strings/str_cat.h"
#include "geodesic/field_path.h"
#include "server/engine/base/argument_checks.h"
#include "server/rpc/messages/value_bytes.h"

namespace geodesic::server {
namespace {

// A point takes about 50 bytes on the wire.
constexpr uint64_t kPointsPerMessage = 8192;

static_assert(sizeof(Point) == 3 * sizeof(double));

// Sets `result`. Wider numbers are on no mesh; the rest is for the engine to
// judge.
absl::Status SetNumber(uint64_t number, const std::string& field,
                       uint32_t& result) {
  if (number > std::numeric_limits<uint32_t>::max()) {
    return InvalidField(field, absl::StrCat(field, " ", number,
                                            " is out of range: numbers of "
                                            "vertices and faces have 32 bits"));
  }
  result = static_cast<uint32_t>(number);
  return absl::OkStatus();
}

// The place of a v1::SurfacePoint, or of a v1::Source that is no curve.
template <typename Message>
absl::StatusOr<SurfacePoint> PointFrom(const Message& message,
                                       const std::string& field) {
  if (message.has_vertex()) {
    VertexPoint point{};
    absl::Status status = SetNumber(
        message.vertex(), absl::StrCat(field, ".vertex"), point.vertex);
    if (!status.ok()) return status;
    return point;
  }
  if (message.has_edge()) {
    const v1::EdgePoint& edge = message.edge();
    EdgePoint point{.t = edge.t()};
    absl::Status status =
        SetNumber(edge.from(), absl::StrCat(field, ".edge.from"), point.from);
    status.Update(
        SetNumber(edge.to(), absl::StrCat(field, ".edge.to"), point.to));
    if (!status.ok()) return status;
    return point;
  }
  if (message.has_face()) {
    const v1::FacePoint& face = message.face();
    FacePoint point{};
    absl::Status status =
        SetNumber(face.face(), absl::StrCat(field, ".face.face"), point.face);
    if (!status.ok()) return status;
    if (face.weights_size() != 3) {
      const std::string weights = absl::StrCat(field, ".face.weights");
      return InvalidField(weights,
                          absl::StrCat(weights, " has ", face.weights_size(),
                                       " values; a face has three corners"));
    }
    std::copy(face.weights().begin(), face.weights().end(),
              point.weights.begin());
    return point;
  }
  return InvalidField(field, absl::StrCat(field, " has no place"));
}

absl::StatusOr<std::vector<SurfacePoint>> PointsFrom(
    const google::protobuf::RepeatedPtrField<v1::SurfacePoint>& points,
    const std::string& field) {
  std::vector<SurfacePoint> result;
  result.reserve(points.size());
  for (int i = 0; i < points.size(); ++i) {
    absl::StatusOr<SurfacePoint> point =
        PointFrom(points[i], absl::StrCat(field, "[", i, "]"));
    if (!point.ok()) return point.status();
    result.push_back(*point);
  }
  return result;
}

absl::StatusOr<std::variant<SurfacePoint, Curve>> PlaceFrom(
    const v1::Source& source, const std::string& field) {
  if (!source.has_curve()) return PointFrom(source, field);
  absl::StatusOr<std::vector<SurfacePoint>> points =
      PointsFrom(source.curve().points(), absl::StrCat(field, ".curve.points"));
  if (!points.ok()) return points.status();
  return Curve{*std::move(points)};
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

absl::StatusOr<SurfacePoint> FromProto(const v1::SurfacePoint& point,
                                       const std::string& field) {
  return PointFrom(point, field);
}

absl::Status AddTargets(
    const google::protobuf::RepeatedPtrField<v1::SurfacePoint>& targets,
    const Limits& limits, Query& query) {
  absl::Status status =
      CheckCount("targets", targets.size(), "max_targets", limits.max_targets);
  if (!status.ok()) return status;
  absl::StatusOr<std::vector<SurfacePoint>> points =
      PointsFrom(targets, "targets");
  if (points.ok()) query.targets = *std::move(points);
  return points.status();
}

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

void SetPoint(const Point& from, v1::Point& to) {
  to.set_x(from[0]);
  to.set_y(from[1]);
  to.set_z(from[2]);
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

uint64_t SetPiece(std::span<const SurfacePoint> points,
                  std::span<const Point> positions, uint64_t first,
                  v1::PolylinePiece& piece) {
  const uint64_t count =
      std::min<uint64_t>(kPointsPerMessage, points.size() - first);
  piece.set_point_count(points.size());
  piece.set_first_point(first);
  piece.clear_points();
  for (const SurfacePoint& point : points.subspan(first, count)) {
    SetSurfacePoint(point, *piece.add_points());
  }
  SetBytes(positions.subspan(first, count), *piece.mutable_positions());
  return first + count;
}

}  // namespace geodesic::server
