// The base of every call. It admits the call, receives its messages one after
// the other, ends it once and logs it.
//
// A caller without the right, or beyond a quota, is refused before anything of
// the request is received; one who takes nothing of the answer is cut off. gRPC
// and the engine call from different threads, so everything happens under one
// lock. gRPC holds the object until OnDone, the engine as long as it may call;
// the last one destroys it.

#ifndef GEODESIC_SERVER_RPC_CALLS_CALL_H_
#define GEODESIC_SERVER_RPC_CALLS_CALL_H_

#include <google/protobuf/message.h>
#include <grpcpp/alarm.h>
#include <grpcpp/server_context.h>
#include <grpcpp/support/byte_buffer.h>
#include <grpcpp/support/server_callback.h>

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "absl/strings/str_cat.h"
#include "geodesic/v1/capabilities_service.pb.h"
#include "server/engine/base/byte_budget.h"
#include "server/engine/query_engine.h"
#include "server/locks/mutex.h"
#include "server/rpc/calls/intake.h"
#include "server/rpc/calls/peer.h"
#include "server/rpc/calls/request_log.h"

namespace geodesic::server {

// The objects that all calls of a server use. They outlive all calls.
struct ServiceContext {
  QueryEngine& engine;
  RequestLog& log;
  Intake& intake;
  const Peers& peers;
  v1::GetCapabilitiesResponse capabilities;
  // How long a client may take nothing of its answer.
  std::chrono::milliseconds send_patience;
};

// Why a read may fail. gRPC itself refuses a message that is too large and
// tells the client so; to the server this looks as if the client had left.
inline constexpr char kNoMessage[] =
    "no message came: the client sent none, is gone, or sent one larger than "
    "max_message_bytes, which gRPC refused";

// The error of a call whose client took nothing of the answer.
inline absl::Status NotTakenError(std::chrono::milliseconds patience) {
  return absl::DeadlineExceededError(absl::StrCat(
      "the client took nothing of the answer for ", patience.count() / 1000,
      " s (the server's limit send-seconds)"));
}

// A client whose deadline comes cancels its call, and the server may hear of
// that first: gRPC rounds deadlines up on the wire, and the call took some time
// to come. What is cancelled so near to its deadline, by parts of the time that
// it had and in all, had no more time.
inline constexpr int kNearDeadline = 50;
inline constexpr std::chrono::milliseconds kOnTheWay{100};

template <typename ResponseType>
class Call : public grpc::ServerBidiReactor<grpc::ByteBuffer, ResponseType>,
             public Receiver,
             public std::enable_shared_from_this<Call<ResponseType>> {
 public:
  using Response = ResponseType;

  // `method` is its name in the log. REQUIRES: `service` outlives the call;
  // `context` lives until gRPC is done with it.
  Call(const ServiceContext& service, std::string_view method,
       grpc::CallbackServerContext& context)
      : service_(service), context_(context), peer_(service.peers.Of(context)) {
    entry_.emplace(service.log, method, context, peer_);
  }

  // Begins the call. `self` is this; it is held until gRPC is done with it.
  void Launch(std::shared_ptr<Call> self) {
    {
      MutexLock lock(mutex_);
      self_ = std::move(self);
      if (absl::Status status = Admit(*entry_); !status.ok()) {
        End(std::move(status));
        return;
      }
    }
    ReceiveNext();
  }

  void OnSlot() final {
    {
      MutexLock lock(mutex_);
      if (!finished_) {
        is_receiving_ = true;
        this->StartRead(&bytes_);
        return;
      }
    }
    LeaveIntake();
  }

  void OnBrokenOff() final {
    MutexLock lock(mutex_);
    if (!is_receiving_) return;
    if (!finished_) {
      End(BrokenOffError());
    } else {
      // The call has ended, but its client does not take the answer.
      context_.TryCancel();
    }
  }

  void OnReadDone(bool ok) final {
    {
      MutexLock lock(mutex_);
      is_receiving_ = false;
      arrival_.reset();
      ++reads_;
    }
    LeaveIntake();
    OnReceived(ok);
  }

  void OnDone() override {
    std::shared_ptr<Call> self;
    std::optional<grpc::Alarm> watch;
    MutexLock lock(mutex_);
    entry_.reset();
    bytes_.Clear();
    // The lock is released before these: `self` may be the last reference, and
    // the end of an alarm may wait for OnTakingWatch.
    watch = std::exchange(taking_watch_, std::nullopt);
    self = std::move(self_);
  }

 protected:
  // Whether the caller may ask. Errors: as RequestLog::Entry.
  virtual absl::Status Admit(RequestLog::Entry& entry) {
    return entry.AdmitStream();
  }

  // Called when a message has come. If not `ok`, none will come: the client has
  // sent everything or is gone.
  virtual void OnReceived(bool ok) ABSL_LOCKS_EXCLUDED(mutex_) = 0;

  // Waits for a message.
  void ReceiveNext() ABSL_LOCKS_EXCLUDED(mutex_) {
    std::shared_ptr<Call> self;
    {
      MutexLock lock(mutex_);
      if (finished_) return;
      self = self_;
      arrival_.emplace();
      arrival_->Set(
          std::chrono::system_clock::now() + service_.intake.patience(),
          [self, read = reads_](bool has_passed) {
            if (has_passed) self->OnLate(read);
          });
    }
    // The door for browsers enters itself, since a message is received there.
    if (peer_.by_door) {
      OnSlot();
    } else {
      service_.intake.Enter(std::move(self), peer_.address);
    }
  }

  // A reference to this call, for callbacks of the engine.
  template <typename Type>
  std::shared_ptr<Type> Shared(Type*) {
    return std::static_pointer_cast<Type>(this->shared_from_this());
  }

  QueryEngine& engine() { return service_.engine; }

  // Decodes the message and frees its bytes. Errors: as Intake::Decode.
  absl::StatusOr<ByteReservation> Decode(google::protobuf::Message& message)
      ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    absl::StatusOr<ByteReservation> memory =
        service_.intake.Decode(bytes_, message);
    bytes_.Clear();
    return memory;
  }

