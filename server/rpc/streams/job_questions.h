// Questions that are answered by a job of their own: ComputeIsolines and
// SampleFarthestPoints.

#ifndef GEODESIC_SERVER_RPC_STREAMS_JOB_QUESTIONS_H_
#define GEODESIC_SERVER_RPC_STREAMS_JOB_QUESTIONS_H_

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "absl/strings/str_cat.h"
#include "codec/answer_writer.h"
#include "geodesic/checkpoint.h"
#include "geodesic/isolines.h"
#include "geodesic/sampling.h"
#include "geodesic/v1/question_service.pb.h"
#include "geodesic_types/field_path.h"
#include "server/engine/base/argument_checks.h"
#include "server/engine/query_engine.h"
#include "server/rpc/calls/answer_stream.h"
#include "server/rpc/messages/translation.h"

namespace geodesic::server {

// The job makes a Result.
template <typename Request, typename Result>
class JobQuestion : public AnswerStream<Request> {
 public:
  using AnswerStream<Request>::AnswerStream;

 protected:
  using AnswerStream<Request>::mutex_;

  // What the job does; it sets `result`. Errors: INVALID_ARGUMENT.
  using Work = decltype(QuestionRequest::work);
  virtual absl::StatusOr<Work> MakeWork(std::shared_ptr<Result> result) = 0;
  // Announces the arrays.
  virtual void Announce() ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) = 0;
  // Whether all was put, as AnswerWriter::Put.
  virtual bool Put(const Result& result)
      ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) = 0;

 private:
  absl::Status AskEngine() final {
    QuestionRequest question;
    this->BeginQuestion(question);
    absl::StatusOr<Work> work = MakeWork(result_);
    if (!work.ok()) return work.status();
    question.work = *std::move(work);
    absl::Status status = AddSources(this->request().sources(),
                                     this->engine().limits(), question.query);
    if (!status.ok()) return status;
    question.done = [self = this->Shared(this)](const JobReport& report) {
      MutexLock lock(self->mutex_);
      self->report_ = report;
      self->Advance();
    };
    question.progress = [self = this->Shared(this)](const Progress& progress) {
      self->SetProgress(progress);
    };
    absl::StatusOr<QuestionCall> call =
        this->engine().StartQuestion(std::move(question));
    if (!call.ok()) return call.status();
    call_ = *std::move(call);
    MutexLock lock(mutex_);
    this->SetHeader(*call_.mesh, call_.algorithm);
    Announce();
    return absl::OkStatus();
  }

  void Cancel() final { this->engine().Cancel(call_); }

  absl::StatusOr<NextMessage> FillBlocks() final
      ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    if (!report_.has_value()) return NextMessage::kWait;
    if (!report_->status.ok()) return report_->status;
    if (!Put(*result_)) return NextMessage::kSend;
    this->SetCost(report_->seconds, report_->windows_propagated,
                  call_.tolerance);
    return NextMessage::kSendLast;
  }

  QuestionCall call_;  // set by AskEngine, then constant
  // The job's until it is done:
  const std::shared_ptr<Result> result_ = std::make_shared<Result>();
  std::optional<JobReport> report_ ABSL_GUARDED_BY(mutex_);
};

