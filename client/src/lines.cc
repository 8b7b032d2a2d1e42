#include "lines.h"

#include <algorithm>
#include <utility>

#include "absl/strings/str_cat.h"

namespace geodesic::client {
namespace {

absl::StatusOr<SurfacePoint> ToPoint(uint8_t kind,
                                     const std::array<uint32_t, 2>& numbers,
                                     const std::array<double, 3>& weights) {
  switch (kind) {
    case 0:
      return VertexPoint{numbers[0]};
    case 1:
      return EdgePoint{numbers[0], numbers[1], weights[0]};
    case 2:
      return FacePoint{numbers[0], weights};
    default:
      return absl::DataLossError(
          absl::StrCat("the server sent a point of kind ", kind));
  }
}

}  // namespace

absl::StatusOr<size_t> Groups::Take(
    size_t there, bool is_complete, uint64_t end,
    const std::function<absl::Status(uint64_t, size_t, size_t)>& take) {
  size_t first = 0;
  for (; due < std::min<uint64_t>(end, ends.size()); ++due) {
    const uint64_t size = ends[due] - taken - first;
    if (size > there - first) break;  // Immense if ends descend.
    absl::Status status = take(due, first, size);
    if (!status.ok()) return status;
    first += size;
  }
  taken += first;
  if (is_complete && (first < there || due < ends.size())) {
    return absl::DataLossError(
        absl::StrCat("the server's answer ended within line or row ", due));
  }
  return first;
}

Lines::Lines(int64_t count, codec::AnswerReader* reader) : reader_(*reader) {
  constexpr int64_t kPoints = codec::AnswerReader::kPoints;
  reader->Collect("line_end", {count}, &groups_.ends);
  reader->Collect("position", {kPoints, 3}, &positions_);
  reader->Collect("point_kind", {kPoints}, &kinds_);
  reader->Collect("point_numbers", {kPoints, 2}, &numbers_);
  reader->Collect("point_weights", {kPoints, 3}, &weights_);
}

absl::Status Lines::Take(const std::function<absl::Status(Polyline)>& on_line,
                         uint64_t end) {
  const size_t there = std::min(
      {positions_.size(), kinds_.size(), numbers_.size(), weights_.size()});
  const absl::StatusOr<size_t> taken = groups_.Take(
      there, reader_.has_trailer(), end,
      [&](uint64_t, size_t first, size_t size) -> absl::Status {
        Polyline line;
        line.points.reserve(size);
        for (size_t i = first; i < first + size; ++i) {
          auto point = ToPoint(kinds_[i], numbers_[i], weights_[i]);
          if (!point.ok()) return point.status();
          line.points.push_back(*std::move(point));
        }
        const auto from = positions_.begin() + static_cast<ptrdiff_t>(first);
        line.positions.assign(from, from + static_cast<ptrdiff_t>(size));
        return on_line(std::move(line));
      });
  if (!taken.ok()) return taken.status();
  DropFront(*taken, &positions_);
  DropFront(*taken, &kinds_);
  DropFront(*taken, &numbers_);
  DropFront(*taken, &weights_);
  return absl::OkStatus();
}

}  // namespace geodesic::client
