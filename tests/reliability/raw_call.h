// RPCs from serialized requests to serialized answers, many at once and without
// waiting: what a load is made of. Nothing is retried, so that a refusal is
// seen.

#ifndef GEODESIC_TESTS_RELIABILITY_RAW_CALL_H_
#define GEODESIC_TESTS_RELIABILITY_RAW_CALL_H_

#include <grpcpp/channel.h>
#include <grpcpp/client_context.h>
#include <grpcpp/generic/generic_stub.h>
#include <grpcpp/support/byte_buffer.h>
#include <grpcpp/support/client_callback.h>
#include <grpcpp/support/status.h>

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace geodesic::client {

struct RawRequest {
  std::string method;  // "/package.Service/Method"
  std::vector<std::string> messages;
  std::string token = {};  // if the server asks for one
};

struct RawAnswer {
  grpc::Status status;
  std::vector<std::string> messages;
  // When it was complete.
  std::chrono::steady_clock::time_point end;
};

grpc::ByteBuffer BufferOf(const std::string& bytes);
std::string BytesOf(const grpc::ByteBuffer& buffer);

enum class Window {
  kUsual,
  // Takes from the server hardly more than is read.
  kSmall,
};

// A channel of its own: calls on it share one connection, and with nobody else.
std::shared_ptr<grpc::Channel> OwnConnection(const std::string& address,
                                             Window window = Window::kUsual);

// A connection and the calls on it. Thread-safe.
class RawConnection {
 public:
  explicit RawConnection(const std::string& address);
  // Waits for every answer.
  ~RawConnection();
  RawConnection(const RawConnection&) = delete;
  RawConnection& operator=(const RawConnection&) = delete;

  // Returns at once; `done` hears of the end, on a thread of gRPC. It comes in
  // any case, within a minute.
  void Send(RawRequest request, std::function<void(RawAnswer)> done);

  // Waits until every call has ended and `done` of each has returned.
  void WaitIdle();

 private:
  class Exchange;

  grpc::GenericStub stub_;

  std::mutex mutex_;
  std::condition_variable idle_;
  uint64_t active_ = 0;  // guarded by mutex_
};

// An RPC that goes on only as far as it is told to: a reader that stalls, an
// upload that comes a byte at a time. On a connection of its own. Thread-safe,
// but for Finish.
class PacedCall final
    : public grpc::ClientBidiReactor<grpc::ByteBuffer, grpc::ByteBuffer> {
 public:
  // As many messages as it may write and read at first.
  PacedCall(const std::string& address, RawRequest request, size_t writes,
            size_t reads);
  // Cancels it if it has not ended.
  ~PacedCall() override;
  PacedCall(const PacedCall&) = delete;
  PacedCall& operator=(const PacedCall&) = delete;

  // Lets it write one more message.
  void AllowWrite();

  // Waits until it has written and read what it may, or cannot go on.
  void AwaitStall();

  // Lets it go on to its end, and waits for that. Call once.
  RawAnswer Finish();

  void OnWriteDone(bool ok) override;
  void OnReadDone(bool ok) override;
  void OnDone(const grpc::Status& status) override;

 private:
  // REQUIRES: mutex_ held.
  void Advance();
  void End();

  const RawRequest request_;
  const std::shared_ptr<grpc::Channel> channel_;
  grpc::GenericStub stub_;
  grpc::ClientContext context_;

  std::mutex mutex_;
  std::condition_variable changed_;
  // Guarded by mutex_:
  size_t may_write_;
  size_t may_read_;
  size_t written_ = 0;
  bool is_writing_ = false;
  bool is_reading_ = false;
  bool has_ended_ = false;  // of its stream
  bool is_held_ = true;     // gRPC waits for more to be started
  bool is_done_ = false;
  grpc::ByteBuffer outgoing_;
  grpc::ByteBuffer incoming_;
  RawAnswer answer_;
};

}  // namespace geodesic::client

#endif  // GEODESIC_TESTS_RELIABILITY_RAW_CALL_H_
