// The base of every question. It reads what all requests have in common, and
// makes what all answers have: header, progress, trailer, and the answer's
// name, by which it is resumed.
//
// Newer progress replaces progress that was not sent. When the mesh is not
// prepared for an approximate algorithm, the stream waits for that and asks
// again.

#ifndef GEODESIC_SERVER_RPC_CALLS_ANSWER_STREAM_H_
#define GEODESIC_SERVER_RPC_CALLS_ANSWER_STREAM_H_

#include <grpcpp/alarm.h>
#include <grpcpp/server_context.h>

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "codec/answer_writer.h"
#include "digest/sha256.h"
#include "geodesic/v1/question_service.pb.h"
#include "server/engine/base/argument_checks.h"
#include "server/engine/base/clock.h"
#include "server/engine/query_engine.h"
#include "server/rpc/calls/one_request_call.h"
#include "server/rpc/messages/translation.h"

namespace geodesic::server {

// An answer that has begun sends something at least as often.
inline constexpr std::chrono::seconds kQuiet{5};

// A call's deadline on the engine's clock; gRPC gives it in system time.
inline TimePoint CallDeadline(const grpc::CallbackServerContext& context) {
  const auto deadline = context.deadline();
  const auto now = std::chrono::system_clock::now();
  // A deadline further away than this counts as none.
  if (deadline > now + std::chrono::hours(24 * 365)) return kNoDeadline;
  return std::chrono::steady_clock::now() + (deadline - now);
}

template <typename RequestType>
class AnswerStream : public OneRequestCall<RequestType, v1::Answer> {
 public:
  using OneRequestCall<RequestType, v1::Answer>::OneRequestCall;

  void OnDone() final {
    std::optional<grpc::Alarm> watch;
    {
      MutexLock lock(mutex_);
      // Ended without the lock: that may wait for OnQuiet.
      watch = std::exchange(quiet_watch_, std::nullopt);
    }
    watch.reset();
    Base::OnDone();
  }

 protected:
  using Base = OneRequestCall<RequestType, v1::Answer>;
  using Base::mutex_;

  // As Ask. Calls BeginQuestion and, if the engine takes the question,
  // SetHeader and the writer's Announce.
  virtual absl::Status AskEngine() = 0;

  // Puts what is ready of the answer's arrays into the message. kSend: that is
  // full; kWait: no more is ready; kSendLast: all was put, and SetCost called.
  // Computes nothing, since it runs on a thread of gRPC. An error ends the
  // answer when what was put before is sent.
  virtual absl::StatusOr<NextMessage> FillBlocks()
      ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) = 0;

