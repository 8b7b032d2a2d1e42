// Questions that are answered by a job of their own.

#ifndef GEODESIC_SERVER_RPC_STREAMS_JOB_QUESTION_H_
#define GEODESIC_SERVER_RPC_STREAMS_JOB_QUESTION_H_

#include <memory>
#include <optional>
#include <utility>

#include "absl/functional/any_invocable.h"
#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/checkpoint.h"
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
  // The work of the job. It charges `memory` with the result.
  using Work = absl::AnyInvocable<absl::StatusOr<Result>(
      const Mesh&, const ValidQuery&, const SolveOptions&, Checkpoint&,
      ByteReservation& memory)>;
  virtual absl::StatusOr<Work> MakeWork() = 0;
  // Announces the arrays.
  virtual void Announce() = 0;
  // Whether all was put, as AnswerWriter::Put.
  virtual bool Put(const Result& result) = 0;

 private:
  absl::Status AskEngine() final {
    absl::StatusOr<Work> work = MakeWork();
    if (!work.ok()) return work.status();
    QuestionRequest question;
    this->BeginQuestion(question);
    absl::Status status = AddSources(this->request().sources(),
                                     this->engine().limits(), question.query);
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
      self->Update([&] { self->report_ = report; });
    };
    question.progress = [self = this->Shared(this)](const Progress& progress) {
      self->SetProgress(progress);
    };
    absl::StatusOr<QuestionCall> call =
        this->engine().StartQuestion(std::move(question));
    if (!call.ok()) return call.status();
    call_ = *std::move(call);
    this->SetHeader(*call_.mesh, call_.algorithm);
    Announce();
    return absl::OkStatus();
  }

  void Cancel() final { this->engine().Cancel(call_); }

  absl::StatusOr<NextMessage> FillBlocks() final {
    if (!report_.has_value()) return NextMessage::kWait;
    if (!report_->status.ok()) return report_->status;
    if (!Put(*result_)) return NextMessage::kSend;
    this->SetCost(report_->seconds, report_->windows_propagated,
                  call_.tolerance);
    return NextMessage::kSendLast;
  }

  QuestionCall call_;  // set by AskEngine, then constant
  // The job's until it is done, then guarded by the stream's lock:
  const std::shared_ptr<Result> result_ = std::make_shared<Result>();
  // Guarded by the stream's lock:
  std::optional<JobReport> report_;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_STREAMS_JOB_QUESTION_H_
