// What every call shares that sends one request: it is let in, its request is
// received and decoded, and the answer goes out one message at a time, the next
// made when gRPC has taken that one.
//
// Who may not ask, or asks too much, is refused before anything of the request
// is received. The request is gone once the engine has been asked. A slow
// reader costs one message and what the answer pins, and what nobody took is
// overwritten by newer. Reactions and the engine's calls come from different
// threads, so everything happens under one lock. Two parties hold the object,
// gRPC until OnDone and the engine as long as it may call; the last to let go
// destroys it.
//
// When the mesh is on disk and not in memory, the stream waits for it and asks
// again.

#ifndef GEODESIC_SERVER_RPC_CALLS_ANSWER_STREAM_H_
#define GEODESIC_SERVER_RPC_CALLS_ANSWER_STREAM_H_

#include <grpcpp/server_context.h>
#include <grpcpp/support/byte_buffer.h>
#include <grpcpp/support/server_callback.h>

#include <chrono>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "server/engine/base/byte_budget.h"
#include "server/engine/base/clock.h"
#include "server/engine/query_engine.h"
#include "server/rpc/calls/call_deadline.h"
#include "server/rpc/calls/intake.h"
#include "server/rpc/calls/receive_slots.h"
#include "server/rpc/calls/request_log.h"
#include "server/rpc/calls/service_context.h"
#include "server/rpc/messages/field_translation.h"

