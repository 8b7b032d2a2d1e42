// Puts a distance field together from the messages of a ComputeField stream.

#ifndef GEODESIC_CLIENT_FIELD_ASSEMBLER_H_
#define GEODESIC_CLIENT_FIELD_ASSEMBLER_H_

#include <cstdint>
#include <string>
#include <utility>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/v1/field_service.pb.h"
#include "geodesic_client/field.h"

namespace geodesic::client {

// Not thread-safe.
class FieldAssembler {
 public:
  // For the answer to `query`, which outlives this. With `on_settled` the field
  // is progressive: settled vertices come instead of chunks. Both callbacks may
  // be empty.
  FieldAssembler(const FieldQuery& query, SettledCallback on_settled,
                 SolveProgressCallback progress)
      : query_(query),
        on_settled_(std::move(on_settled)),
        progress_(std::move(progress)) {}

  // Takes the next message of the stream.
  // Errors: DATA_LOSS if it breaks the stream's protocol; memory never grows by
  // more than the bytes that have arrived.
  absl::Status Consume(const v1::ComputeFieldResponse& message);

  // Whether the server has begun to answer.
  bool has_header() const { return has_header_; }
  uint64_t received() const { return field_.distances.size(); }

  // After a stream has broken: the next one is to begin where this one ended,
  // or at the start if what came cannot be added to.
  struct Position {
    std::string field_id;  // empty: at the start
    uint64_t first_vertex = 0;
  };
  Position Resume();
  // After a stream has broken: the next one begins at the start.
  void Restart();

  // The field, after the stream has ended well.
  // Errors: DATA_LOSS if anything is missing.
  absl::StatusOr<Field> Finish() &&;

 private:
  absl::Status ConsumeChunk(const v1::FieldChunk& chunk);
  absl::Status ConsumeTargets(const v1::TargetChunk& chunk);
  absl::Status ConsumeSettled(const v1::SettledChunk& chunk);
  absl::Status TakeHeader(const v1::FieldHeader& header);

  const FieldQuery& query_;
  SettledCallback on_settled_;
  SolveProgressCallback progress_;
  Field field_;
  uint64_t settled_count_ = 0;
  std::string field_id_;
  bool has_header_ = false;
  bool complete_ = false;
};

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_FIELD_ASSEMBLER_H_
