// gRPC's side of a call, without gRPC: hands a reaction what it asked for, in
// an order that repeats, and checks that the rules of the callback API are
// kept.

#ifndef GEODESIC_TESTS_FUZZ_RPC_FAKE_CALL_H_
#define GEODESIC_TESTS_FUZZ_RPC_FAKE_CALL_H_

#include <grpcpp/server_context.h>
#include <grpcpp/support/byte_buffer.h>
#include <grpcpp/support/server_callback.h>
#include <grpcpp/support/slice.h>

#include <cstddef>
#include <cstdlib>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "server/rpc/calls/service.h"

namespace geodesic::server::test {

// Aborts the program unless it holds: a fuzzer takes that for a crash.
inline void Require(bool holds) {
  if (!holds) std::abort();
}

// What happens next, in order.
using Events = std::deque<std::function<void()>>;

// A call that was begun. It is over when it is answered and nothing of it is
// among the events.
class FakeCall {
 public:
  virtual ~FakeCall() = default;

  // The client goes. REQUIRES: called once at most, and not after is_over.
  virtual void Cancel() = 0;

  virtual bool is_over() const = 0;
  bool was_cancelled() const { return was_cancelled_; }
  // REQUIRES: is_over.
  const grpc::Status& status() const { return *status_; }

 protected:
  bool was_cancelled_ = false;
  std::optional<grpc::Status> status_;
};

// A call of Type with these messages from the client, an operation at a time.
// `take` gets each message of the answer.
template <typename Type>
class FakeCallOf final
    : public FakeCall,
      private grpc::ServerCallbackReaderWriter<grpc::ByteBuffer,
                                               typename Type::Response> {
 public:
  using Response = typename Type::Response;
  using Take = std::function<void(const Response&)>;

  FakeCallOf(Events& events, const ServiceContext& service,
             std::vector<std::string> messages, Take take)
      : events_(events),
        messages_(std::move(messages)),
        take_(std::move(take)),
        reactor_(Launch<Type>(service, context_)) {
    this->BindReactor(reactor_);
  }

  void Cancel() override {
    was_cancelled_ = true;
    reactor_->OnCancel();
  }
  bool is_over() const override { return is_over_; }

 private:
  using Reactor = grpc::ServerBidiReactor<grpc::ByteBuffer, Response>;

  void Read(grpc::ByteBuffer* bytes) override {
    bytes->Clear();  // they are gRPC's from now on
    BeginOperation([this, bytes] {
      const bool ok =
          next_ < messages_.size() && !was_cancelled_ && !status_.has_value();
      if (ok) {
        const grpc::Slice slice(messages_[next_++]);
        *bytes = grpc::ByteBuffer(&slice, 1);
      }
      reactor_->OnReadDone(ok);
    });
  }

  void Write(const Response* message, grpc::WriteOptions) override {
    Require(!status_.has_value());
    take_(*message);
    BeginOperation([this] { reactor_->OnWriteDone(!was_cancelled_); });
  }

  void WriteAndFinish(const Response* message, grpc::WriteOptions,
                      grpc::Status status) override {
    Require(!is_busy_);
    take_(*message);
    Finish(std::move(status));
  }

  void Finish(grpc::Status status) override {
    Require(!status_.has_value());
    status_ = std::move(status);
    End();
  }

  // A read or a write begins; `end` tells the reactor of its end.
  void BeginOperation(std::function<void()> end) {
    Require(!is_busy_);
    is_busy_ = true;
    events_.emplace_back([this, end = std::move(end)] {
      is_busy_ = false;
      end();
    });
  }

  // OnDone comes after the end of the operation that is under way.
  void End() {
    events_.emplace_back([this] {
      if (is_busy_) {
        End();
        return;
      }
      is_over_ = true;
      reactor_->OnDone();
    });
  }

  void SendInitialMetadata() override { std::abort(); }
  void CallOnDone() override { std::abort(); }
  grpc::internal::ServerReactor* reactor() override { return reactor_; }

  Events& events_;
  const std::vector<std::string> messages_;
  size_t next_ = 0;
  const Take take_;
  grpc::CallbackServerContext context_;
  bool is_busy_ = false;
  bool is_over_ = false;
  Reactor* const reactor_;
};

}  // namespace geodesic::server::test

#endif  // GEODESIC_TESTS_FUZZ_RPC_FAKE_CALL_H_
