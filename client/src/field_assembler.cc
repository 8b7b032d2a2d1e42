#include "field_assembler.h"

#include <google/protobuf/wire_format_lite.h>
#include <grpcpp/impl/codegen/proto_utils.h>
#include <grpcpp/support/proto_buffer_reader.h>

#include <algorithm>
#include <bit>
#include <utility>

#include "absl/strings/str_cat.h"
#include "translate.h"

namespace geodesic::client {
namespace {

using google::protobuf::internal::WireFormatLite;
using google::protobuf::io::CodedInputStream;
using v1::ComputeFieldResponse;
using v1::FieldChunk;

// Chunks are little endian, and copied as they come.
static_assert(std::endian::native == std::endian::little);

constexpr uint32_t Tag(int field, WireFormatLite::WireType type) {
  return static_cast<uint32_t>(field) << 3 | static_cast<uint32_t>(type);
}

constexpr uint32_t kChunkTag = Tag(ComputeFieldResponse::kChunkFieldNumber,
                                   WireFormatLite::WIRETYPE_LENGTH_DELIMITED);
constexpr uint32_t kOffsetTag =
    Tag(FieldChunk::kOffsetFieldNumber, WireFormatLite::WIRETYPE_VARINT);
constexpr uint32_t kDistancesTag =
    Tag(FieldChunk::kDistancesFieldNumber,
        WireFormatLite::WIRETYPE_LENGTH_DELIMITED);

// Room taken on the server's word alone, in values: address space that no
// memory backs until values arrive. Larger fields grow as vectors do.
constexpr uint64_t kMostReserved = uint64_t{1} << 24;

absl::Status Malformed() {
  return absl::DataLossError("the server sent a malformed field message");
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
  if (!accepted_ || complete_) {
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
    if (tag == kOffsetTag) {
      if (!input->ReadVarint64(&offset)) return Malformed();
    } else if (tag == kDistancesTag) {
      if (absl::Status status = ConsumeDistances(input); !status.ok()) {
        return status;
      }
    } else if (!WireFormatLite::SkipField(input, tag)) {
      return Malformed();
    }
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

absl::Status FieldAssembler::ConsumeDistances(CodedInputStream* input) {
  uint32_t size = 0;
  if (!input->ReadVarint32(&size) ||
      static_cast<int64_t>(size) > input->BytesUntilLimit() ||
      size % sizeof(double) != 0) {
    return Malformed();
  }
  const size_t first = field_.distances.size();
  const size_t count = size / sizeof(double);
  if (count > vertex_count_ - first) {
    return absl::DataLossError(absl::StrCat("the server sent more than the ",
                                            vertex_count_,
                                            " distances it had announced"));
  }
  field_.distances.resize(first + count);
  if (!input->ReadRaw(field_.distances.data() + first,
                      static_cast<int>(size))) {
    return Malformed();
  }
  return absl::OkStatus();
}

absl::Status FieldAssembler::ConsumeOther(const ComputeFieldResponse& message) {
  switch (message.part_case()) {
    case ComputeFieldResponse::kAccepted:
      if (accepted_) {
        return absl::DataLossError("the server accepted one query twice");
      }
      accepted_ = true;
      vertex_count_ = message.accepted().vertex_count();
      field_.mesh_digest = message.accepted().mesh_digest();
      field_.algorithm = AlgorithmName(message.accepted().algorithm());
      field_.origin = FromProto(message.accepted().origin());
      field_.distances.reserve(std::min(vertex_count_, kMostReserved));
      return absl::OkStatus();
    case ComputeFieldResponse::kProgress:
      if (progress_ != nullptr) {
        progress_(
            {.settled_radius = message.progress().settled_radius(),
             .vertices_reached = message.progress().vertices_reached(),
             .vertex_count = vertex_count_,
             .live_windows = message.progress().live_windows(),
             .windows_propagated = message.progress().windows_propagated()});
      }
      return absl::OkStatus();
    case ComputeFieldResponse::kTrailer:
      complete_ = true;
      field_.origin = FromProto(message.trailer().origin());
      field_.statistics = FromProto(message.trailer().statistics());
      field_.relative_tolerance = message.trailer().relative_tolerance();
      field_.server_version = message.trailer().server_version();
      return absl::OkStatus();
    case ComputeFieldResponse::kChunk:  // Only where a field comes before it.
      return Malformed();
    case ComputeFieldResponse::PART_NOT_SET:
      return absl::OkStatus();  // A part that a later server may add.
  }
  return absl::OkStatus();
}

absl::StatusOr<Field> FieldAssembler::Finish() && {
  if (!accepted_ || !complete_ || field_.distances.size() != vertex_count_) {
    return absl::DataLossError(absl::StrCat(
        "the server ended the stream after ", field_.distances.size(), " of ",
        vertex_count_, " distances",
        accepted_ && !complete_ ? " without its trailer" : ""));
  }
  return std::move(field_);
}

}  // namespace geodesic::client
