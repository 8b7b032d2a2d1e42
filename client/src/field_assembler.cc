#include "field_assembler.h"

#include <algorithm>
#include <utility>

#include "absl/strings/str_cat.h"
#include "translate.h"
#include "wire_values.h"

namespace geodesic::client {
namespace {

using v1::ComputeFieldResponse;

// Room taken on the server's word alone, in values: address space that no
// memory backs until values arrive. Larger fields grow as vectors do.
constexpr uint64_t kMostReserved = uint64_t{1} << 24;

}  // namespace

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
      !AppendValues(chunk.gradients(), type, &field_.gradients)) {
    return absl::DataLossError("the server sent a part of a number");
  }
  if (std::max({received(), field_.nearest_sources.size(),
                field_.gradients.size()}) > field_.vertex_count) {
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
  // When a field is read on, it must be the same.
  if (!field_id_.empty() && header.vertex_count() != field_.vertex_count) {
    return absl::DataLossError("the server went on with another field");
  }
  has_header_ = true;
  field_.vertex_count = header.vertex_count();
  field_.mesh_digest = header.mesh_digest();
  field_.algorithm = AlgorithmName(header.algorithm());
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
  const auto check = [this](std::string_view what, size_t count,
                            uint64_t expected) {
    return count == expected ? absl::OkStatus()
                             : absl::DataLossError(absl::StrCat(
                                   "the server sent ", count, " of ", expected,
                                   " ", std::string(what)));
  };
  absl::Status status =
      check("target distances", field_.target_distances.size(),
            query_.targets.size());
  status.Update(check("nearest sources", field_.nearest_sources.size(),
                      query_.nearest_sources ? field_.vertex_count : 0));
  status.Update(check("gradients", field_.gradients.size(),
                      query_.gradients ? field_.vertex_count : 0));
  if (!status.ok()) return status;
  return std::move(field_);
}

}  // namespace geodesic::client
