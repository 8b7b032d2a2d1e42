// The base of every call with one request. It receives and decodes the request
// and sends the answer one message at a time; the next message is made when
// gRPC has taken the last one.
//
// The request is freed once the engine has been asked. A slow reader costs one
// message and what the answer pins; newer progress replaces progress that was
// not sent. When the mesh is on disk but not in memory, or is not prepared for
// an approximate algorithm, the stream waits for that and asks again.

#ifndef GEODESIC_SERVER_RPC_CALLS_ANSWER_STREAM_H_
#define GEODESIC_SERVER_RPC_CALLS_ANSWER_STREAM_H_

#include <grpcpp/alarm.h>
#include <grpcpp/server_context.h>

#include <chrono>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "absl/strings/str_cat.h"
#include "geodesic_types/field_path.h"
#include "server/engine/base/byte_budget.h"
#include "server/engine/base/clock.h"
#include "server/engine/base/status_details.h"
#include "server/engine/query_engine.h"
#include "server/rpc/calls/call.h"
#include "server/rpc/messages/translation.h"

namespace geodesic::server {

// A stream that has begun its answer sends something at least as often, until
// its first part is there.
inline constexpr std::chrono::seconds kQuiet{5};

// What a stream does next.
enum class NextMessage {
  kWait,  // there is nothing to send yet
  kSend,
  kSendLast,
};

// "ComputeField" for ComputeFieldRequest.
template <typename Request>
std::string_view MethodOf() {
  constexpr std::string_view kSuffix = "Request";
  std::string_view name = Request::descriptor()->name();
  name.remove_suffix(kSuffix.size());
  return name;
}

// The digest of the mesh that a request is about; "" if it is about none.
template <typename Request>
std::string MeshDigestOf(const Request& request) {
  if constexpr (requires { request.mesh_digest(); }) {
    return request.mesh_digest();
  } else if constexpr (requires { request.digest(); }) {
    return request.digest();
  } else {
    return "";
  }
}

// A call's deadline on the engine's clock; gRPC gives it in system time.
inline TimePoint CallDeadline(const grpc::CallbackServerContext& context) {
  const auto deadline = context.deadline();
  const auto now = std::chrono::system_clock::now();
  // A deadline further away than this counts as none.
  if (deadline > now + std::chrono::hours(24 * 365)) return kNoDeadline;
  return std::chrono::steady_clock::now() + (deadline - now);
}

// A derived class asks the engine and makes the messages. Launch (service.h)
// starts it.
template <typename RequestType, typename ResponseType>
class AnswerStream : public Call<ResponseType> {
 public:
  using Request = RequestType;
  using Response = ResponseType;

  // REQUIRES: as Call.
  AnswerStream(const ServiceContext& service,
               grpc::CallbackServerContext& context)
      : Base(service, MethodOf<Request>(), context) {}

  void OnWriteDone(bool ok) final {
    std::lock_guard lock(mutex_);
    writing_ = false;
    is_quiet_ = false;
    this->OnTaken();
    if (!ok) {
      // The stream is broken; OnCancel tells the engine.
      this->EndCancelled();
      return;
    }
    Advance();
  }

  void OnCancel() final {
    std::function<void()> leave;
    bool begun = false;
    {
      std::lock_guard lock(mutex_);
      cancelled_ = true;
      if (!is_asking_) this->EndCancelled();
      leave = std::exchange(leave_, nullptr);
      begun = begun_;
    }
    // Called without the lock, because the engine has its own.
    if (leave) leave();
    if (begun) Cancel();
  }

  void OnDone() final {
    std::optional<grpc::Alarm> watch;
    {
      std::lock_guard lock(mutex_);
      request_.reset();
      memory_ = {};
      // Ended without the lock: that may wait for OnQuiet.
      watch = std::exchange(quiet_watch_, std::nullopt);
    }
    watch.reset();
    Base::OnDone();
  }

