// Questions that a field answers: the base of all, ComputePaths and
// ComputeLogMap.

#ifndef GEODESIC_SERVER_RPC_STREAMS_FIELD_QUESTIONS_H_
#define GEODESIC_SERVER_RPC_STREAMS_FIELD_QUESTIONS_H_

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "codec/answer_writer.h"
#include "codec/places.h"
#include "geodesic/field_quantities.h"
#include "geodesic/log_map.h"
#include "geodesic/path.h"
#include "geodesic/v1/question_service.pb.h"
#include "geodesic_types/field_path.h"
#include "server/engine/jobs/row_pipeline.h"
#include "server/engine/query_engine.h"
#include "server/rpc/calls/answer_stream.h"
#include "server/rpc/messages/translation.h"

namespace geodesic::server {

template <typename Request>
class FieldQuestion : public AnswerStream<Request>, public FieldObserver {
 public:
  using AnswerStream<Request>::AnswerStream;

  void OnProgress(const Progress& progress) final {
    this->SetProgress(progress);
  }

  void OnField(const absl::StatusOr<FieldAnswer>& answer) final {
    MutexLock lock(mutex_);
    answer_ = answer;
    this->Advance();
  }

 protected:
  using AnswerStream<Request>::mutex_;

  // Adds to `question` what only this stream knows.
  virtual absl::Status Translate(FieldRequest& question) = 0;
  // Announces the arrays. The call is there.
  virtual void Announce() ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) = 0;
  // FillBlocks, of which the answer is there.
  virtual absl::StatusOr<NextMessage> FillFromField()
      ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) = 0;

  absl::StatusOr<NextMessage> FillBlocks() override
      ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    if (!answer_.has_value()) return NextMessage::kWait;
    if (!answer_->ok()) return answer_->status();
    absl::StatusOr<NextMessage> next = FillFromField();
    if (!next.ok() || *next != NextMessage::kSendLast) return next;
    const DistanceField& field = *answer().field;
    const SolveStatistics& statistics = field.statistics;
    if (answer().origin == FieldOrigin::kCached) {
      this->SetCost(0, 0, field.certified_error);
    } else {
      this->SetCost(statistics.solve_seconds, statistics.windows_propagated,
                    field.certified_error);
    }
    if (call().origin != FieldOrigin::kJoined) {
      this->trailer().set_origin(ToProto(answer().origin));
    }
    return next;
  }

  void Cancel() override { this->engine().fields().Cancel(*call_); }

  // Constant once AskEngine has succeeded.
  const FieldCall& call() const { return *call_; }
  // For FillFromField.
  const FieldAnswer& answer() const ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    return **answer_;
  }

 private:
  absl::Status AskEngine() final {
    FieldRequest question;
    this->BeginQuestion(question);
    if (this->request().has_radius()) {
      question.reach.radius = this->request().radius();
    }
    absl::Status status = Translate(question);
    if (!status.ok()) return status;
    absl::StatusOr<FieldCall> call =
        this->engine().fields().Compute(question, this->Shared(this));
    if (!call.ok()) return call.status();
    call_ = *std::move(call);
    MutexLock lock(mutex_);
    if (call_->answer.has_value()) answer_ = *std::exchange(call_->answer, {});
    AlgorithmChoice algorithm = call_->query->algorithm;
    if (call_->method.has_value()) algorithm = *call_->method;
    this->SetHeader(*call_->mesh, algorithm, ToProto(call_->origin));
    Announce();
    return absl::OkStatus();
  }

  std::optional<FieldCall> call_;
  std::optional<absl::StatusOr<FieldAnswer>> answer_ ABSL_GUARDED_BY(mutex_);
};

class PathStream final : public FieldQuestion<v1::ComputePathsRequest> {
 public:
  using FieldQuestion::FieldQuestion;

 private:
  absl::Status Translate(FieldRequest& question) override {
    question.extras.paths = true;
    absl::Status status =
        AddSources(request().sources(), engine().limits(), question.query);
    if (!status.ok()) return status;
    status = AddTargets(request().targets(), request().vertex_targets(),
                        engine().limits(), question.query);
    if (status.ok() && question.query.targets.empty()) {
      return InvalidField("targets", "targets is empty: name at least one");
    }
    question.reach.targets = question.query.targets.size();
    return status;
  }

