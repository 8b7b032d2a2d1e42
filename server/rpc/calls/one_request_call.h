// The base of every call with one request. It receives and decodes the request
// and sends the answer one message at a time; the next message is made when
// gRPC has taken the last one.
//
// The request is freed once the engine has been asked. A slow reader costs one
// message and what the answer pins. When the mesh is on disk but not in memory,
// the call waits for that and asks again.

#ifndef GEODESIC_SERVER_RPC_CALLS_ONE_REQUEST_CALL_H_
#define GEODESIC_SERVER_RPC_CALLS_ONE_REQUEST_CALL_H_

#include <grpcpp/server_context.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "server/engine/base/byte_budget.h"
#include "server/engine/base/status_details.h"
#include "server/engine/query_engine.h"
#include "server/rpc/calls/call.h"

namespace geodesic::server {

// What a call does next.
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

// A derived class asks the engine and makes the messages. Launch (service.h)
// starts it.
template <typename RequestType, typename ResponseType>
class OneRequestCall : public Call<ResponseType> {
 public:
  using Request = RequestType;
  using Response = ResponseType;

  // REQUIRES: as Call.
  OneRequestCall(const ServiceContext& service,
                 grpc::CallbackServerContext& context)
      : Base(service, MethodOf<Request>(), context) {}

  void OnWriteDone(bool ok) final {
    MutexLock lock(mutex_);
    writing_ = false;
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
      MutexLock lock(mutex_);
      cancelled_ = true;
      if (!is_asking_) this->EndCancelled();
      leave = std::exchange(leave_, nullptr);
      begun = begun_;
    }
    // Called without the lock, because the engine has its own.
    if (leave) leave();
    if (begun) Cancel();
  }

  void OnDone() override {
    {
      MutexLock lock(mutex_);
      request_.reset();
      memory_ = {};
    }
    Base::OnDone();
  }

 protected:
  using Base = Call<ResponseType>;
  using Base::finished_;
  using Base::mutex_;
  using Base::service_;

  // Asks the engine, which may call back at once. Called again once the mesh
  // has come from disk if it was not found before. The request and the context
  // stay valid until it returns, even if the client goes.
  virtual absl::Status Ask() ABSL_LOCKS_EXCLUDED(mutex_) = 0;

  // Called when Ask failed. Whether this call waits, by AskAfter, and then asks
  // again.
  virtual bool AwaitWhatIsMissing(const absl::Status&) { return false; }

  // Tells the engine that the caller waits no longer. Called at most once,
  // after Ask succeeded.
  virtual void Cancel() ABSL_LOCKS_EXCLUDED(mutex_) {}

  // Makes the next message. It still has what the last one had. An error ends
  // the call.
  virtual absl::StatusOr<NextMessage> Fill(Response& message)
      ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) = 0;

  // Sends the next message if it is ready; call when what Fill reads changes.
  void Advance() ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    if (!begun_ || writing_ || finished_) return;
    absl::StatusOr<NextMessage> next = Fill(message_);
    if (!next.ok()) {
      this->End(next.status());
    } else if (*next == NextMessage::kSend) {
      writing_ = true;
      this->Write(&message_);
    } else if (*next == NextMessage::kSendLast) {
      this->End(absl::OkStatus(), &message_);
    }
  }

  // Waits for what `start` begins, then asks again. `start` gets the caller and
  // a function to call at the end, with the status and whatever must be pinned
  // meanwhile, and returns what ends the wait; nothing if it has ended.
  template <typename Start>
  void AskAfter(Start start) {
    Requester caller;
    {
      MutexLock lock(mutex_);
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
      MutexLock lock(mutex_);
      if (!leave.ok()) this->End(leave.status());
      if (!leave.ok() || !*leave) return;
      if (!finished_) {
        leave_ = *std::move(leave);
        return;
      }
    }
    (*leave)();
  }

  RequestLog::Entry& entry() ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    return *entry_;
  }
  // The caller, for the engine. Before the call has ended.
  Requester requester(bool is_batch = false)
      ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    return {.client = entry_->client(),
            .is_batch = is_batch,
            .account = entry_->job()};
  }
  const std::string& version() const { return service_.capabilities.version(); }
  const std::string& mesh_digest() const { return mesh_digest_; }
  // For Ask. An Ask that is about to succeed may change it.
  Request& request() { return *request_; }

 private:
  using Base::entry_;

  void OnReceived(bool ok) final {
    {
      MutexLock lock(mutex_);
      if (finished_) return;
      if (absl::Status status = Receive(ok); !status.ok()) {
        this->End(std::move(status));
        return;
      }
      is_asking_ = true;
    }
    GoOn(Ask());
  }

  // `ok`: a message came. Errors: as Intake::Decode.
  absl::Status Receive(bool ok) ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
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

  void OnAwaited(absl::Status status) {
    {
      MutexLock lock(mutex_);
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
    if (!status.ok() && AwaitWhatIsMissing(status)) return;
    bool cancel = false;
    {
      MutexLock lock(mutex_);
      is_asking_ = false;
      if (!status.ok()) {
        this->End(std::move(status));
        return;
      }
      // It is of no more use.
      request_.reset();
      Intake::ReleaseRequest(memory_);
      begun_ = true;
      cancel = cancelled_;
      if (cancelled_) this->EndCancelled();
      Advance();
    }
    if (cancel) Cancel();
  }

  // Of the request and the question.
  ByteReservation memory_ ABSL_GUARDED_BY(mutex_);
  // Ask runs, or is about to.
  bool is_asking_ ABSL_GUARDED_BY(mutex_) = false;
  bool begun_ ABSL_GUARDED_BY(mutex_) = false;  // Ask succeeded
  // Ends a wait that AskAfter began.
  std::function<void()> leave_ ABSL_GUARDED_BY(mutex_);
  bool cancelled_ ABSL_GUARDED_BY(mutex_) = false;
  bool writing_ ABSL_GUARDED_BY(mutex_) = false;  // a message is on its way
  Response message_ ABSL_GUARDED_BY(mutex_);

  // Set by Receive, then constant:
  std::string mesh_digest_;
  // Set by Receive; Ask's, and of what follows it, while they run:
  std::optional<Request> request_;
  bool has_asked_tier_ = false;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_CALLS_ONE_REQUEST_CALL_H_