namespace geodesic::server {

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

// A derived class says what is asked of the engine and what the messages are;
// Launch starts it (see service.h).
template <typename RequestType, typename ResponseType>
class AnswerStream
    : public grpc::ServerBidiReactor<grpc::ByteBuffer, ResponseType>,
      public Receiver,
      public std::enable_shared_from_this<
          AnswerStream<RequestType, ResponseType>> {
 public:
  using Request = RequestType;
  using Response = ResponseType;

  // REQUIRES: `service` outlives the call; `context` lives until gRPC is done
  // with it.
  AnswerStream(const ServiceContext& service,
               grpc::CallbackServerContext& context)
      : service_(service), context_(context) {
    entry_.emplace(service.log, MethodOf<Request>(), context);
  }

  // Begins; `self` is this, kept alive until gRPC is done with it.
  void Launch(std::shared_ptr<AnswerStream> self) {
    {
      std::lock_guard lock(mutex_);
      self_ = self;
      if (absl::Status status = Admit(*entry_); !status.ok()) {
        End(std::move(status));
        return;
      }
      arrival_.Start(service_.intake.patience(), [self] { self->OnLate(); });
    }
    service_.intake.slots().Enter(self, context_.peer());
  }

  void OnSlot() final {
    {
      std::lock_guard lock(mutex_);
      if (!finished_) {
        is_receiving_ = true;
        this->StartRead(&bytes_);
        return;
      }
    }
    service_.intake.slots().Leave(*this);
  }

  void OnBrokenOff() final {
    std::lock_guard lock(mutex_);
    if (!is_receiving_) return;
    if (!finished_) {
      End(BrokenOffError());
    } else {
      // Its client does not even take the answer.
      context_.TryCancel();
    }
  }

  void OnReadDone(bool ok) final {
    {
      std::lock_guard lock(mutex_);
      is_receiving_ = false;
    }
    service_.intake.slots().Leave(*this);
    {
      std::lock_guard lock(mutex_);
      arrival_.Stop();
      if (finished_) return;
      if (absl::Status status = Receive(ok); !status.ok()) {
        End(std::move(status));
        return;
      }
      is_asking_ = true;
    }
    GoOn(Ask());
  }

  void OnWriteDone(bool ok) final {
    std::lock_guard lock(mutex_);
    writing_ = false;
    entry_->add_write_time(std::chrono::steady_clock::now() - write_begin_);
    if (!ok) {
      // The stream is broken; OnCancel tells the engine.
      End(absl::CancelledError("the client is gone"));
      return;
    }
    Advance();
  }

  void OnCancel() final {
    std::optional<MeshLoads::Ticket> ticket;
    bool begun = false;
    {
      std::lock_guard lock(mutex_);
      cancelled_ = true;
      if (!is_asking_) EndCancelled();
      ticket = std::exchange(ticket_, {});
      begun = begun_;
    }
    // Without the lock, for the engine has its own.
    if (ticket) service_.engine.LeaveMesh(*ticket);
    if (begun) Cancel();
  }

  void OnDone() final {
    std::shared_ptr<AnswerStream> self;
    std::lock_guard lock(mutex_);
    entry_.reset();
    request_.reset();
    bytes_.Clear();
    memory_ = {};
    // The lock is released before `self`, which may be the last to hold it.
    self = std::move(self_);
  }

 protected:
  // Whether the caller may ask. Errors: as RequestLog::Entry.
  virtual absl::Status Admit(RequestLog::Entry& entry) {
    return entry.AdmitStream();
  }

  // Asks the engine, which may call back at once; called without the lock, and
  // once more after it failed with NOT_FOUND and the mesh came from the disk.
  // The request is there while it is called and then no more; the context, too,
  // though the client be gone.
  virtual absl::Status Ask() = 0;

  // The caller waits no longer; called once at most, after Ask succeeded and
  // without the lock.
  virtual void Cancel() = 0;

  // Makes the next message, under the lock. An error ends the stream.
  virtual absl::StatusOr<NextMessage> Fill(Response& message) = 0;

  // Changes what Fill sees, and sends what there is to send.
  template <typename Change>
  void Update(Change change) {
    std::lock_guard lock(mutex_);
    change();
    Advance();
  }

  // What every question of the engine says: about which mesh, by which
  // algorithm, until when and for whom. Errors: INVALID_ARGUMENT.
  template <typename Question>
  absl::Status BeginQuestion(Question& question) {
    question.mesh_digest = mesh_digest_;
    question.deadline = CallDeadline(context_);
    const absl::StatusOr<bool> is_batch = IsBatch(request().priority());
    if (!is_batch.ok()) return is_batch.status();
    question.requester = {.client = entry_->client(), .is_batch = *is_batch};
    const absl::StatusOr<Algorithm> algorithm =
        FromProto(request().algorithm());
    if (!algorithm.ok()) return algorithm.status();
    question.query.algorithm = *algorithm;
    return absl::OkStatus();
  }

  // This stream as its own class, to be handed to the engine.
  template <typename Stream>
  std::shared_ptr<Stream> Shared(Stream*) {
    return std::static_pointer_cast<Stream>(this->shared_from_this());
  }

  RequestLog::Entry& entry() { return *entry_; }
  // As Requester has it.
  std::string client() const { return entry_->client(); }
  QueryEngine& engine() { return service_.engine; }
  const v1::GetCapabilitiesResponse& capabilities() const {
    return service_.capabilities;
  }
  const std::string& version() const { return service_.version; }
  // For Ask.
  const Request& request() const { return *request_; }
  // For the end of an Ask that succeeds: what is no more needed may be changed.
  Request& request() { return *request_; }

 private:
  // `ok`: of the read. Errors: as Intake::Decode. REQUIRES: mutex_ held.
  absl::Status Receive(bool ok) {
    if (!ok) return absl::InvalidArgumentError("the call has no request");
    request_.emplace();
    absl::StatusOr<ByteReservation> memory =
        service_.intake.Decode(bytes_, *request_);
    bytes_.Clear();
    if (!memory.ok()) return memory.status();
    memory_ = *std::move(memory);
    mesh_digest_ = MeshDigestOf(*request_);
    if (!mesh_digest_.empty()) entry_->set_subject(DigestPrefix(mesh_digest_));
    return absl::OkStatus();
  }

  void OnLate() {
    std::lock_guard lock(mutex_);
    if (!request_.has_value() && !finished_) {
      End(LateError(service_.intake.patience()));
    }
  }

  void AwaitMesh() {
    std::string client;
    {
      std::lock_guard lock(mutex_);
      is_asking_ = false;
      if (cancelled_) {
        EndCancelled();
        return;
      }
      client = entry_->client();
    }
    absl::StatusOr<std::optional<MeshLoads::Ticket>> ticket =
        service_.engine.AwaitMesh(
            mesh_digest_,
            [self = this->shared_from_this()](
                const absl::StatusOr<MeshHandle>& mesh) { self->OnMesh(mesh); },
            client);
    {
      std::lock_guard lock(mutex_);
      if (!ticket.ok()) End(ticket.status());
      if (!ticket.ok() || !ticket->has_value()) return;
      if (!finished_) {
        ticket_ = **ticket;
        return;
      }
    }
    service_.engine.LeaveMesh(**ticket);
  }

  // `mesh` keeps it in memory until the engine has been asked.
  void OnMesh(const absl::StatusOr<MeshHandle>& mesh) {
    {
      std::lock_guard lock(mutex_);
      // After Finish the request may be gone.
      if (finished_) return;
      is_asking_ = true;
    }
    GoOn(mesh.ok() ? Ask() : mesh.status());
  }

  // `status`: of Ask.
  void GoOn(absl::Status status) {
    if (absl::IsNotFound(status) && !mesh_digest_.empty() &&
        service_.engine.CanLoadMesh(mesh_digest_)) {
      AwaitMesh();
      return;
    }
    bool cancel = false;
    {
      std::lock_guard lock(mutex_);
      is_asking_ = false;
      if (!status.ok()) {
        End(std::move(status));
        return;
      }
      request_.reset();  // it is of no more use
      Intake::ReleaseRequest(memory_);
      begun_ = true;
      cancel = cancelled_;
      if (cancelled_) EndCancelled();
      Advance();
    }
    if (cancel) Cancel();
  }

  // The rest REQUIRES: mutex_ held.

  void Advance() {
    if (!begun_ || writing_ || finished_) return;
    absl::StatusOr<NextMessage> next = Fill(message_);
    if (!next.ok()) {
      End(next.status());
    } else if (*next == NextMessage::kSend) {
      writing_ = true;
      write_begin_ = std::chrono::steady_clock::now();
      this->StartWrite(&message_);
    } else if (*next == NextMessage::kSendLast) {
      finished_ = true;
      this->StartWriteAndFinish(&message_, grpc::WriteOptions(),
                                entry_->End(absl::OkStatus()));
    }
  }

  void EndCancelled() {
    End(absl::CancelledError("the call was cancelled or its deadline came"));
  }

  void End(absl::Status status) {
    if (finished_) return;
    finished_ = true;
    arrival_.Stop();
    this->Finish(entry_->End(std::move(status)));
  }

  const ServiceContext& service_;
  grpc::CallbackServerContext& context_;

  std::mutex mutex_;
  // Guarded by mutex_:
  std::shared_ptr<AnswerStream> self_;  // what gRPC holds
  std::optional<RequestLog::Entry> entry_;
  Arrival arrival_;            // of the request
  bool is_receiving_ = false;  // a read is under way
  grpc::ByteBuffer bytes_;
  std::string mesh_digest_;                  // set by Receive, then constant
  ByteReservation memory_;                   // of the request and the question
  bool is_asking_ = false;                   // Ask runs, or is about to
  bool begun_ = false;                       // it succeeded
  std::optional<MeshLoads::Ticket> ticket_;  // while the mesh is being loaded
  bool cancelled_ = false;
  bool writing_ = false;   // a message is on its way
  TimePoint write_begin_;  // since when
  bool finished_ = false;  // Finish was called
  Response message_;

  // Set by Receive; Ask's while it runs:
  std::optional<Request> request_;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_CALLS_ANSWER_STREAM_H_