  void Announce() override ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    const auto targets = static_cast<int64_t>(call().query->targets.size());
    lines_.emplace(writer(), targets);
    source_ = writer().Announce("source", v1::VALUE_TYPE_UINT32, {targets});
    distance_ = writer().Announce("distance", value_type(), {targets});
    length_ = writer().Announce("length", value_type(), {targets});
  }

  void Cancel() override {
    FieldQuestion::Cancel();
    std::shared_ptr<RowPipeline> rows;
    {
      MutexLock lock(mutex_);
      rows = std::move(rows_);
    }
    if (rows != nullptr) rows->Cancel();
  }

  absl::StatusOr<NextMessage> FillFromField() override
      ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    for (; lines_->line() < call().query->targets.size(); lines_->Next()) {
      if (path_ == nullptr) {
        absl::StatusOr<const GeodesicPath*> next = TakePath();
        if (!next.ok()) return next.status();
        if (*next == nullptr) return NextMessage::kWait;
        path_ = *next;
      }
      if (!Put(*path_)) return NextMessage::kSend;
      path_ = nullptr;
    }
    return NextMessage::kSendLast;
  }

  bool were_searched() const ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    return !answer().derived->paths.has_value();
  }
  // Where paths are of equal length, a search may find another one.
  std::string Variant() const override ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    return were_searched() ? "s" : "t";
  }

  // The next path; null if it is not there yet. Those that were not searched
  // for are traced in jobs, which it starts.
  absl::StatusOr<const GeodesicPath*> TakePath()
      ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    if (were_searched()) return &answer().derived->found_paths[lines_->line()];
    if (rows_ == nullptr) {
      auto rows =
          engine().TracePaths(call(), answer(), deadline(), requester(),
                              [self = Shared(this)] { self->OnPath(); });
      if (!rows.ok()) return rows.status();
      rows_ = *std::move(rows);
    }
    if (next_in_row_ == row_.paths.size()) {
      std::optional<absl::StatusOr<MatrixRow>> row = rows_->Take();
      if (!row.has_value()) return nullptr;
      if (!row->ok()) return row->status();
      row_ = **std::move(row);
      next_in_row_ = 0;
    }
    return &row_.paths[next_in_row_++];
  }

  void OnPath() {
    MutexLock lock(mutex_);
    Advance();
  }

  // As AnswerWriter::Put.
  bool Put(const GeodesicPath& path) ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    const uint32_t source =
        path.points.empty() ? kNoSource : call().source_numbers[path.source];
    return lines_->Put(path.points, path.positions) &&
           writer().PutOne(source_, lines_->line(), source) &&
           writer().PutOne(distance_, lines_->line(), path.distance) &&
           writer().PutOne(length_, lines_->line(), path.length);
  }

  std::optional<codec::LineWriter> lines_ ABSL_GUARDED_BY(mutex_);
  // Arrays, set by Announce:
  uint32_t source_ = 0;
  uint32_t distance_ = 0;
  uint32_t length_ = 0;

  // Unless paths were searched for.
  std::shared_ptr<RowPipeline> rows_ ABSL_GUARDED_BY(mutex_);
  MatrixRow row_ ABSL_GUARDED_BY(mutex_);  // taken last
  size_t next_in_row_ ABSL_GUARDED_BY(mutex_) = 0;
  const GeodesicPath* path_ ABSL_GUARDED_BY(mutex_) = nullptr;  // being put
};

class LogMapStream final : public FieldQuestion<v1::ComputeLogMapRequest> {
 public:
  using FieldQuestion::FieldQuestion;

 private:
  absl::Status Translate(FieldRequest& question) override {
    question.extras.log_map = true;
    absl::StatusOr<SurfacePoint> source =
        codec::FromProto(request().source(), "source");
    if (source.ok()) question.query.sources = {{*source}};
    return source.status();
  }

  void Announce() override ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    zero_direction_ =
        writer().Announce("zero_direction", v1::VALUE_TYPE_FLOAT64, {3});
    coordinates_ = writer().Announce("coordinates", value_type(),
                                     {call().mesh->mesh->vertex_count(), 2});
  }

  absl::StatusOr<NextMessage> FillFromField() override
      ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    const LogMap& map = answer().derived->log_map;
    return writer().Put(zero_direction_, 0, map.zero_direction) &&
                   writer().Put(coordinates_, 0, 2 * map.coordinates.size(),
                                [&](uint64_t i) {
                                  return map.coordinates[i / 2][i % 2];
                                })
               ? NextMessage::kSendLast
               : NextMessage::kSend;
  }

  // Arrays, set by Announce:
  uint32_t zero_direction_ = 0;
  uint32_t coordinates_ = 0;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_STREAMS_FIELD_QUESTIONS_H_
