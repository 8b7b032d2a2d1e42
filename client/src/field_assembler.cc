#include "field_assembler.h"

#include <google/protobuf/wire_format_lite.h>
#include <grpcpp/impl/codegen/proto_utils.h>
#include <grpcpp/support/proto_buffer_reader.h>

#include <algorithm>
#include <utility>

#include "absl/strings/str_cat.h"
#include "translate.h"
#include "wire_values.h"

namespace geodesic::client {
namespace {

using google::protobuf::internal::WireFormatLite;
using google::protobuf::io::CodedInputStream;
using v1::ComputeFieldResponse;
using v1::FieldChunk;

constexpr uint32_t Tag(int field, WireFormatLite::WireType type) {
  return static_cast<uint32_t>(field) << 3 | static_cast<uint32_t>(type);
}

constexpr uint32_t BytesTag(int field) {
  return Tag(field, WireFormatLite::WIRETYPE_LENGTH_DELIMITED);
}

constexpr uint32_t kChunkTag =
    BytesTag(ComputeFieldResponse::kChunkFieldNumber);
constexpr uint32_t kOffsetTag =
    Tag(FieldChunk::kOffsetFieldNumber, WireFormatLite::WIRETYPE_VARINT);
constexpr uint32_t kDistancesTag = BytesTag(FieldChunk::kDistancesFieldNumber);
constexpr uint32_t kNearestTag =
    BytesTag(FieldChunk::kNearestSourcesFieldNumber);
constexpr uint32_t kGradientsTag = BytesTag(FieldChunk::kGradientsFieldNumber);

constexpr uint32_t kFieldIdTag = BytesTag(FieldChunk::kFieldIdFieldNumber);

constexpr size_t kDimensions = 3;

// The server's are 64 bytes.
constexpr uint32_t kLongestFieldId = 1024;

// Room taken on the server's word alone, in values: address space that no
// memory backs until values arrive. Larger fields grow as vectors do.
constexpr uint64_t kMostReserved = uint64_t{1} << 24;

absl::Status Malformed() {
  return absl::DataLossError("the server sent a malformed field message");
}

// Reads the length of a bytes field that holds whole elements.
bool ReadSize(CodedInputStream* input, size_t element, uint32_t* size) {
  return input->ReadVarint32(size) &&
         static_cast<int64_t>(*size) <= input->BytesUntilLimit() &&
         *size % element == 0;
}

}  // namespace

absl::Status FieldAssembler::Consume(grpc::ByteBuffer* message) {
  {
    grpc::ProtoBufferReader reader(message);
    if (!reader.status().ok()) return Malformed();
    CodedInputStream input(&reader);
    if (input.ReadTag() == kChunkTag) return ConsumeChunk(&input);
  }
  ComputeFieldResponse other;
  if (!grpc::SerializationTraits<ComputeFieldResponse>::Deserialize(message,
                                                                    &other)
           .ok()) {
    return Malformed();
  }
  return ConsumeOther(other);
}

absl::Status FieldAssembler::ConsumeChunk(CodedInputStream* input) {
  if (!accepted_ || complete_ || expected_.on_settled != nullptr) {
    return absl::DataLossError(
        "the server sent distances outside the field's stream");
  }
  uint32_t length = 0;
  if (!input->ReadVarint32(&length)) return Malformed();
  const CodedInputStream::Limit limit =
      input->PushLimit(static_cast<int>(length));
  const uint64_t expected_offset = field_.distances.size();
  uint64_t offset = 0;
  while (const uint32_t tag = input->ReadTag()) {
    absl::Status status;
    if (tag == kOffsetTag) {
      if (!input->ReadVarint64(&offset)) return Malformed();
    } else if (tag == kDistancesTag) {
      status = ConsumeValues(input, 1, &field_.distances);
    } else if (tag == kNearestTag) {
      status = ConsumeNearest(input);
    } else if (tag == kGradientsTag) {
      status = ConsumeValues(input, kDimensions, &gradient_values_);
    } else if (tag == kFieldIdTag) {
      status = ConsumeFieldId(input);
    } else if (!WireFormatLite::SkipField(input, tag)) {
      return Malformed();
    }
    if (!status.ok()) return status;
  }
  if (!input->ConsumedEntireMessage() || input->BytesUntilLimit() != 0) {
    return Malformed();
  }
  input->PopLimit(limit);
  if (offset != expected_offset) {
    return absl::DataLossError(absl::StrCat(
        "the server sent the distances from vertex ", offset,
        " where those from vertex ", expected_offset, " were due"));
  }
  return absl::OkStatus();
}

absl::Status FieldAssembler::ConsumeValues(CodedInputStream* input,
                                           size_t per_vertex,
                                           std::vector<double>* values) {
  const size_t value_size = SizeOf(expected_.value_type);
  uint32_t size = 0;
  if (!ReadSize(input, per_vertex * value_size, &size)) return Malformed();
  const size_t had = values->size();
  const size_t count = size / value_size;
  if (count / per_vertex > field_.vertex_count - had / per_vertex) {
    return absl::DataLossError(absl::StrCat("the server sent more than the ",
                                            field_.vertex_count,
                                            " distances it had announced"));
  }
  values->resize(had + count);
  if (expected_.value_type == ValueType::kFloat64) {
    return input->ReadRaw(values->data() + had, static_cast<int>(size))
               ? absl::OkStatus()
               : Malformed();
  }
  narrow_.resize(count);
  if (!input->ReadRaw(narrow_.data(), static_cast<int>(size))) {
    return Malformed();
  }
  std::ranges::copy(narrow_, values->begin() + static_cast<ptrdiff_t>(had));
  return absl::OkStatus();
}

absl::Status FieldAssembler::ConsumeNearest(CodedInputStream* input) {
  std::vector<uint32_t>& numbers = field_.nearest_sources;
  uint32_t size = 0;
  if (!ReadSize(input, sizeof(uint32_t), &size)) return Malformed();
  const size_t had = numbers.size();
  const size_t count = size / sizeof(uint32_t);
  if (count > field_.vertex_count - had) return Malformed();
  numbers.resize(had + count);
  return input->ReadRaw(numbers.data() + had, static_cast<int>(size))
             ? absl::OkStatus()
             : Malformed();
}

absl::Status FieldAssembler::ConsumeFieldId(CodedInputStream* input) {
  uint32_t size = 0;
  return ReadSize(input, 1, &size) && size <= kLongestFieldId &&
                 input->ReadString(&field_id_, static_cast<int>(size))
             ? absl::OkStatus()
             : Malformed();
}

FieldAssembler::Position FieldAssembler::Resume() {
  if (field_id_.empty()) {
    Restart();
    return {};
  }
  accepted_ = false;
  complete_ = false;
  field_.target_distances.clear();
  return {field_id_, received()};
}

void FieldAssembler::Restart() {
  field_ = Field();
  field_id_.clear();
  gradient_values_.clear();
  accepted_ = false;
  complete_ = false;
}

absl::Status FieldAssembler::ConsumeTargets(const v1::TargetChunk& chunk) {
  if (chunk.offset() != field_.target_distances.size() ||
      !AppendValues(chunk.distances(), expected_.value_type,
                    &field_.target_distances) ||
      field_.target_distances.size() > expected_.target_count) {
    return absl::DataLossError(
        "the server sent distances of other targets than were due");
  }
  return absl::OkStatus();
}

absl::Status FieldAssembler::ConsumeSettled(const v1::SettledChunk& chunk) {
  std::vector<uint32_t> vertices;
  std::vector<double> distances;
  if (expected_.on_settled == nullptr || chunk.offset() != settled_count_ ||
      !AppendNumbers(chunk.vertices(), &vertices) ||
      !AppendValues(chunk.distances(), expected_.value_type, &distances) ||
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
  expected_.on_settled(settled);
  return absl::OkStatus();
}

void FieldAssembler::Accept(const v1::FieldAccepted& accepted) {
  accepted_ = true;
  field_.vertex_count = accepted.vertex_count();
  field_.mesh_digest = accepted.mesh_digest();
  field_.algorithm = AlgorithmName(accepted.algorithm());
  field_.origin = FromProto(accepted.origin());
  if (expected_.on_settled == nullptr) {
    field_.distances.reserve(std::min(field_.vertex_count, kMostReserved));
  }
}

absl::Status FieldAssembler::ConsumeOther(const ComputeFieldResponse& message) {
  if (!accepted_ && !message.has_accepted()) {
    return absl::DataLossError("the server began a field without accepting it");
  }
  switch (message.part_case()) {
    case ComputeFieldResponse::kAccepted:
      if (accepted_) {
        return absl::DataLossError("the server accepted one query twice");
      }
      // When a field is read on, it must be the same.
      if (!field_id_.empty() &&
          message.accepted().vertex_count() != field_.vertex_count) {
        return absl::DataLossError("the server went on with another field");
      }
      Accept(message.accepted());
      return absl::OkStatus();
    case ComputeFieldResponse::kProgress:
      if (progress_ != nullptr) {
        progress_(FromProto(message.progress(), field_.vertex_count));
      }
      return absl::OkStatus();
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
    case ComputeFieldResponse::kChunk:  // Only where a field comes before it.
      return Malformed();
    case ComputeFieldResponse::PART_NOT_SET:
      return absl::OkStatus();  // A part that a later server may add.
  }
  return absl::OkStatus();
}

absl::StatusOr<Field> FieldAssembler::Finish() && {
  const bool progressive = expected_.on_settled != nullptr;
  if (!accepted_ || !complete_ ||
      (!progressive && field_.distances.size() != field_.vertex_count)) {
    return absl::DataLossError(
        absl::StrCat("the server ended the stream after ",
                     progressive ? settled_count_ : field_.distances.size(),
                     " of ", field_.vertex_count, " distances",
                     accepted_ && !complete_ ? " without its trailer" : ""));
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
            expected_.target_count);
  status.Update(check("nearest sources", field_.nearest_sources.size(),
                      expected_.nearest_sources ? field_.vertex_count : 0));
  status.Update(check("gradients", gradient_values_.size() / kDimensions,
                      expected_.gradients ? field_.vertex_count : 0));
  if (!status.ok()) return status;
  field_.gradients.resize(gradient_values_.size() / kDimensions);
  for (size_t v = 0; v < field_.gradients.size(); ++v) {
    std::copy_n(
        gradient_values_.begin() + static_cast<ptrdiff_t>(kDimensions * v),
        kDimensions, field_.gradients[v].begin());
  }
  return std::move(field_);
}

}  // namespace geodesic::client
