// Puts a distance field together from the messages of a ComputeField stream.
//
// The values are copied once, from the transport's slices to where they stay:
// chunks are decoded here instead of by the generated message, which would put
// them into a string first.

#ifndef GEODESIC_CLIENT_FIELD_ASSEMBLER_H_
#define GEODESIC_CLIENT_FIELD_ASSEMBLER_H_

#include <google/protobuf/io/coded_stream.h>
#include <grpcpp/support/byte_buffer.h>

#include <cstdint>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/v1/field_service.pb.h"
#include "geodesic_client/field.h"

namespace geodesic::client {

// Not thread-safe.
class FieldAssembler {
 public:
  // `progress` may be empty.
  explicit FieldAssembler(FieldProgressCallback progress)
      : progress_(std::move(progress)) {}

  // Takes the next serialized ComputeFieldResponse of the stream.
  // Errors: DATA_LOSS if it is malformed or breaks the stream's protocol;
  // memory never grows by more than the bytes that have arrived.
  absl::Status Consume(grpc::ByteBuffer* message);

  // The field, after the stream has ended well.
  // Errors: DATA_LOSS if anything is missing.
  absl::StatusOr<Field> Finish() &&;

 private:
  absl::Status ConsumeChunk(google::protobuf::io::CodedInputStream* input);
  absl::Status ConsumeDistances(google::protobuf::io::CodedInputStream* input);
  absl::Status ConsumeOther(const geodesic::v1::ComputeFieldResponse& message);

  FieldProgressCallback progress_;
  Field field_;
  uint64_t vertex_count_ = 0;
  bool accepted_ = false;
  bool complete_ = false;
};

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_FIELD_ASSEMBLER_H_
