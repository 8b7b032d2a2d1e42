// Questions about a field: ComputeField, ComputePaths and ComputeLogMap.

#ifndef GEODESIC_SERVER_RPC_STREAMS_FIELD_QUESTION_H_
#define GEODESIC_SERVER_RPC_STREAMS_FIELD_QUESTION_H_

#include <optional>
#include <utility>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
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

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_STREAMS_FIELD_QUESTION_H_
