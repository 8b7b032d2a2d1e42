// One ComputeField call: header, progress, chunks, targets, trailer.

#ifndef GEODESIC_SERVER_RPC_STREAMS_FIELD_STREAM_H_
#define GEODESIC_SERVER_RPC_STREAMS_FIELD_STREAM_H_

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "digest/sha256.h"
#include "geodesic/v1/field_service.pb.h"
#include "server/engine/query_engine.h"
#include "server/rpc/calls/answer_stream.h"

namespace geodesic::server {

// Cuts a field into messages, and cuts it off at the radius that was asked for,
// or at the last of the nearest targets that were, because the field may reach
// further. Pins the field. Not thread-safe.
class FieldChunks {
 public:
  // The first chunk begins at `first_vertex`.
  // REQUIRES: `call` outlives the chunks and led to `answer`.
  FieldChunks(const FieldCall& call, FieldAnswer answer, FieldExtras extras,
              v1::ValueType value_type, uint64_t first_vertex);

  // Fills the next message of its kind; false when there is none left.
  bool Next(v1::FieldChunk& chunk);
  bool NextTargets(v1::TargetChunk& chunk);

  // Nothing beyond is sent.
  double radius() const { return radius_; }
  // Every distance up to here was sent. Final once every chunk was made.
  double settled_radius() const;

  const FieldAnswer& answer() const { return answer_; }

 private:
  // The distance of the last target that was asked for; +infinity if all are.
  double RadiusOfTargets() const;
  // +infinity for a distance beyond the radius, which sets was_cut_.
  double Cut(double distance);

  const FieldCall& call_;
  const FieldAnswer answer_;
  const FieldExtras extras_;
  const v1::ValueType value_type_;
  const double radius_;
  uint64_t next_vertex_;
  TargetReader targets_;
  bool was_cut_ = false;
  std::vector<double> values_;
};

class FieldStream final
    : public AnswerStream<v1::ComputeFieldRequest, v1::ComputeFieldResponse>,
      public FieldObserver {
 public:
  using AnswerStream::AnswerStream;

  void OnProgress(const Progress& progress) override;
  void OnField(const absl::StatusOr<FieldAnswer>& answer) override;

 private:
  absl::Status Ask() override;
  void Cancel() override;
  absl::StatusOr<NextMessage> Fill(v1::ComputeFieldResponse& message) override;

  // Called once the answer is there. Errors: NOT_FOUND, INVALID_ARGUMENT: the
  // field cannot be resumed as asked.
  absl::Status StartChunks();
  // Keeps what StartChunks and MakeFieldId need of the request, which is freed.
  void KeepQuestion();
  // Names the answer to this request; equal names mean equal bits. Call once.
  std::string MakeFieldId();

  // Fills the next message of its kind; false when there is none.
  bool FillSettled(v1::ComputeFieldResponse& message);
  bool FillChunk(v1::ComputeFieldResponse& message);
  bool FillTargets(v1::ComputeFieldResponse& message);

  AlgorithmChoice algorithm() const;
  void FillHeader(v1::FieldHeader& header) const;
  void FillTrailer(v1::FieldTrailer& trailer) const;

  // Set by Ask, then constant:
  FieldExtras extras_;
  v1::ValueType value_type_ = v1::VALUE_TYPE_FLOAT64;
  std::optional<FieldCall> call_;
  std::optional<v1::FieldResumption> resumption_;
  Sha256 question_;  // of what was asked, for the field's name

  // Guarded by the stream's lock:
  bool header_sent_ = false;
  std::optional<v1::SolveProgress> progress_;  // newer than what was sent
  std::optional<absl::StatusOr<FieldAnswer>> answer_;
  std::optional<FieldChunks> chunks_;  // of *answer_
  std::string field_id_;               // until it is sent
  uint64_t settled_ = 0;               // entries of the log that were sent
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_STREAMS_FIELD_STREAM_H_
