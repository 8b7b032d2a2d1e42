#include "codec/places.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <variant>

#include "absl/status/status.h"
#include "absl/strings/str_cat.h"
#include "geodesic_types/field_path.h"

namespace geodesic::codec {
namespace {

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

// The place of a v1::SurfacePoint, or of a v1::Source that is not a curve:
// their fields have the same names.
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

template <typename Message>
void SetPoint(const SurfacePoint& point, Message& message) {
  if (const auto* vertex = std::get_if<VertexPoint>(&point)) {
    message.set_vertex(vertex->vertex);
  } else if (const auto* edge = std::get_if<EdgePoint>(&point)) {
    message.mutable_edge()->set_from(edge->from);
    message.mutable_edge()->set_to(edge->to);
    message.mutable_edge()->set_t(edge->t);
  } else if (const auto* face = std::get_if<FacePoint>(&point)) {
    message.mutable_face()->set_face(face->face);
    message.mutable_face()->mutable_weights()->Add(face->weights.begin(),
                                                   face->weights.end());
  }
}

}  // namespace

absl::StatusOr<SurfacePoint> FromProto(const v1::SurfacePoint& point,
                                       const std::string& field) {
  return PointFrom(point, field);
}

absl::StatusOr<std::vector<SurfacePoint>> FromProto(
    const google::protobuf::RepeatedPtrField<v1::SurfacePoint>& points,
    const std::string& field) {
  std::vector<SurfacePoint> result;
  result.reserve(points.size());
  for (int i = 0; i < points.size(); ++i) {
    const absl::StatusOr<SurfacePoint> point = PointFrom(points[i], "");
    // Only what is wrong is named: to do so takes longer than to read it.
    if (!point.ok()) {
      return PointFrom(points[i], absl::StrCat(field, "[", i, "]")).status();
    }
    result.push_back(*point);
  }
  return result;
}

absl::StatusOr<Source> FromProto(const v1::Source& source,
                                 const std::string& field) {
  if (!source.has_curve()) {
    absl::StatusOr<SurfacePoint> point = PointFrom(source, field);
    if (!point.ok()) return point.status();
    return Source{*point, source.offset()};
  }
  absl::StatusOr<std::vector<SurfacePoint>> points =
      FromProto(source.curve().points(), absl::StrCat(field, ".curve.points"));
  if (!points.ok()) return points.status();
  return Source{Curve{*std::move(points)}, source.offset()};
}

v1::SurfacePoint ToProto(const SurfacePoint& point) {
  v1::SurfacePoint message;
  SetPoint(point, message);
  return message;
}

v1::Source ToProto(const Source& source) {
  v1::Source message;
  message.set_offset(source.offset);
  if (const auto* point = std::get_if<SurfacePoint>(&source.place)) {
    SetPoint(*point, message);
    return message;
  }
  for (const SurfacePoint& point : std::get<Curve>(source.place).points) {
    SetPoint(point, *message.mutable_curve()->add_points());
  }
  return message;
}

}  // namespace geodesic::codec
