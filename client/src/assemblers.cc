#include "assemblers.h"

#include <algorithm>
#include <string>
#include <utility>

#include "absl/strings/str_cat.h"
#include "translate.h"

namespace geodesic::client {
namespace {

// Appends the elements that `bytes` holds, which begin with number `first` of
// `count`.
template <typename Element>
absl::Status Append(std::string_view what, const std::string& bytes,
                    uint64_t first, uint64_t count,
                    std::vector<Element>* elements) {
  const size_t had = elements->size();
  if (first != had || bytes.size() / sizeof(Element) > count - had ||
      !AppendElements(bytes, elements)) {
    return absl::DataLossError(absl::StrCat(
        "the server sent ", bytes.size(), " bytes of ", std::string(what),
        " from number ", first, " after ", had, " of ", count));
  }
  return absl::OkStatus();
}

using v1::ComputeFieldResponse;

// How many values to reserve on the server's word alone. That takes address
// space only, until values arrive. Larger fields grow as vectors do.
constexpr uint64_t kMostReserved = uint64_t{1} << 24;

}  // namespace

absl::Status CheckCount(std::string_view items, uint64_t received,
                        uint64_t expected) {
  if (received == expected) return absl::OkStatus();
  return absl::DataLossError(absl::StrCat("the server sent ", received, " of ",
                                          expected, " ", std::string(items)));
}

absl::Status PolylineAssembler::Consume(const v1::PolylinePiece& piece,
                                        Polyline* line) {
  const auto count = static_cast<uint64_t>(piece.points_size());
  const uint64_t had = line->points.size();
  if (complete()) due_ = piece.point_count();
  // Only a line without points has a piece without points.
  if (piece.first_point() != had || piece.point_count() != had + due_ ||
      count > due_ || (count == 0 && due_ != 0) ||
      piece.positions().size() != count * sizeof(Point)) {
    return absl::DataLossError(absl::StrCat(
        "the server sent ", count, " points from number ", piece.first_point(),
        " of a line of ", piece.point_count(), " after ", had, " of them"));
  }
  for (const v1::SurfacePoint& message : piece.points()) {
    absl::StatusOr<SurfacePoint> point = codec::FromProto(message, "points");
    if (!point.ok()) {
      return absl::DataLossError(absl::StrCat(
          "the server sent a point that is none: ", point.status().message()));
    }
    line->points.push_back(*std::move(point));
  }
  AppendElements(piece.positions(), &line->positions);
  due_ -= count;
  return absl::OkStatus();
}

absl::Status RowAssembler::Consume(const RowPiece& piece,
                                   uint64_t column_count) {
  if (complete_) {
    numbers_.clear();
    values_.clear();
  }
  const size_t had = values_.size();
  const bool count_fits = has_numbers_ ? piece.value_count <= column_count
                                       : piece.value_count == column_count;
  if (piece.row != row_count_ || piece.offset != had || !count_fits ||
      !AppendValues(piece.values, value_type_, &values_) ||
      !AppendElements(piece.numbers, &numbers_) ||
      numbers_.size() != (has_numbers_ ? values_.size() : 0) ||
      values_.size() > piece.value_count ||
      (values_.size() == had && piece.value_count != had)) {
    return absl::DataLossError(
        absl::StrCat("the server sent row ", piece.row, " from value ",
                     piece.offset, " of ", piece.value_count, " where row ",
                     row_count_, " from value ", had, " was due"));
  }
  if (std::any_of(numbers_.begin() + (has_numbers_ ? had : 0), numbers_.end(),
                  [&](uint32_t number) { return number >= column_count; })) {
    return absl::DataLossError(absl::StrCat("the server sent row ", piece.row,
                                            " with a column beyond its ",
                                            column_count));
  }
  complete_ = values_.size() == piece.value_count;
  if (complete_) ++row_count_;
  return absl::OkStatus();
}

absl::Status MeshAssembler::Consume(const v1::ReadMeshResponse& message) {
  if (message.has_header()) {
    if (has_header_) {
      return absl::DataLossError("the server described one mesh twice");
    }
    has_header_ = true;
    vertex_count_ = message.header().vertex_count();
    face_count_ = message.header().face_count();
    return absl::OkStatus();
  }
  if (!has_header_) {
    return absl::DataLossError("the server sent a mesh without its header");
  }
  if (message.has_vertices()) {
    return Append("vertices", message.vertices().positions(),
                  message.vertices().first_vertex(), vertex_count_,
                  &mesh_.positions);
  }
  if (message.has_faces()) {
    return Append("faces", message.faces().indices(),
                  message.faces().first_face(), face_count_, &mesh_.triangles);
  }
  if (message.has_joined()) {
    return Append("joined vertices", message.joined().pairs(),
                  message.joined().first_pair(), vertex_count_, &mesh_.joined);
  }
  return absl::OkStatus();  // A part that a later server may add.
}

absl::StatusOr<MeshArrays> MeshAssembler::Finish() && {
  for (const auto& [vertex, into] : mesh_.joined) {
    if (vertex >= vertex_count_ || into >= vertex_count_) {
      return absl::DataLossError(absl::StrCat("the server sent vertex ", vertex,
                                              " joined into ", into, " of ",
                                              vertex_count_));
    }
  }
  if (!has_header_ || mesh_.positions.size() != vertex_count_ ||
      mesh_.triangles.size() != face_count_) {
    return absl::DataLossError(
        absl::StrCat("the server ended the mesh after ", mesh_.positions.size(),
                     " of ", vertex_count_, " vertices and ",
                     mesh_.triangles.size(), " of ", face_count_, " faces"));
  }
  for (size_t face = 0; face < mesh_.triangles.size(); ++face) {
    for (const uint32_t vertex : mesh_.triangles[face]) {
      if (vertex >= vertex_count_) {
        return absl::DataLossError(absl::StrCat("the server sent face ", face,
                                                " with vertex ", vertex, " of ",
                                                vertex_count_));
      }
    }
  }
  return std::move(mesh_);
}

absl::Status FieldAssembler::ConsumeChunk(const v1::FieldChunk& chunk) {
  if (complete_ || on_settled_ != nullptr) {
    return absl::DataLossError(
        "the server sent distances outside the field's stream");
  }
  if (chunk.offset() != received()) {
    return absl::DataLossError(absl::StrCat(
        "the server sent the distances from vertex ", chunk.offset(),
        " where those from vertex ", received(), " were due"));
  }
  if (!chunk.field_id().empty()) field_id_ = chunk.field_id();
  const ValueType type = query_.value_type;
  if (!AppendValues(chunk.distances(), type, &field_.distances) ||
      !AppendElements(chunk.nearest_sources(), &field_.nearest_sources) ||
      !AppendValues(chunk.gradients(), type, &field_.gradients) ||
      !AppendElements(chunk.certified_errors(), &field_.certified_errors)) {
    return absl::DataLossError("the server sent a part of a number");
  }
  if (std::max({received(), field_.nearest_sources.size(),
                field_.gradients.size(), field_.certified_errors.size()}) >
      field_.vertex_count) {
    return absl::DataLossError(absl::StrCat("the server sent more than the ",
                                            field_.vertex_count,
                                            " distances it had announced"));
  }
  return absl::OkStatus();
}

FieldAssembler::Position FieldAssembler::Resume() {
  if (field_id_.empty()) {
    Restart();
    return {};
  }
  has_header_ = false;
  complete_ = false;
  field_.target_distances.clear();
  return {field_id_, received()};
}

void FieldAssembler::Restart() {
  field_ = Field();
  field_id_.clear();
  has_header_ = false;
  complete_ = false;
}

absl::Status FieldAssembler::ConsumeTargets(const v1::TargetChunk& chunk) {
  if (chunk.offset() != field_.target_distances.size() ||
      !AppendValues(chunk.distances(), query_.value_type,
                    &field_.target_distances) ||
      field_.target_distances.size() > query_.targets.size()) {
    return absl::DataLossError(
        "the server sent distances of other targets than were due");
  }
  return absl::OkStatus();
}

absl::Status FieldAssembler::ConsumeSettled(const v1::SettledChunk& chunk) {
  std::vector<uint32_t> vertices;
  std::vector<double> distances;
  if (on_settled_ == nullptr || chunk.offset() != settled_count_ ||
      !AppendElements(chunk.vertices(), &vertices) ||
      !AppendValues(chunk.distances(), query_.value_type, &distances) ||
      vertices.size() != distances.size() ||
      vertices.size() > field_.vertex_count - settled_count_) {
    return absl::DataLossError(
        "the server sent other settled vertices than were due");
  }
  std::vector<SettledVertex> settled;
  settled.reserve(vertices.size());
  for (size_t i = 0; i < vertices.size(); ++i) {
    settled.push_back({vertices[i], distances[i]});
  }
  settled_count_ += settled.size();
  on_settled_(settled);
  return absl::OkStatus();
}

absl::Status FieldAssembler::TakeHeader(const v1::FieldHeader& header) {
  if (has_header_) {
    return absl::DataLossError("the server sent two headers for one query");
  }
  // A stream that is resumed must continue the same field.
  if (!field_id_.empty() && header.vertex_count() != field_.vertex_count) {
    return absl::DataLossError("the server went on with another field");
  }
  has_header_ = true;
  field_.vertex_count = header.vertex_count();
  field_.mesh_digest = header.mesh_digest();
  field_.mesh_notes = {header.mesh_notes().begin(), header.mesh_notes().end()};
  field_.algorithm = AlgorithmName(header.algorithm());
  if (header.has_approximation()) {
    field_.approximation = FromProto(header.approximation());
  }
  field_.origin = FromProto(header.origin());
  if (on_settled_ == nullptr) {
    field_.distances.reserve(std::min(field_.vertex_count, kMostReserved));
  }
  return absl::OkStatus();
}

absl::Status FieldAssembler::Consume(const ComputeFieldResponse& message) {
  if (!has_header_ && !message.has_header()) {
    return absl::DataLossError("the server began a field without accepting it");
  }
  switch (message.part_case()) {
    case ComputeFieldResponse::kHeader:
      return TakeHeader(message.header());
    case ComputeFieldResponse::kProgress:
      if (progress_ != nullptr) {
        progress_(FromProto(message.progress(), field_.vertex_count));
      }
      return absl::OkStatus();
    case ComputeFieldResponse::kChunk:
      return ConsumeChunk(message.chunk());
    case ComputeFieldResponse::kTargets:
      return ConsumeTargets(message.targets());
    case ComputeFieldResponse::kSettled:
      return ConsumeSettled(message.settled());
    case ComputeFieldResponse::kTrailer:
      complete_ = true;
      field_.origin = FromProto(message.trailer().origin());
      field_.statistics = FromProto(message.trailer().statistics());
      field_.relative_tolerance = message.trailer().relative_tolerance();
      field_.server_version = message.trailer().server_version();
      field_.settled_radius = message.trailer().settled_radius();
      if (message.trailer().has_certified_error()) {
        field_.certified_error = message.trailer().certified_error();
      }
      return absl::OkStatus();
    case ComputeFieldResponse::PART_NOT_SET:
      return absl::OkStatus();  // A part that a later server may add.
  }
  return absl::OkStatus();
}

absl::StatusOr<Field> FieldAssembler::Finish() && {
  const bool progressive = on_settled_ != nullptr;
  if (!has_header_ || !complete_ ||
      (!progressive && field_.distances.size() != field_.vertex_count)) {
    return absl::DataLossError(
        absl::StrCat("the server ended the stream after ",
                     progressive ? settled_count_ : field_.distances.size(),
                     " of ", field_.vertex_count, " distances",
                     has_header_ && !complete_ ? " without its trailer" : ""));
  }
  absl::Status status =
      CheckCount("target distances", field_.target_distances.size(),
                 query_.targets.size());
  status.Update(CheckCount("nearest sources", field_.nearest_sources.size(),
                           query_.nearest_sources ? field_.vertex_count : 0));
  status.Update(CheckCount("gradients", field_.gradients.size(),
                           query_.gradients ? field_.vertex_count : 0));
  status.Update(CheckCount("certified errors", field_.certified_errors.size(),
                           query_.certified_errors ? field_.vertex_count : 0));
  if (!status.ok()) return status;
  return std::move(field_);
}

}  // namespace geodesic::client
