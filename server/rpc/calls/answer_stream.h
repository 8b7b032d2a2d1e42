// The base of every call with one request. It receives and decodes the request
// and sends the answer one message at a time; the next message is made when
// gRPC has taken the last one.
//
// The request is freed once the engine has been asked. A slow reader costs one
// message and what the answer pins; newer progress replaces progress that was
// not sent. When the mesh is on disk but not in memory, the stream waits for it
// and asks again.

#ifndef GEODESIC_SERVER_RPC_CALLS_ANSWER_STREAM_H_
#define GEODESIC_SERVER_RPC_CALLS_ANSWER_STREAM_H_

#include <grpcpp/server_context.h>

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
#include "server/engine/base/status_details.h"
#include "server/engine/query_engine.h"
#include "server/rpc/calls/call.h"
#include "server/rpc/messages/translation.h"

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
    entry_->add_write_time(std::chrono::steady_clock::now() - write_begin_);
    if (!ok) {
      // The stream is broken; OnCancel tells the engine.
      this->End(absl::CancelledError("the client is gone"));
      return;
    }
    Advance();
  }

  void OnCancel() final {
    MeshLoads::Ticket ticket;
    bool begun = false;
    {
      std::lock_guard lock(mutex_);
      cancelled_ = true;
      if (!is_asking_) this->EndCancelled();
      ticket = std::exchange(ticket_, {});
      begun = begun_;
    }
    // Called without the lock, because the engine has its own.
    service_.engine.meshes().Leave(ticket);
    if (begun) Cancel();
  }

  void OnDone() final {
    {
      std::lock_guard lock(mutex_);
      request_.reset();
      memory_ = {};
    }
    Base::OnDone();
  }

 protected:
  using Call<ResponseType>::service_;

  // Asks the engine, which may call back at once. Called without the lock, and
  // again once the mesh has come from disk if it was not found before. The
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
  // algorithm of one that has a query. Errors: INVALID_ARGUMENT.
  template <typename Question>
  absl::Status BeginQuestion(Question& question) {
    question.mesh_digest = mesh_digest_;
    question.deadline = CallDeadline(context_);
    const absl::StatusOr<bool> is_batch = IsBatch(request().priority());
    if (!is_batch.ok()) return is_batch.status();
    question.requester = {.client = entry_->client(), .is_batch = *is_batch};
    if constexpr (requires { question.query; }) {
      const absl::StatusOr<Algorithm> algorithm =
          FromProto(request().algorithm());
      if (!algorithm.ok()) return algorithm.status();
      question.query.algorithm = *algorithm;
    }
    return absl::OkStatus();
  }

  RequestLog::Entry& entry() { return *entry_; }
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

  void AwaitMesh() {
    std::string client;
    {
      std::lock_guard lock(mutex_);
      is_asking_ = false;
      if (cancelled_) {
        this->EndCancelled();
        return;
      }
      client = entry_->client();
    }
    absl::StatusOr<MeshLoads::Ticket> ticket = service_.engine.meshes().Await(
        mesh_digest_,
        [self = this->Shared(this)](const absl::StatusOr<MeshHandle>& mesh) {
          self->OnMesh(mesh);
        },
        client);
    {
      std::lock_guard lock(mutex_);
      if (!ticket.ok()) this->End(ticket.status());
      if (!ticket.ok() || ticket->entry == nullptr) return;
      if (!finished_) {
        ticket_ = *ticket;
        return;
      }
    }
    service_.engine.meshes().Leave(*ticket);
  }

  // `mesh` pins the mesh until the engine has been asked.
  void OnMesh(const absl::StatusOr<MeshHandle>& mesh) {
    {
      std::lock_guard lock(mutex_);
      // After Finish the request may be gone.
      if (finished_) return;
      is_asking_ = true;
    }
    GoOn(mesh.ok() ? Ask() : mesh.status());
  }

  // `status` is the result of Ask.
  void GoOn(absl::Status status) {
    // Loading the mesh only helps if the mesh is what was not found.
    if (MeshAtFault(status).has_value() &&
        service_.engine.meshes().Contains(mesh_digest_)) {
      AwaitMesh();
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
      request_.reset();  // it is of no more use
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
      write_begin_ = std::chrono::steady_clock::now();
      this->StartWrite(&message_);
    } else if (*next == NextMessage::kSendLast) {
      this->End(absl::OkStatus(), &message_);
    }
  }

  // Guarded by mutex_:
  std::string mesh_digest_;   // set by Receive, then constant
  ByteReservation memory_;    // of the request and the question
  bool is_asking_ = false;    // Ask runs, or is about to
  bool begun_ = false;        // Ask succeeded
  MeshLoads::Ticket ticket_;  // while the mesh is being loaded
  bool cancelled_ = false;
  bool writing_ = false;   // a message is on its way
  TimePoint write_begin_;  // when it was started
  Response message_;

  // Set by Receive; Ask's while it runs:
  std::optional<Request> request_;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_CALLS_ANSWER_STREAM_H_
