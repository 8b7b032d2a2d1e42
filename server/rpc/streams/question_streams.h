// Streams of one question: header, progress, parts, trailer.

#ifndef GEODESIC_SERVER_RPC_STREAMS_QUESTION_STREAMS_H_
#define GEODESIC_SERVER_RPC_STREAMS_QUESTION_STREAMS_H_

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "absl/functional/any_invocable.h"
#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/algorithm.h"
#include "geodesic/checkpoint.h"
#include "geodesic/isolines.h"
#include "geodesic/path.h"
#include "geodesic/sampling.h"
#include "geodesic/v1/field_service.pb.h"
#include "geodesic/v1/path_service.pb.h"
#include "server/engine/jobs/row_pipeline.h"
#include "server/engine/meshes/mesh_store.h"
#include "server/rpc/calls/answer_stream.h"
#include "server/rpc/messages/translation.h"

namespace geodesic::server {

// The work that an answer took.
struct AnswerCost {
  double seconds = 0;
  uint64_t windows_propagated = 0;
};

// The classes FieldQuestionStream and JobQuestionStream, below, ask the engine.
template <typename Request, typename Response>
class QuestionStream : public AnswerStream<Request, Response> {
 public:
  using AnswerStream<Request, Response>::AnswerStream;

 protected:
  // Fills the next part of the answer; kSendLast when there is none left.
  // Called under the stream's lock, after SetFinished. Makes messages of what
  // is there, and computes nothing: it runs on a thread of gRPC.
  virtual absl::StatusOr<NextMessage> FillPart(Response& message) = 0;

  // For Ask:
  void SetSubject(MeshHandle mesh, Algorithm algorithm, double tolerance) {
    mesh_ = std::move(mesh);
    algorithm_ = algorithm;
    tolerance_ = tolerance;
  }

  void SetProgress(const Progress& progress) {
    this->Update([&] { progress_ = ToProto(progress); });
  }

  // `change` stores the answer where FillPart finds it.
  template <typename Change>
  void SetFinished(absl::Status status, AnswerCost cost, Change change) {
    this->Update([&] {
      change();
      cost_ = cost;
      status_ = std::move(status);
    });
  }

  // Guarded by the stream's lock: items that were sent, for the trailer.
  uint64_t next_item_ = 0;

 private:
  absl::StatusOr<NextMessage> Fill(Response& message) final {
    if (!std::exchange(has_header_, true)) {
      *message.mutable_header() =
          MakeHeader(*mesh_, algorithm_, this->version(), tolerance_);
      return NextMessage::kSend;
    }
    if (!status_.has_value()) {
      if (!progress_.has_value()) return NextMessage::kWait;
      *message.mutable_progress() = *std::exchange(progress_, {});
      return NextMessage::kSend;
    }
    if (!status_->ok()) return *status_;
    absl::StatusOr<NextMessage> part = FillPart(message);
    if (!part.ok() || *part != NextMessage::kSendLast) return part;
    *message.mutable_trailer() = MakeTrailer(
        cost_.seconds, cost_.windows_propagated, next_item_, tolerance_);
    return NextMessage::kSendLast;
  }

  MeshHandle mesh_;
  Algorithm algorithm_ = kDefaultAlgorithm;
  double tolerance_ = 0;

  // Guarded by the stream's lock:
  bool has_header_ = false;
  std::optional<v1::SolveProgress> progress_;  // newer than what was sent
  std::optional<absl::Status> status_;
  AnswerCost cost_;
};

// Questions that a field answers.
template <typename Request, typename Response>
class FieldQuestionStream : public QuestionStream<Request, Response>,
                            public FieldObserver {
 public:
  using QuestionStream<Request, Response>::QuestionStream;

  void OnProgress(const Progress& progress) final {
    this->SetProgress(progress);
  }

  void OnField(const absl::StatusOr<FieldAnswer>& answer) final {
    if (!answer.ok()) {
      this->SetFinished(answer.status(), {}, [] {});
      return;
    }
    AnswerCost cost;
    if (answer->origin != FieldOrigin::kCached) {
      const SolveStatistics& statistics = answer->field->statistics;
      cost = {statistics.solve_seconds, statistics.windows_propagated};
    }
    this->SetFinished(absl::OkStatus(), cost, [&] { answer_ = *answer; });
  }

 protected:
  // Adds to `question` what only this stream knows.
  virtual absl::Status Translate(FieldRequest& question) = 0;

  // Constant once Ask has succeeded.
  const FieldCall& call() const { return *call_; }
  TimePoint deadline() const { return deadline_; }
  bool is_batch() const { return is_batch_; }
  // For FillPart.
  const FieldAnswer& answer() const { return answer_; }

  void Cancel() override { this->engine().fields().Cancel(*call_); }

 private:
  absl::Status Ask() final {
    FieldRequest question;
    absl::Status status = this->BeginQuestion(question);
    if (status.ok()) status = Translate(question);
    if (!status.ok()) return status;
    if (this->request().has_radius()) {
      question.reach.radius = this->request().radius();
    }
    absl::StatusOr<FieldCall> call =
        this->engine().fields().Compute(question, this->Shared(this));
    if (!call.ok()) return call.status();
    call_ = *std::move(call);
    deadline_ = question.deadline;
    is_batch_ = question.requester.is_batch;
    this->SetSubject(call_->mesh, call_->query->algorithm, /*tolerance=*/0);
    return absl::OkStatus();
  }

  std::optional<FieldCall> call_;
  TimePoint deadline_ = kNoDeadline;
  bool is_batch_ = false;
  FieldAnswer answer_;  // guarded by the stream's lock
};

// Questions that are answered by a job of their own, which makes a Result.
template <typename Request, typename Response, typename Result>
class JobQuestionStream : public QuestionStream<Request, Response> {
 public:
  using QuestionStream<Request, Response>::QuestionStream;