 protected:
  using Call<ResponseType>::service_;

  // Asks the engine, which may call back at once. Called without the lock, and
  // again once the mesh has come from disk if it was not found before, or has
  // been prepared. The
  // request and the context stay valid until it returns, even if the client
  // goes.
  virtual absl::Status Ask() = 0;

  // Tells the engine that the caller waits no longer. Called at most once,
  // after Ask succeeded, without the lock.
  virtual void Cancel() {}

  // Makes the next message, under the lock. An error ends the stream.
  virtual absl::StatusOr<NextMessage> Fill(Response& message) = 0;

  // Calls `change` on what Fill reads, then sends the messages that are ready.
  template <typename Change>
  void Update(Change change) {
    std::lock_guard lock(mutex_);
    change();
    Advance();
  }

  // Sets what every question has: the mesh, the deadline, the client, and the
  // algorithm and the tolerance of one that has them; for an approximate
  // algorithm that is a method which is prepared. Errors: INVALID_ARGUMENT;
  // others, which Ask passes on.
  template <typename Question>
  absl::Status BeginQuestion(Question& question) {
    question.mesh_digest = mesh_digest_;
    question.deadline = CallDeadline(context_);
    const absl::StatusOr<bool> is_batch = IsBatch(request().priority());
    if (!is_batch.ok()) return is_batch.status();
    question.requester = requester(*is_batch);
    const absl::StatusOr<AlgorithmChoice> choice = ChoiceOf(request());
    if (!choice.ok()) return choice.status();
    if constexpr (requires { request().tolerance(); }) {
      absl::Status status = CheckTolerance(request().tolerance(), *choice);
      if (!status.ok()) return status;
      if constexpr (requires { question.query; }) {
        question.query.tolerance = request().tolerance();
      } else {
        question.tolerance = request().tolerance();
      }
    }
    if (const auto* exact = std::get_if<Algorithm>(&*choice)) {
      if constexpr (requires { question.query; }) {
        question.query.algorithm = *exact;
        return absl::OkStatus();
      } else {
        return *exact == kDefaultAlgorithm
                   ? absl::OkStatus()
                   : InvalidField("algorithm",
                                  "algorithm: exact distances of pairs are "
                                  "searched for by the default algorithm; "
                                  "leave it out or name an approximate one");
      }
    }
    const auto& method = std::get<MethodChoice>(*choice);
    if constexpr (requires { request().approximation(); }) {
      absl::Status status = FindMethod(method);
      question.method = method_;
      return status;
    } else {
      return InvalidField(
          "algorithm",
          absl::StrCat(
              "algorithm: ", std::string(ApproximateMethodName(method.method)),
              " is approximate, and ", std::string(MethodOf<Request>()),
              " answers exactly: name an exact algorithm or none; "
              "ComputeField, ComputeMatrix, FindNearest and "
              "ComputePairs take approximate ones"));
    }
  }

  RequestLog::Entry& entry() { return *entry_; }
  // The caller, for the engine. Before the call has ended.
  Requester requester(bool is_batch = false) {
    return {.client = entry_->client(),
            .is_batch = is_batch,
            .account = entry_->job()};
  }
  const std::string& version() const { return service_.capabilities.version(); }
  // For Ask. An Ask that is about to succeed may change it.
  Request& request() { return *request_; }

 private:
  using Base = Call<ResponseType>;
  using Base::context_;
  using Base::entry_;
  using Base::finished_;
  using Base::mutex_;

  void OnReceived(bool ok) final {
    {
      std::lock_guard lock(mutex_);
      if (finished_) return;
      if (absl::Status status = Receive(ok); !status.ok()) {
        this->End(std::move(status));
        return;
      }
      is_asking_ = true;
    }
    GoOn(Ask());
  }