class IsolineStream final
    : public JobQuestion<v1::ComputeIsolinesRequest, std::vector<Isoline>> {
 public:
  using JobQuestion::JobQuestion;

 private:
  absl::StatusOr<Work> MakeWork(
      std::shared_ptr<std::vector<Isoline>> result) override {
    absl::Status status = CheckRequest();
    if (!status.ok()) return status;
    IsolineOptions isolines{
        .levels = {request().levels().begin(), request().levels().end()},
        .chord_error = request().chord_error()};
    return [isolines = std::move(isolines), result = std::move(result)](
               const Mesh& mesh, const ValidQuery& query,
               const SolveOptions& options, Checkpoint& checkpoint,
               ByteReservation& memory) {
      absl::StatusOr<std::vector<Isoline>> found =
          geodesic::ComputeIsolines(mesh, query, isolines, options, checkpoint);
      if (!found.ok()) return found.status();
      absl::Status room = memory.GrowTo(BytesOf(*found));
      if (room.ok()) *result = *std::move(found);
      return room;
    };
  }

  absl::Status CheckRequest() {
    const auto& levels = request().levels();
    if (levels.empty()) {
      return InvalidField("levels", "levels is empty: name at least one");
    }
    for (int i = 0; i < levels.size(); ++i) {
      if (std::isfinite(levels[i]) && levels[i] > 0) continue;
      const std::string field = absl::StrCat("levels[", i, "]");
      return InvalidField(field, absl::StrCat(field, " is ", levels[i],
                                              "; it must be finite and > 0"));
    }
    if (!(request().chord_error() >= 0)) {
      return InvalidField("chord_error", absl::StrCat("chord_error is ",
                                                      request().chord_error(),
                                                      "; it must be a number "
                                                      ">= 0"));
    }
    return CheckCount("levels", levels.size(), "max_levels",
                      engine().limits().max_levels);
  }

  static uint64_t BytesOf(const std::vector<Isoline>& isolines) {
    uint64_t bytes = isolines.capacity() * sizeof(Isoline);
    for (const Isoline& isoline : isolines) {
      bytes += isoline.points.capacity() * sizeof(SurfacePoint) +
               isoline.positions.capacity() * sizeof(Point);
    }
    return bytes;
  }

  void Announce() override ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    lines_.emplace(writer(), -1);
    level_ = writer().Announce("level", v1::VALUE_TYPE_FLOAT64, {-1});
    is_closed_ = writer().Announce("is_closed", v1::VALUE_TYPE_UINT8, {-1});
  }

  bool Put(const std::vector<Isoline>& isolines) override
      ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
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

  std::optional<codec::LineWriter> lines_ ABSL_GUARDED_BY(mutex_);
  // Arrays, set by Announce:
  uint32_t level_ = 0;
  uint32_t is_closed_ = 0;
};

class SampleStream final : public JobQuestion<v1::SampleFarthestPointsRequest,
                                              std::vector<FarthestSample>> {
 public:
  using JobQuestion::JobQuestion;

 private:
  absl::StatusOr<Work> MakeWork(
      std::shared_ptr<std::vector<FarthestSample>> result) override {
    const uint64_t count = request().count();
    if (count == 0) {
      return InvalidField("count", "count is 0; it must be at least 1");
    }
    absl::Status status = CheckCount("samples", count, "max_samples",
                                     engine().limits().max_samples);
    if (!status.ok()) return status;
    return [count, result = std::move(result)](
               const Mesh& mesh, const ValidQuery& query,
               const SolveOptions& options, Checkpoint& checkpoint,
               ByteReservation& memory) {
      absl::Status room =
          memory.GrowTo(std::min<uint64_t>(count, mesh.vertex_count()) *
                        sizeof(FarthestSample));
      if (!room.ok()) return room;
      auto found = geodesic::SampleFarthestPoints(
          mesh, query, static_cast<uint32_t>(count), options, checkpoint);
      if (found.ok()) *result = *std::move(found);
      return found.status();
    };
  }

  void Announce() override ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    vertex_ = writer().Announce("vertex", v1::VALUE_TYPE_UINT32, {-1});
    distance_ = writer().Announce("distance", value_type(), {-1});
  }

  bool Put(const std::vector<FarthestSample>& samples) override
      ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    return writer().Put(vertex_, 0, samples.size(), [&](uint64_t i) {
      return samples[i].vertex;
    }) && writer().Put(distance_, 0, samples.size(), [&](uint64_t i) {
      return samples[i].distance;
    });
  }

  // Arrays, set by Announce:
  uint32_t vertex_ = 0;
  uint32_t distance_ = 0;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_STREAMS_JOB_QUESTIONS_H_