  // Bytes that differ between answers to equal questions whose numbers may
  // differ. Called with the first numbers.
  virtual std::string Variant() const ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    return "";
  }

  // Sets what every question has.
  template <typename Question>
  void BeginQuestion(Question& question) {
    question.mesh_digest = this->mesh_digest();
    question.deadline = deadline();
    if constexpr (requires { question.method; }) question.method = method_;
    if constexpr (requires { question.query; }) {
      if (const auto* exact = std::get_if<Algorithm>(&algorithm_)) {
        question.query.algorithm = *exact;
      }
      question.query.tolerance = tolerance_;
    } else if constexpr (requires { question.tolerance; }) {
      question.tolerance = tolerance_;
    }
    MutexLock lock(mutex_);
    question.requester = requester();
  }

  // `algorithm`: the one that runs.
  void SetHeader(const ResidentMesh& mesh, const AlgorithmChoice& algorithm,
                 v1::AnswerOrigin origin = v1::ANSWER_ORIGIN_COMPUTED)
      ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    algorithm_ = algorithm;
    header_ = MakeHeader(mesh, algorithm, this->version());
    header_.set_origin(origin);
    trailer_.set_origin(origin);
  }

  // `certified_error` 0: the answer is exact, or approximate.
  void SetCost(double seconds, uint64_t windows_propagated,
               double certified_error) ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    trailer_.set_compute_seconds(seconds);
    trailer_.set_windows_propagated(windows_propagated);
    trailer_.set_relative_tolerance(
        RelativeTolerance(algorithm_, certified_error));
    if (certified_error > 0) trailer_.set_certified_error(certified_error);
  }

  void SetProgress(const Progress& progress) {
    MutexLock lock(mutex_);
    progress_ = ToProto(progress);
    has_news_ = true;
    this->Advance();
  }
  // May be called at any time by whoever makes items of the answer.
  void SetNews() {
    MutexLock lock(mutex_);
    has_news_ = true;
    this->Advance();
  }

  TimePoint deadline() const { return CallDeadline(this->context_); }
  Requester requester() ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    return Base::requester(is_batch_);
  }
  double tolerance() const { return tolerance_; }
  // Of the numbers whose type the request chooses.
  v1::ValueType value_type() const { return value_type_; }
  bool is_resumed() const { return resumption_.has_value(); }

  codec::AnswerWriter& writer() ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    return *writer_;
  }
  v1::AnswerTrailer& trailer() ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    return trailer_;
  }
  // What is sent next while nothing is ready.
  v1::SolveProgress& progress() ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    return progress_;
  }

 private:
  using Base::finished_;

  absl::Status Ask() final {
    RequestType& request = this->request();
    absl::Status status = ReadRequest(request);
    if (status.ok()) status = AskEngine();
    if (!status.ok()) return status;
    method_.reset();
    // Whatever these are, the answer is the same.
    request.clear_priority();
    request.clear_resumption();
    MutexLock lock(mutex_);
    name_.Update(this->version());
    name_.Update(request.SerializeAsString());
    return absl::OkStatus();
  }

  // What every request has but the mesh. Errors: INVALID_ARGUMENT; NOT_FOUND.
  absl::Status ReadRequest(const RequestType& request) {
    absl::StatusOr<v1::ValueType> type = ResolveValueType(request.value_type());
    if (!type.ok()) return type.status();
    value_type_ = *type;
    const absl::StatusOr<bool> is_batch = IsBatch(request.priority());
    if (!is_batch.ok()) return is_batch.status();
    is_batch_ = *is_batch;
    tolerance_ = request.tolerance();
    absl::StatusOr<AlgorithmChoice> choice =
        ReadAlgorithm(QuestionNamed(MethodOf<RequestType>()),
                      request.algorithm(), request.approximation(), tolerance_);
    if (!choice.ok()) return choice.status();
    algorithm_ = *std::move(choice);
    if (request.has_resumption()) resumption_ = request.resumption();
    {
      MutexLock lock(mutex_);
      writer_.emplace(
          std::vector<uint64_t>(request.resumption().received().begin(),
                                request.resumption().received().end()));
    }
    const auto* method = std::get_if<MethodChoice>(&algorithm_);
    return method != nullptr ? FindMethod(*method) : absl::OkStatus();
  }

  // Sets method_. If that is not prepared yet the engine says so, unless it
  // refuses the question anyway, and it is prepared then.
  absl::Status FindMethod(const MethodChoice& choice) {
    if (method_.has_value()) return absl::OkStatus();
    absl::StatusOr<MeshHandle> mesh =
        this->engine().meshes().Get(this->mesh_digest(), "mesh_digest");
    if (!mesh.ok()) return mesh.status();
    method_ = this->engine().methods().Find(*mesh, choice);
    if (!method_.has_value()) method_ = {.mesh = *mesh, .choice = choice};
    return absl::OkStatus();
  }

  bool AwaitWhatIsMissing(const absl::Status& status) final {
    if (!IsNotPrepared(status)) return false;
    // A copy, since method_ changes when it is prepared.
    this->AskAfter([this, unprepared = *method_](
                       const Requester& caller,
                       auto done) -> absl::StatusOr<std::function<void()>> {
      MethodEngine& methods = this->engine().methods();
      absl::StatusOr<MethodJobs::Ticket> ticket = methods.Prepare(
          unprepared.mesh, unprepared.choice,
          {.done =
               [self = this->Shared(this),
                done](const absl::StatusOr<MethodHandle>& prepared) {
                 if (prepared.ok()) self->method_ = *prepared;
                 done(prepared.status());
               },
           .progress = nullptr},
          caller);
      if (!ticket.ok()) return ticket.status();
      return [&methods, ticket = *ticket] { methods.Leave(ticket); };
    });
    return true;
  }

  absl::StatusOr<NextMessage> Fill(v1::Answer& message) final
      ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    message.Clear();
    writer_->Begin(message);
    absl::StatusOr<NextMessage> next =
        failure_.ok() ? FillBlocks() : absl::StatusOr<NextMessage>(failure_);
    const bool has_blocks = message.blocks_size() > 0;
    if (!next.ok()) {
      failure_ = next.status();
      if (!has_blocks) return failure_;
      next = NextMessage::kSend;
    }
    const bool is_last = *next == NextMessage::kSendLast;
    if (has_blocks || is_last) {
      absl::Status status = SetName(message);
      if (status.ok() && is_last) status = writer_->CheckReceived();
      if (!status.ok()) return status;
    } else if (has_header_) {
      if (!std::exchange(has_news_, false)) {
        if (!quiet_watch_.has_value()) WatchQuiet();
        return NextMessage::kWait;
      }
      *message.mutable_progress() = progress_;
    }
    if (!std::exchange(has_header_, true)) {
      *message.mutable_header() = std::move(header_);
      *message.mutable_header()->mutable_arrays() = writer_->infos();
    }
    if (is_last) *message.mutable_trailer() = std::move(trailer_);
    this->entry().add_bytes(writer_->bytes());
    ++sent_;
    return is_last ? NextMessage::kSendLast : NextMessage::kSend;
  }

  // Of the first message with numbers, or the last one. Errors: NOT_FOUND: the
  // answer to be resumed was another one.
  absl::Status SetName(v1::Answer& message)
      ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    if (std::exchange(is_named_, true)) return absl::OkStatus();
    name_.Update(Variant());
    message.set_answer_id(name_.FinishHex());
    return resumption_.has_value() &&
                   resumption_->answer_id() != message.answer_id()
               ? AnswerNotKept()
               : absl::OkStatus();
  }

  // A client that hears nothing cannot tell waiting from a broken connection,
  // and gRPC takes its pings for an attack if nothing is sent between them.
  void WatchQuiet() ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    quiet_watch_.emplace();
    // What was sent last may have been sent just after a watch began.
    quiet_watch_->Set(
        std::chrono::system_clock::now() + kQuiet / 2,
        [self = this->Shared(this), sent = sent_](bool has_passed) {
          if (has_passed) self->OnQuiet(sent);
        });
  }

  // Sends the last progress again, or that there is none.
  void OnQuiet(uint64_t sent) {
    MutexLock lock(mutex_);
    if (finished_ || !quiet_watch_.has_value()) return;
    has_news_ |= sent == sent_;
    this->Advance();
    WatchQuiet();
  }

  // Set by Ask, then constant:
  v1::ValueType value_type_ = v1::VALUE_TYPE_FLOAT64;
  bool is_batch_ = false;
  AlgorithmChoice algorithm_ = kDefaultAlgorithm;
  double tolerance_ = 0;
  std::optional<v1::Resumption> resumption_;
  // Of an approximate question; what Ask and its waits set, one after the
  // other.
  std::optional<MethodHandle> method_;

  std::optional<codec::AnswerWriter> writer_ ABSL_GUARDED_BY(mutex_);
  Sha256 name_ ABSL_GUARDED_BY(mutex_);
  bool is_named_ ABSL_GUARDED_BY(mutex_) = false;
  v1::AnswerHeader header_ ABSL_GUARDED_BY(mutex_);  // until it is sent
  bool has_header_ ABSL_GUARDED_BY(mutex_) = false;  // sent
  v1::SolveProgress progress_ ABSL_GUARDED_BY(mutex_);
  // progress_ was not sent.
  bool has_news_ ABSL_GUARDED_BY(mutex_) = false;
  v1::AnswerTrailer trailer_ ABSL_GUARDED_BY(mutex_);
  absl::Status failure_ ABSL_GUARDED_BY(mutex_);  // to be sent
  uint64_t sent_ ABSL_GUARDED_BY(mutex_) = 0;     // messages
  std::optional<grpc::Alarm> quiet_watch_ ABSL_GUARDED_BY(mutex_);
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_CALLS_ANSWER_STREAM_H_
