// What every streamed answer shares: one message at a time to the client, the
// next made when gRPC has taken that one.
//
// So a slow reader costs one message and what the answer pins, and what nobody
// took is overwritten by newer. Reactions and the engine's calls come from
// different threads, so everything happens under one lock. Two parties hold the
// object, gRPC until OnDone and the engine as long as it may call; the last to
// let go destroys it.
//
// When the mesh is on disk and not in memory, the stream waits for it and asks
// again.

#ifndef GEODESIC_SERVER_RPC_ANSWER_STREAM_H_
#define GEODESIC_SERVER_RPC_ANSWER_STREAM_H_

#include <grpcpp/server_context.h>
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
#include "server/engine/clock.h"
#include "server/engine/query_engine.h"
#include "server/rpc/field_translation.h"
#include "server/rpc/request_log.h"

namespace geodesic::server {

// What a stream does next.
enum class NextMessage {
  kWait,  // there is nothing to send yet
  kSend,
  kSendLast,
};

// A derived class says what is asked of the engine and what the messages are;
// Launch starts it.
template <typename Response>
class AnswerStream
    : public grpc::ServerWriteReactor<Response>,
      public std::enable_shared_from_this<AnswerStream<Response>> {
 public:
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
    std::optional<MeshLoads::Seat> seat;
    bool begun = false;
    {
      std::lock_guard lock(mutex_);
      cancelled_ = true;
      if (!asking_) EndCancelled();
      seat = std::exchange(seat_, {});
      begun = begun_;
    }
    // Without the lock, for the engine has its own.
    if (seat) engine_.LeaveMesh(*seat);
    if (begun) Cancel();
  }

  void OnDone() final {
    std::shared_ptr<AnswerStream> self;
    std::lock_guard lock(mutex_);
    entry_.reset();
    // The lock is released before `self`, which may be the last to hold it.
    self = std::move(self_);
  }

 protected:
  // REQUIRES: `engine` and `log` outlive the call; `context` lives until gRPC
  // is done with it.
  AnswerStream(QueryEngine& engine, RequestLog& log, std::string_view method,
               const std::string& mesh_digest,
               grpc::CallbackServerContext& context)
      : engine_(engine), mesh_digest_(mesh_digest) {
    entry_.emplace(log, method, context);
    entry_->set_subject(DigestPrefix(mesh_digest));
  }

  // Asks the engine, which may call back at once; called without the lock, and
  // once more after it failed with NOT_FOUND and the mesh came from the disk.
  // The request is there while it is called, though the client be gone.
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

  RequestLog::Entry& entry() { return *entry_; }

  // For what Ask asks. Errors: INVALID_ARGUMENT.
  absl::StatusOr<Requester> MakeRequester(v1::Priority priority) {
    const absl::StatusOr<bool> is_batch = IsBatch(priority);
    if (!is_batch.ok()) return is_batch.status();
    return Requester{.client = entry_->client(), .is_batch = *is_batch};
  }

  QueryEngine& engine() { return engine_; }

  // Starts `stream`, which keeps itself alive until gRPC is done with it.
  template <typename Stream>
  static Stream* Launch(std::shared_ptr<Stream> stream) {
    stream->self_ = stream;
    stream->Begin();
    return stream.get();
  }

 private:
  void Begin() {
    absl::Status status = entry_->AdmitStream();
    if (status.ok()) status = Ask();
    if (absl::IsNotFound(status) && engine_.CanLoadMesh(mesh_digest_)) {
      AwaitMesh();
    } else {
      GoOn(std::move(status));
    }
  }

  void AwaitMesh() {
    std::string client;
    {
      std::lock_guard lock(mutex_);
      asking_ = false;
      if (cancelled_) {
        EndCancelled();
        return;
      }
      client = entry_->client();
    }
    absl::StatusOr<std::optional<MeshLoads::Seat>> seat = engine_.AwaitMesh(
        mesh_digest_,
        [self = this->shared_from_this()](
            const absl::StatusOr<MeshHandle>& mesh) { self->OnMesh(mesh); },
        client);
    {
      std::lock_guard lock(mutex_);
      if (!seat.ok()) End(seat.status());
      if (!seat.ok() || !seat->has_value()) return;
      if (!finished_) {
        seat_ = **seat;
        return;
      }
    }
    engine_.LeaveMesh(**seat);
  }

  // `mesh` keeps it in memory until the engine has been asked.
  void OnMesh(const absl::StatusOr<MeshHandle>& mesh) {
    {
      std::lock_guard lock(mutex_);
      // After Finish the request may be gone.
      if (finished_) return;
      asking_ = true;
    }
    GoOn(mesh.ok() ? Ask() : mesh.status());
  }

  // `status`: of Ask.
  void GoOn(absl::Status status) {
    bool cancel = false;
    {
      std::lock_guard lock(mutex_);
      asking_ = false;
      if (!status.ok()) {
        End(std::move(status));
        return;
      }
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
    this->Finish(entry_->End(std::move(status)));
  }

  QueryEngine& engine_;
  const std::string mesh_digest_;

  std::mutex mutex_;
  // Guarded by mutex_:
  std::shared_ptr<AnswerStream> self_;  // what gRPC holds
  std::optional<RequestLog::Entry> entry_;
  bool asking_ = true;                   // Ask runs, or is about to
  bool begun_ = false;                   // it succeeded
  std::optional<MeshLoads::Seat> seat_;  // while the mesh is being loaded
  bool cancelled_ = false;
  bool writing_ = false;   // a message is on its way
  TimePoint write_begin_;  // since when
  bool finished_ = false;  // Finish was called
  Response message_;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_ANSWER_STREAM_H_
