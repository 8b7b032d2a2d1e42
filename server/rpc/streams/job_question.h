// Questions that are answered by a job of their own: ComputeIsolines and
// SampleFarthestPoints.

#ifndef GEODESIC_SERVER_RPC_STREAMS_JOB_QUESTION_H_
#define GEODESIC_SERVER_RPC_STREAMS_JOB_QUESTION_H_

#include <memory>
#include <optional>
#include <utility>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
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

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_STREAMS_JOB_QUESTION_H_
