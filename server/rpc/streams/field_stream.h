// ComputeField.

#ifndef GEODESIC_SERVER_RPC_STREAMS_FIELD_STREAM_H_
#define GEODESIC_SERVER_RPC_STREAMS_FIELD_STREAM_H_

#include <cstdint>
#include <optional>
#include <string>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/v1/question_service.pb.h"
#include "server/engine/query_engine.h"
#include "server/rpc/streams/field_question.h"

namespace geodesic::server {

// Cuts a field off at the radius that was asked for, or at the last of the
// nearest targets that were, because the field may reach further. Not
// thread-safe.
class FieldCut {
 public:
  // Of the distances, all of which are sent. REQUIRES: `call` led to `answer`.
  FieldCut(const FieldCall& call, const FieldAnswer& answer,
           FieldExtras extras);

  // Nothing beyond is sent.
  double radius() const { return radius_; }
  // Every distance up to here is sent. Final once the targets were cut.
  double settled_radius() const;

  // +infinity for a target beyond the radius.
  double Target(double distance);

 private:
  const double settled_radius_;  // of the field
  const double radius_;
  bool was_cut_;
};

class FieldStream final : public FieldQuestion<v1::ComputeFieldRequest> {
 public:
  using FieldQuestion::FieldQuestion;

 private:
  absl::Status Translate(FieldRequest& question) override;
  void Announce() override;
  absl::StatusOr<NextMessage> FillBlocks() override;
  absl::StatusOr<NextMessage> FillFromField() override;
  std::string Variant() const override;

  // Whether all that is there was put, as AnswerWriter::Put.
  bool PutSettled();
  bool PutVertices();
  bool PutTargets();

  // Set before the answer, then constant:
  FieldExtras extras_;
  // The arrays, as far as they are asked for.
  uint32_t settled_vertex_ = 0;
  uint32_t distance_ = 0;
  uint32_t nearest_source_ = 0;
  uint32_t gradient_ = 0;
  uint32_t certified_error_ = 0;
  uint32_t target_distance_ = 0;

  // Guarded by the stream's lock:
  std::optional<FieldCut> cut_;  // of the answer
  uint64_t settled_ = 0;         // entries of the log that were put
  TargetReader targets_;         // of those that are to be put
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_STREAMS_FIELD_STREAM_H_
