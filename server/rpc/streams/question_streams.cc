#include "server/rpc/streams/question_streams.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "codec/places.h"
#include "geodesic_types/field_path.h"
#include "server/engine/base/argument_checks.h"
#include "server/rpc/messages/translation.h"

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

constexpr uint64_t kVerticesPerChunk = 32768;

constexpr uint64_t kSamplesPerChunk = 16384;

}  // namespace

absl::Status PathStream::Translate(FieldRequest& question) {
  question.extras.paths = true;
  absl::Status status =
      AddSources(request().sources(), engine().limits(), question.query);
  if (!status.ok()) return status;
  status = AddTargets(request().targets(), request().vertex_targets(),
                      engine().limits(), question.query);
  if (!status.ok()) return status;
  if (question.query.targets.empty()) {
    return InvalidField("targets", "targets is empty: name at least one");
  }
  question.reach.targets = question.query.targets.size();
  return absl::OkStatus();
}

void PathStream::Cancel() {
  FieldQuestionStream::Cancel();
  std::shared_ptr<RowPipeline> rows;
  Update([&] { rows = std::move(rows_); });
  if (rows != nullptr) rows->Cancel();
}

std::optional<absl::StatusOr<GeodesicPath>> PathStream::TakeNext() {
  const DerivedQuantities& derived = *answer().derived;
  if (!derived.paths.has_value()) return derived.found_paths[next_item_];
  if (rows_ == nullptr) {
    auto rows =
        engine().TracePaths(call(), answer(), deadline(), requester(is_batch()),
                            [self = Shared(this)] { self->Update([] {}); });
    if (!rows.ok()) return rows.status();
    rows_ = *std::move(rows);
  }
  if (next_in_row_ == row_.paths.size()) {
    std::optional<absl::StatusOr<MatrixRow>> row = rows_->Take();
    if (!row.has_value()) return std::nullopt;
    if (!row->ok()) return row->status();
    row_ = **std::move(row);
    next_in_row_ = 0;
  }
  return std::move(row_.paths[next_in_row_++]);
}

absl::StatusOr<NextMessage> PathStream::FillPart(
    v1::ComputePathsResponse& message) {
  if (next_item_ > 0 && next_point_ < path_.points.size()) {
    // Sends the next piece of the same path.
    next_point_ = SetPiece(path_.points, path_.positions, next_point_,
                           *message.mutable_path()->mutable_piece());
    return NextMessage::kSend;
  }
  if (next_item_ == call().query->targets.size()) return NextMessage::kSendLast;
  std::optional<absl::StatusOr<GeodesicPath>> path = TakeNext();
  if (!path.has_value()) return NextMessage::kWait;
  if (!path->ok()) return path->status();
  path_ = **std::move(path);
  const uint64_t target = next_item_++;
  v1::GeodesicPath& proto = *message.mutable_path();
  proto.set_target(target);
  proto.set_length(path_.length);
  proto.set_distance(path_.distance);
  proto.clear_source();
  if (!path_.points.empty()) {
    proto.set_source(call().source_numbers[path_.source]);
  }
  next_point_ =
      SetPiece(path_.points, path_.positions, 0, *proto.mutable_piece());
  entry().add_bytes(path_.points.size() * sizeof(Point));
  return NextMessage::kSend;
}

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

absl::StatusOr<NextMessage> IsolineStream::FillPart(
    v1::ComputeIsolinesResponse& message) {
  if (next_item_ == result().size()) return NextMessage::kSendLast;
  const Isoline& isoline = result()[next_item_];
  v1::Isoline& proto = *message.mutable_isoline();
  proto.set_number(next_item_);
  proto.set_level(isoline.level);
  proto.set_is_closed(isoline.is_closed);
  next_point_ = SetPiece(isoline.points, isoline.positions, next_point_,
                         *proto.mutable_piece());
  entry().add_bytes(proto.piece().positions().size());
  if (next_point_ == isoline.points.size()) {
    ++next_item_;
    next_point_ = 0;
  }
  return NextMessage::kSend;
}

absl::Status LogMapStream::Translate(FieldRequest& question) {
  const absl::StatusOr<v1::ValueType> value_type =
      ResolveValueType(request().value_type());
  if (!value_type.ok()) return value_type.status();
  value_type_ = *value_type;
  question.extras.log_map = true;
  absl::StatusOr<SurfacePoint> source =
      codec::FromProto(request().source(), "source");
  if (!source.ok()) return source.status();
  question.query.sources = {{*source}};
  return absl::OkStatus();
}

absl::StatusOr<NextMessage> LogMapStream::FillPart(
    v1::ComputeLogMapResponse& message) {
  const LogMap& map = answer().derived->log_map;
  if (!std::exchange(has_frame_, true)) {
    SetPoint(map.zero_direction,
             *message.mutable_frame()->mutable_zero_direction());
    return NextMessage::kSend;
  }
  const uint64_t end = std::min<uint64_t>(next_item_ + kVerticesPerChunk,
                                          map.coordinates.size());
  if (next_item_ == end) return NextMessage::kSendLast;
  v1::LogMapChunk& chunk = *message.mutable_chunk();
  chunk.set_offset(next_item_);
  values_.clear();
  for (; next_item_ < end; ++next_item_) {
    const auto& uv = map.coordinates[next_item_];
    values_.insert(values_.end(), uv.begin(), uv.end());
  }
  SetValues(values_, value_type_, *chunk.mutable_coordinates());
  entry().add_bytes(chunk.coordinates().size());
  return NextMessage::kSend;
}

absl::StatusOr<SampleStream::Work> SampleStream::MakeWork() {
  const uint64_t count = request().count();
  if (count == 0) {
    return InvalidField("count", "count is 0; it must be at least 1");
  }
  absl::Status status = CheckCount("samples", count, "max_samples",
                                   engine().limits().max_samples);
  if (!status.ok()) return status;
  return [count](const Mesh& mesh, const ValidQuery& query,
                 const SolveOptions& options, Checkpoint& checkpoint,
                 ByteReservation& memory)
             -> absl::StatusOr<std::vector<FarthestSample>> {
    absl::Status room =
        memory.GrowTo(std::min<uint64_t>(count, mesh.vertex_count()) *
                      sizeof(FarthestSample));
    if (!room.ok()) return room;
    return geodesic::SampleFarthestPoints(
        mesh, query, static_cast<uint32_t>(count), options, checkpoint);
  };
}

absl::StatusOr<NextMessage> SampleStream::FillPart(
    v1::SampleFarthestPointsResponse& message) {
  const uint64_t end =
      std::min<uint64_t>(next_item_ + kSamplesPerChunk, result().size());
  if (next_item_ == end) return NextMessage::kSendLast;
  v1::SampleChunk& chunk = *message.mutable_samples();
  chunk.clear_samples();
  for (; next_item_ < end; ++next_item_) {
    const FarthestSample& sample = result()[next_item_];
    v1::FarthestSample& proto = *chunk.add_samples();
    proto.set_vertex(sample.vertex);
    proto.set_distance(sample.distance);
  }
  return NextMessage::kSend;
}

}  // namespace geodesic::server
