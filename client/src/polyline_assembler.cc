#include "polyline_assembler.h"

#include <string>
#include <utility>

#include "absl/strings/str_cat.h"
#include "translate.h"
#include "wire_values.h"

namespace geodesic::client {

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

}  // namespace geodesic::client
