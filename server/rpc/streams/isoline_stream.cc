#include "server/rpc/streams/isoline_stream.h"

#include <google/protobuf/repeated_field.h>

#include <cmath>
#include <string>
#include <utility>

#include "absl/strings/str_cat.h"
#include "geodesic_types/field_path.h"
#include "server/engine/base/argument_checks.h"

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
  if (!(request().chord_error() >= 0)) {
    return InvalidField("chord_error",
                        absl::StrCat("chord_error is ", request().chord_error(),
                                     "; it must be a number >= 0"));
  }
  IsolineOptions isolines{
      .levels = {request().levels().begin(), request().levels().end()},
      .chord_error = request().chord_error()};
  return [isolines = std::move(isolines)](
             const Mesh& mesh, const ValidQuery& query,
             const SolveOptions& options, Checkpoint& checkpoint,
             ByteReservation& memory) -> absl::StatusOr<std::vector<Isoline>> {
    absl::StatusOr<std::vector<Isoline>> found =
        geodesic::ComputeIsolines(mesh, query, isolines, options, checkpoint);
    if (!found.ok()) return found;
    absl::Status room = memory.GrowTo(BytesOf(*found));
    if (!room.ok()) return room;
    return found;
  };
}

void IsolineStream::Announce() {
  lines_.emplace(writer(), -1);
  level_ = writer().Announce("level", v1::VALUE_TYPE_FLOAT64, {-1});
  is_closed_ = writer().Announce("is_closed", v1::VALUE_TYPE_UINT8, {-1});
}

bool IsolineStream::Put(const std::vector<Isoline>& isolines) {
  for (; lines_->line() < isolines.size(); lines_->Next()) {
    const uint64_t line = lines_->line();
    const Isoline& isoline = isolines[line];
    if (!lines_->Put(isoline.points, isoline.positions) ||
        !writer().PutOne(level_, line, isoline.level) ||
        !writer().PutOne<uint8_t>(is_closed_, line, isoline.is_closed)) {
      return false;
    }
  }
  return true;
}

}  // namespace geodesic::server