  // Sends a message; OnWriteDone says when gRPC has taken it.
  void Write(const Response* message) ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    AwaitTaking();
    this->StartWrite(message);
  }

  // What Write sent is taken.
  void OnTaken() ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    entry_->add_write_time(Clock::now() - taking_since_);
    is_taking_ = false;
  }

  // Ends the call unless it has ended. If OK, sends this last message first.
  void End(absl::Status status, const Response* message = nullptr)
      ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    if (finished_) return;
    finished_ = true;
    arrival_.reset();
    AwaitTaking();
    grpc::Status end = entry_->End(std::move(status));
    if (message != nullptr) {
      this->StartWriteAndFinish(message, grpc::WriteOptions(), std::move(end));
    } else {
      this->Finish(std::move(end));
    }
  }

  void EndCancelled() ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    const auto deadline = context_.deadline();
    const auto near = (deadline - begin_) / kNearDeadline + kOnTheWay;
    if (deadline - std::chrono::system_clock::now() <= near) {
      End(absl::DeadlineExceededError("the call's deadline came"));
    } else {
      End(absl::CancelledError(is_receiving_ ? kNoMessage
                                             : "the call was cancelled"));
    }
  }

  const ServiceContext& service_;
  grpc::CallbackServerContext& context_;

  Mutex mutex_;
  // Until gRPC is done.
  std::optional<RequestLog::Entry> entry_ ABSL_GUARDED_BY(mutex_);
  bool finished_ ABSL_GUARDED_BY(mutex_) = false;  // Finish was called

 private:
  using Clock = std::chrono::steady_clock;

  void LeaveIntake() {
    if (!peer_.by_door) service_.intake.Leave(*this);
  }

  // From now on something waits to be taken.
  void AwaitTaking() ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    if (!is_taking_) taking_since_ = Clock::now();
    is_taking_ = true;
    if (!taking_watch_.has_value()) WatchTaking(service_.send_patience);
  }

  // One alarm for all messages of a call: most are taken at once.
  void WatchTaking(Clock::duration patience)
      ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    taking_watch_.emplace();
    taking_watch_->Set(std::chrono::system_clock::now() + patience,
                       [self = self_](bool has_passed) {
                         if (has_passed) self->OnTakingWatch();
                       });
  }

  void OnTakingWatch() {
    MutexLock lock(mutex_);
    if (self_ == nullptr) return;
    if (!is_taking_) {
      taking_watch_.reset();
      return;
    }
    const auto left = taking_since_ + service_.send_patience - Clock::now();
    if (left > Clock::duration(0)) {
      WatchTaking(left);
      return;
    }
    const absl::Status status = NotTakenError(service_.send_patience);
    End(status);
    entry_->set_status(status);
    // What was written stays before the end of the call, and is not taken.
    context_.TryCancel();
  }

  void OnLate(uint64_t read) {
    MutexLock lock(mutex_);
    // The message may have come in the meantime.
    if (reads_ == read) End(LateError(service_.intake.patience()));
  }

  const Peer peer_;
  const std::chrono::system_clock::time_point begin_ =
      std::chrono::system_clock::now();

  // What gRPC holds.
  std::shared_ptr<Call> self_ ABSL_GUARDED_BY(mutex_);
  // Of the message that is waited for.
  std::optional<grpc::Alarm> arrival_ ABSL_GUARDED_BY(mutex_);
  uint64_t reads_ ABSL_GUARDED_BY(mutex_) = 0;  // that are done
  // Something was sent that is not taken yet.
  bool is_taking_ ABSL_GUARDED_BY(mutex_) = false;
  Clock::time_point taking_since_ ABSL_GUARDED_BY(mutex_);
  std::optional<grpc::Alarm> taking_watch_ ABSL_GUARDED_BY(mutex_);
  bool is_receiving_ ABSL_GUARDED_BY(mutex_) = false;  // a read is under way
  grpc::ByteBuffer bytes_ ABSL_GUARDED_BY(mutex_);
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_CALLS_CALL_H_