  // `ok`: a message came. Errors: as Intake::Decode. REQUIRES: mutex_ held.
  absl::Status Receive(bool ok) {
    if (!ok) return absl::InvalidArgumentError(kNoMessage);
    request_.emplace();
    absl::StatusOr<ByteReservation> memory = this->Decode(*request_);
    if (!memory.ok()) return memory.status();
    memory_ = *std::move(memory);
    mesh_digest_ = MeshDigestOf(*request_);
    if (!mesh_digest_.empty()) entry_->set_subject(DigestPrefix(mesh_digest_));
    return absl::OkStatus();
  }

  // The algorithm that the request names, if it has a word for it.
  static absl::StatusOr<AlgorithmChoice> ChoiceOf(const Request& request) {
    if constexpr (requires { request.approximation(); }) {
      return FromProto(request.algorithm(), request.approximation());
    } else {
      return FromProto(request.algorithm(), {});
    }
  }

  // Sets method_. If that is not prepared yet the engine says so, unless it
  // refuses the question anyway, and GoOn has it prepared.
  absl::Status FindMethod(const MethodChoice& choice) {
    if (method_.has_value()) return absl::OkStatus();
    absl::StatusOr<MeshHandle> mesh =
        service_.engine.meshes().Get(mesh_digest_, "mesh_digest");
    if (!mesh.ok()) return mesh.status();
    method_ = service_.engine.methods().Find(*mesh, choice);
    if (!method_.has_value()) method_ = {.mesh = *mesh, .choice = choice};
    return absl::OkStatus();
  }

  // Waits for what `start` begins, then asks again. `start` gets the caller and
  // a function to call at the end, with the status and whatever must be pinned
  // meanwhile, and returns what ends the wait; nothing if it has ended.
  template <typename Start>
  void AskAfter(Start start) {
    Requester caller;
    {
      std::lock_guard lock(mutex_);
      is_asking_ = false;
      if (cancelled_) {
        this->EndCancelled();
        return;
      }
      caller = requester();
    }
    absl::StatusOr<std::function<void()>> leave =
        start(std::exchange(caller, {}),
              [self = this->Shared(this)](absl::Status status) {
                self->OnAwaited(std::move(status));
              });
    {
      std::lock_guard lock(mutex_);
      if (!leave.ok()) this->End(leave.status());
      if (!leave.ok() || !*leave) return;
      if (!finished_) {
        leave_ = *std::move(leave);
        return;
      }
    }
    (*leave)();
  }

  void AwaitMesh() {
    AskAfter([this](const Requester& caller,
                    auto done) -> absl::StatusOr<std::function<void()>> {
      MeshLibrary& meshes = service_.engine.meshes();
      // The mesh is pinned while the engine is asked.
      absl::StatusOr<MeshLoads::Ticket> ticket = meshes.Await(
          mesh_digest_,
          [done](const absl::StatusOr<MeshHandle>& mesh) {
            done(mesh.status());
          },
          caller.client);
      if (!ticket.ok()) return ticket.status();
      if (ticket->entry == nullptr) return std::function<void()>();
      return [&meshes, ticket = *ticket] { meshes.Leave(ticket); };
    });
  }

  // `unprepared`: a copy, since method_ changes when it is prepared.
  void AwaitMethod(MethodHandle unprepared) {
    AskAfter([&](const Requester& caller,
                 auto done) -> absl::StatusOr<std::function<void()>> {
      MethodEngine& methods = service_.engine.methods();
      absl::StatusOr<MethodJobs::Ticket> ticket = methods.Prepare(
          unprepared.mesh, unprepared.choice,
          {.done =
               [self = this->Shared(this),
                done](const absl::StatusOr<MethodHandle>& prepared) {
                 if (prepared.ok()) self->SetMethod(*prepared);
                 done(prepared.status());
               },
           .progress = nullptr},
          caller);
      if (!ticket.ok()) return ticket.status();
      return [&methods, ticket = *ticket] { methods.Leave(ticket); };
    });
  }

