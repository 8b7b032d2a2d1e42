#include "assemblers.h"

#include <algorithm>
#include <string>
#include <utility>

#include "absl/strings/str_cat.h"
#include "translate.h"
#include "wire_values.h"

namespace geodesic::client {
namespace {

// Appends the elements that `bytes` holds; they are elements `first` and
// following of the `count` there are to be.
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

}  // namespace

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
    absl::StatusOr<SurfacePoint> point = FromProto(message);
    if (!point.ok()) return point.status();
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
  return absl::OkStatus();  // A part that a later server may add.
}

absl::StatusOr<MeshArrays> MeshAssembler::Finish() && {
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

}  // namespace geodesic::client
