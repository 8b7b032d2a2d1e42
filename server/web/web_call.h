// One call of a browser: the frames of its request go to a gRPC call in this
// process, and that call's messages come back as frames.
//
// The HTTP server has one thread for all connections, which must never wait.
// So a connection is suspended whenever its next step is gRPC's, and resumed by
// gRPC's thread. One message is held in either direction: the next is asked for
// when the browser has taken the last, and bytes of a request stay in the
// socket until the server has taken the message before.

#ifndef GEODESIC_SERVER_WEB_WEB_CALL_H_
#define GEODESIC_SERVER_WEB_WEB_CALL_H_

#include <grpcpp/client_context.h>
#include <grpcpp/support/byte_buffer.h>
#include <grpcpp/support/slice.h>
#include <grpcpp/support/status.h>
#include <sys/types.h>

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "absl/status/status.h"
#include "server/locks/mutex.h"
#include "server/rpc/calls/intake.h"
#include "server/web/call_queue.h"
#include "server/web/grpc_web.h"
#include "server/web/web_metadata.h"

struct MHD_Connection;

namespace geodesic::server {

class WebCall final : public Receiver,
                      public std::enable_shared_from_this<WebCall> {
 public:
  // What all calls of a door use. It outlives them.
  struct Context {
    CallQueue& queue;
    Intake& intake;
    uint64_t max_message_bytes;
  };

  // `address` is the browser's. REQUIRES: the connection lives until Leave.
  WebCall(const Context& door, MHD_Connection& connection, std::string address,
          WebEncoding encoding)
      : door_(door),
        connection_(connection),
        address_(std::move(address)),
        encoding_(encoding),
        reader_(encoding, door.max_message_bytes) {}

  WebEncoding encoding() const { return encoding_; }

  // For what is set before Start.
  grpc::ClientContext& context() { return context_; }

  // Begins the call of a method, e.g. "/geodesic.v1.MeshService/GetMesh". Call
  // once, on an object that a shared_ptr holds.
  void Start(const std::string& method);

  // The functions up to Leave are for the HTTP server's thread.

  // Takes bytes of the request's body; returns how many. The connection is
  // suspended until there is room for the others.
  size_t Receive(std::string_view body);

  // The body has come to its end. False if bytes that were taken wait for room;
  // the connection is then suspended until it is to be called again.
  bool EndBody();

  // Whether the answer may begin; suspends the connection until it may.
  // REQUIRES: EndBody().
  bool CanAnswer();

  // The answer's headers. REQUIRES: CanAnswer().
  HttpHeaders Headers() const;

  // Writes the next bytes of the answer; returns how many, as MHD wants to know
  // it: 0 with the connection suspended when there are none yet, or one of
  // MHD's codes for the end.
  ssize_t Read(char* out, size_t room);

  // Cancels the call, unless it has ended, and resumes the connection for the
  // last time; whoever reads it then gets an error. Thread-safe; may be called
  // again.
  void Leave();

  // Whether Leave was called. Thread-safe.
  bool has_left() const;

  // Messages of the request that have come so far. Thread-safe.
  uint64_t messages() const;

  // Of the intake: a large message may be received; others wait for that.
  void OnSlot() override;
  void OnBrokenOff() override;

  // REQUIRES: nothing of the call is under way at gRPC.
  ~WebCall();

 private:
  // Cuts `body` into messages and hands them on. Whether there was room for all
  // of it; `taken` is what there was room for.
  bool Take(std::string_view body, size_t& taken) ABSL_LOCKS_EXCLUDED(mutex_);

  // Whether the message whose length has come may be received now; if not, it
  // waits for a slot.
  bool MakeRoom() ABSL_LOCKS_EXCLUDED(mutex_);
  // Gives the slot back once no message is held.
  void ReturnSlot() ABSL_LOCKS_EXCLUDED(mutex_);

  // What gRPC has done.
  void OnStarted(bool ok);
  void OnRead(bool ok);
  void OnWritten(bool ok);
  void OnWritesEnded(bool ok);
  void OnFinished(bool ok);

  // Counts an operation that is handed to gRPC, and one that is done. The last
  // one lets go of self_, so whoever calls Done holds another reference.
  CallQueue::Event* Begin(CallQueue::Event& event)
      ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_);
  void Done() ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_);

  void Suspend() ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_);
  void Wake() ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_);
  // Hands on what came of the request, or drops it once an answer has come.
  void Forward() ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_);
  // Asks for the call's status. No other operation is begun after this.
  void Close() ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_);
  void ReadNext() ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_);
  void Fail(const absl::Status& status) ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_);
  // Moves the message that came, or the trailers, to outgoing_. False if there
  // is nothing to send yet.
  bool Refill() ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_);
  // What follows the status, in the same form whoever found the failure.
  HttpHeaders Trailers() const ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_);
  size_t CopyOut(char* out, size_t room) ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_);

  const Context& door_;
  MHD_Connection& connection_;
  const std::string address_;
  const WebEncoding encoding_;
  grpc::ClientContext context_;

  CallQueue::Event started_{[this](bool ok) { OnStarted(ok); }};
  CallQueue::Event read_{[this](bool ok) { OnRead(ok); }};
  CallQueue::Event written_{[this](bool ok) { OnWritten(ok); }};
  CallQueue::Event writes_ended_{[this](bool ok) { OnWritesEnded(ok); }};
  CallQueue::Event finished_{[this](bool ok) { OnFinished(ok); }};

  mutable Mutex mutex_;
  // Until gRPC is done.
  std::shared_ptr<WebCall> self_ ABSL_GUARDED_BY(mutex_);
  std::unique_ptr<grpc::GenericClientAsyncReaderWriter> stream_
      ABSL_GUARDED_BY(mutex_);
  int under_way_ ABSL_GUARDED_BY(mutex_) = 0;  // operations at gRPC
  bool is_suspended_ ABSL_GUARDED_BY(mutex_) = false;
  bool has_left_ ABSL_GUARDED_BY(mutex_) = false;
  bool is_closed_ ABSL_GUARDED_BY(mutex_) = false;

  FrameReader reader_ ABSL_GUARDED_BY(mutex_);
  uint64_t messages_ ABSL_GUARDED_BY(mutex_) = 0;
  bool waits_for_slot_ ABSL_GUARDED_BY(mutex_) = false;
  bool has_slot_ ABSL_GUARDED_BY(mutex_) = false;
  grpc::ByteBuffer request_ ABSL_GUARDED_BY(mutex_);  // while it is written
  bool is_writing_ ABSL_GUARDED_BY(mutex_) = true;    // or not started yet
  bool body_ended_ ABSL_GUARDED_BY(mutex_) = false;
  bool streams_requests_ ABSL_GUARDED_BY(mutex_) = false;
  bool ended_writes_ ABSL_GUARDED_BY(mutex_) = false;

  grpc::ByteBuffer response_ ABSL_GUARDED_BY(mutex_);
  bool is_reading_ ABSL_GUARDED_BY(mutex_) = true;
  bool has_response_ ABSL_GUARDED_BY(mutex_) = false;
  bool has_metadata_ ABSL_GUARDED_BY(mutex_) = false;
  std::deque<grpc::Slice> outgoing_ ABSL_GUARDED_BY(mutex_);
  size_t sent_ ABSL_GUARDED_BY(mutex_) = 0;  // of the first of them
  bool trailers_sent_ ABSL_GUARDED_BY(mutex_) = false;
  // Found here, not by the server.
  std::optional<grpc::Status> failure_ ABSL_GUARDED_BY(mutex_);
  grpc::Status status_ ABSL_GUARDED_BY(mutex_);       // the server's
  bool is_finished_ ABSL_GUARDED_BY(mutex_) = false;  // it has come
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_WEB_WEB_CALL_H_