  void SetMethod(const MethodHandle& method) {
    std::lock_guard lock(mutex_);
    method_ = method;
  }

  void OnAwaited(absl::Status status) {
    {
      std::lock_guard lock(mutex_);
      // After Finish the request may be gone.
      if (finished_) return;
      is_asking_ = true;
    }
    GoOn(status.ok() ? Ask() : std::move(status));
  }

  // The shared tier is asked once for a call.
  bool MayBringMesh() {
    MeshLibrary& meshes = service_.engine.meshes();
    if (meshes.Contains(mesh_digest_)) return true;
    return meshes.has_shared_tier() && !std::exchange(has_asked_tier_, true);
  }

  // `status` is the result of Ask.
  void GoOn(absl::Status status) {
    // Bringing the mesh only helps if the mesh is what was not found.
    if (MeshAtFault(status).has_value() && MayBringMesh()) {
      AwaitMesh();
      return;
    }
    if (IsNotPrepared(status)) {
      AwaitMethod(*method_);
      return;
    }
    bool cancel = false;
    {
      std::lock_guard lock(mutex_);
      is_asking_ = false;
      if (!status.ok()) {
        this->End(std::move(status));
        return;
      }
      // They are of no more use.
      request_.reset();
      method_.reset();
      Intake::ReleaseRequest(memory_);
      begun_ = true;
      cancel = cancelled_;
      if (cancelled_) this->EndCancelled();
      Advance();
    }
    if (cancel) Cancel();
  }

  // REQUIRES: mutex_ held.
  void Advance() {
    if (!begun_ || writing_ || finished_) return;
    absl::StatusOr<NextMessage> next = Fill(message_);
    if (!next.ok()) {
      this->End(next.status());
    } else if (*next == NextMessage::kSend) {
      writing_ = true;
      this->Write(&message_);
    } else if (*next == NextMessage::kSendLast) {
      this->End(absl::OkStatus(), &message_);
    } else if (!quiet_watch_.has_value()) {
      WatchQuiet();
    }
  }

  // A client that hears nothing cannot tell waiting from a broken connection,
  // and gRPC takes its pings for an attack if nothing is sent between them.
  // REQUIRES: mutex_ held.
  void WatchQuiet() {
    if constexpr (requires { message_.mutable_progress(); }) {
      is_quiet_ = true;
      quiet_watch_.emplace();
      // What was sent last may have been sent just after a watch began.
      quiet_watch_->Set(std::chrono::system_clock::now() + kQuiet / 2,
                        [self = this->Shared(this)](bool has_passed) {
                          if (has_passed) self->OnQuiet();
                        });
    }
  }

  // Sends the last progress again, or that there is none, in an answer that has
  // no more than its header.
  void OnQuiet() {
    std::lock_guard lock(mutex_);
    if (finished_ || !quiet_watch_.has_value()) return;
    if (is_quiet_ && !writing_ &&
        (message_.has_header() || message_.has_progress())) {
      message_.mutable_progress();
      writing_ = true;
      this->Write(&message_);
    }
    WatchQuiet();
  }

  // Guarded by mutex_:
  std::string mesh_digest_;  // set by Receive, then constant
  ByteReservation memory_;   // of the request and the question
  bool is_asking_ = false;   // Ask runs, or is about to
  bool begun_ = false;       // Ask succeeded
  bool has_asked_tier_ = false;
  std::function<void()> leave_;  // ends a wait for the mesh or for a method
  bool cancelled_ = false;
  bool writing_ = false;  // a message is on its way
  std::optional<grpc::Alarm> quiet_watch_;
  bool is_quiet_ = false;  // nothing was sent since quiet_watch_ was set
  Response message_;

  // Set by Receive; Ask's while it runs:
  std::optional<Request> request_;
  // Of an approximate question; what Ask and its waits set, one after the
  // other.
  std::optional<MethodHandle> method_;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_CALLS_ANSWER_STREAM_H_
