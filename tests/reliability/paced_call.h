// An RPC that goes on only as far as it is told to: a reader that stalls, an
// upload that comes a byte at a time.

#ifndef GEODESIC_TESTS_RELIABILITY_PACED_CALL_H_
#define GEODESIC_TESTS_RELIABILITY_PACED_CALL_H_

#include <grpcpp/channel.h>
#include <grpcpp/client_context.h>
#include <grpcpp/generic/generic_stub.h>
#include <grpcpp/support/byte_buffer.h>
#include <grpcpp/support/client_callback.h>

#include <condition_variable>
#include <cstddef>
#include <memory>
#include <mutex>
#include <string>

#include "tests/reliability/raw_call.h"

namespace geodesic::client {

// On a connection of its own. Thread-safe, but for Finish.
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

#endif  // GEODESIC_TESTS_RELIABILITY_PACED_CALL_H_
