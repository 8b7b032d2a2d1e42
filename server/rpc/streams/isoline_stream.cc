#include "server/rpc/streams/isoline_stream.h"

#include <cmath>
#include <utility>

#include "absl/strings/str_cat.h"
#include "geodesic/field_path.h"
#include "server/engine/base/argument_checks.h"
#include "server/rpc/messages/polyline.h"

namespace geodesic::server {
namespace {

absl::Status CheckLevels(const google::protobuf::RepeatedField<double>& levels,
                         const Limits& limits) {
  if (levels.empty()) {
    return InvalidField("levels", "levels is empty: name at least one");
  }
  for (int i = 0; i < levels.size(); ++i) {
    if (std::isfinite(levels[i]) && levels[i] > 0) continue;
    const std::string field = absl::StrCat("levels[", i, "]");
    return InvalidField(field, absl::StrCat(field, " is ", levels[i],
                                            "; it must be finite and > 0"));
  }
  return CheckCount("levels", levels.size(), "max_levels", limits.max_levels);
}

uint64_t BytesOf(const std::vector<Isoline>& isolines) {
  uint64_t bytes = isolines.capacity() * sizeof(Isoline);
  for (const Isoline& isoline : isolines) {
    bytes += isoline.points.capacity() * sizeof(SurfacePoint) +
             isoline.positions.capacity() * sizeof(Point);
  }
  return bytes;
}

}  // namespace

absl::StatusOr<IsolineStream::Work> IsolineStream::MakeWork() {
  absl::Status status = CheckLevels(request().levels(), engine().limits());
  if (!status.ok()) return status;
  return [levels = std::vector<double>(request().levels().begin(),
                                       request().levels().end())](
             const Mesh& mesh, const ValidQuery& query,
             const SolveOptions& options, Checkpoint& checkpoint,
             ByteReservation& memory) -> absl::StatusOr<std::vector<Isoline>> {
    absl::StatusOr<std::vector<Isoline>> found =
        geodesic::ComputeIsolines(mesh, query, levels, options, checkpoint);
    if (!found.ok()) return found;
    absl::Status room = memory.GrowTo(BytesOf(*found));
    if (!room.ok()) return room;
    return found;
  };
}

absl::StatusOr<bool> IsolineStream::FillPart(
    v1::ComputeIsolinesResponse& message) {
  if (next_isoline_ == result().size()) return false;
  const Isoline& isoline = result()[next_isoline_];
  v1::Isoline& proto = *message.mutable_isoline();
  proto.set_number(next_isoline_);
  proto.set_level(isoline.level);
  proto.set_is_closed(isoline.is_closed);
  next_point_ = SetPiece(isoline.points, isoline.positions, next_point_,
                         *proto.mutable_piece());
  entry().add_bytes(proto.piece().positions().size());
  if (next_point_ == isoline.points.size()) {
    ++next_isoline_;
    next_point_ = 0;
  }
  return true;
}

}  // namespace geodesic::server