 protected:
  // The work of the job. It charges `memory` with the result.
  using Work = absl::AnyInvocable<absl::StatusOr<Result>(
      const Mesh&, const ValidQuery&, const SolveOptions&, Checkpoint&,
      ByteReservation& memory)>;
  virtual absl::StatusOr<Work> MakeWork() = 0;

  // For FillPart.
  const Result& result() const { return *result_; }

 private:
  absl::Status Ask() final {
    absl::StatusOr<Work> work = MakeWork();
    if (!work.ok()) return work.status();
    QuestionRequest question;
    absl::Status status = this->BeginQuestion(question);
    if (!status.ok()) return status;
    status = AddSources(this->request().sources(), this->engine().limits(),
                        question.query);
    if (!status.ok()) return status;
    question.work = [result = result_, work = *std::move(work)](
                        const Mesh& mesh, const ValidQuery& query,
                        const SolveOptions& options, Checkpoint& checkpoint,
                        ByteReservation& memory) mutable {
      absl::StatusOr<Result> found =
          work(mesh, query, options, checkpoint, memory);
      if (found.ok()) *result = *std::move(found);
      return found.status();
    };
    question.done = [self = this->Shared(this)](const JobReport& report) {
      self->SetFinished(report.status,
                        {report.seconds, report.windows_propagated}, [] {});
    };
    question.progress = [self = this->Shared(this)](const Progress& progress) {
      self->SetProgress(progress);
    };
    absl::StatusOr<QuestionCall> call =
        this->engine().StartQuestion(std::move(question));
    if (!call.ok()) return call.status();
    call_ = *std::move(call);
    this->SetSubject(call_.mesh, call_.algorithm, call_.tolerance);
    return absl::OkStatus();
  }

  void Cancel() final { this->engine().Cancel(call_); }

  QuestionCall call_;  // set by Ask, then constant
  // The job's until it is done, then guarded by the stream's lock:
  const std::shared_ptr<Result> result_ = std::make_shared<Result>();
};

// The parts are paths, in order of target.
class PathStream final : public FieldQuestionStream<v1::ComputePathsRequest,
                                                    v1::ComputePathsResponse> {
 public:
  using FieldQuestionStream::FieldQuestionStream;

 private:
  absl::Status Translate(FieldRequest& question) override;
  void Cancel() override;
  absl::StatusOr<NextMessage> FillPart(
      v1::ComputePathsResponse& message) override;
  // The path to the next target, if it is there: those that were not searched
  // for are traced in jobs, which it starts.
  std::optional<absl::StatusOr<GeodesicPath>> TakeNext();

  // Guarded by the stream's lock:
  std::shared_ptr<RowPipeline> rows_;  // unless paths were searched for
  MatrixRow row_;                      // whose paths are being sent
  size_t next_in_row_ = 0;
  // The path that is being sent, and how many of its points were.
  GeodesicPath path_;
  uint64_t next_point_ = 0;
};

// The parts are isolines.
class IsolineStream final
    : public JobQuestionStream<v1::ComputeIsolinesRequest,
                               v1::ComputeIsolinesResponse,
                               std::vector<Isoline>> {
 public:
  using JobQuestionStream::JobQuestionStream;

 private:
  absl::StatusOr<Work> MakeWork() override;
  absl::StatusOr<NextMessage> FillPart(
      v1::ComputeIsolinesResponse& message) override;

  uint64_t next_point_ = 0;  // of the isoline; guarded by the stream's lock
};

// The parts are the frame and chunks of coordinates; the items are vertices.
class LogMapStream final
    : public FieldQuestionStream<v1::ComputeLogMapRequest,
                                 v1::ComputeLogMapResponse> {
 public:
  using FieldQuestionStream::FieldQuestionStream;

 private:
  absl::Status Translate(FieldRequest& question) override;
  absl::StatusOr<NextMessage> FillPart(
      v1::ComputeLogMapResponse& message) override;

  // Set by Translate, then constant:
  v1::ValueType value_type_ = v1::VALUE_TYPE_FLOAT64;

  // Guarded by the stream's lock:
  bool has_frame_ = false;
  std::vector<double> values_;
};

// The parts are chunks of samples.
class SampleStream final
    : public JobQuestionStream<v1::SampleFarthestPointsRequest,
                               v1::SampleFarthestPointsResponse,
                               std::vector<FarthestSample>> {
 public:
  using JobQuestionStream::JobQuestionStream;

 private:
  absl::StatusOr<Work> MakeWork() override;
  absl::StatusOr<NextMessage> FillPart(
      v1::SampleFarthestPointsResponse& message) override;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_STREAMS_QUESTION_STREAMS_H_
