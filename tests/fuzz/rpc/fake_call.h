// gRPC's side of a call, without gRPC: hands a reaction what it asked for, in
// an order that repeats, and checks that the rules of the callback API are
// kept.

#ifndef GEODESIC_TESTS_FUZZ_RPC_FAKE_CALL_H_
#define GEODESIC_TESTS_FUZZ_RPC_FAKE_CALL_H_

#include <grpcpp/server_context.h>
#include <grpcpp/support/server_callback.h>
#include <grpcpp/test/default_reactor_test_peer.h>

#include <cstddef>
#include <cstdlib>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tests/fuzz/rpc/require.h"

namespace geodesic::server::test {

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

template <typename Request, typename Response>
class FakeUnary final : public FakeCall {
 public:
  template <typename Method>
  FakeUnary(Request request, Method method) : request_(std::move(request)) {
    method(&context_, &request_, &response_);
  }

  // DefaultReactor has no reaction to it.
  void Cancel() override { was_cancelled_ = true; }
  bool is_over() const override { return status_.has_value(); }

 private:
  const Request request_;
  Response response_;
  grpc::CallbackServerContext context_;
  grpc::testing::DefaultReactorTestPeer peer_{
      &context_, [this](const grpc::Status& status) {
        Require(!status_.has_value());
        status_ = status;
      }};
};

// A stream in either direction, an operation at a time: Call is gRPC's side of
// it, which Reactor asks.
template <typename Call, typename Reactor>
class FakeStreamCall : public FakeCall, protected Call {
 public:
  void Cancel() final {
    was_cancelled_ = true;
    reactor_->OnCancel();
  }
  bool is_over() const final { return is_over_; }

 protected:
  explicit FakeStreamCall(Events& events) : events_(events) {}

  // To be called once, with what the service's method returned.
  void Bind(Reactor* reactor) {
    reactor_ = reactor;
    this->BindReactor(reactor);
  }

  Reactor& reactions() { return *reactor_; }
  bool is_busy() const { return is_busy_; }

  // A read or a write begins; `end` tells the reactor of its end.
  void BeginOperation(std::function<void()> end) {
    Require(!is_busy_);
    is_busy_ = true;
    events_.emplace_back([this, end = std::move(end)] {
      is_busy_ = false;
      end();
    });
  }

  void Finish(grpc::Status status) final {
    Require(!status_.has_value());
    status_ = std::move(status);
    End();
  }

 private:
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

  void SendInitialMetadata() final { std::abort(); }
  void CallOnDone() final { std::abort(); }
  grpc::internal::ServerReactor* reactor() final { return reactor_; }

  Events& events_;
  Reactor* reactor_ = nullptr;
  bool is_busy_ = false;
  bool is_over_ = false;
};

// A server stream. `take` gets each message.
template <typename Request, typename Response>
class FakeDownload final
    : public FakeStreamCall<grpc::ServerCallbackWriter<Response>,
                            grpc::ServerWriteReactor<Response>> {
 public:
  using Take = std::function<void(const Response&)>;

  template <typename Method>
  FakeDownload(Events& events, Request request, Take take, Method method)
      : FakeDownload::FakeStreamCall(events),
        request_(std::move(request)),
        take_(std::move(take)) {
    this->Bind(method(&context_, &request_));
  }

 private:
  void Write(const Response* message, grpc::WriteOptions) override {
    Require(!this->status_.has_value());
    take_(*message);
    this->BeginOperation(
        [this] { this->reactions().OnWriteDone(!this->was_cancelled_); });
  }

  void WriteAndFinish(const Response* message, grpc::WriteOptions,
                      grpc::Status status) override {
    Require(!this->is_busy());
    take_(*message);
    this->Finish(std::move(status));
  }

  const Request request_;
  const Take take_;
  grpc::CallbackServerContext context_;
};

// A client stream of these requests.
template <typename Request, typename Response>
class FakeUpload final
    : public FakeStreamCall<grpc::ServerCallbackReader<Request>,
                            grpc::ServerReadReactor<Request>> {
 public:
  template <typename Method>
  FakeUpload(Events& events, std::vector<Request> requests, Method method)
      : FakeUpload::FakeStreamCall(events), requests_(std::move(requests)) {
    this->Bind(method(&context_, &response_));
  }

 private:
  void Read(Request* message) override {
    message->Clear();  // it is gRPC's from now on
    this->BeginOperation([this, message] {
      const bool ok = next_ < requests_.size() && !this->was_cancelled_ &&
                      !this->status_.has_value();
      if (ok) *message = requests_[next_++];
      this->reactions().OnReadDone(ok);
    });
  }

  const std::vector<Request> requests_;
  size_t next_ = 0;
  Response response_;
  grpc::CallbackServerContext context_;
};

}  // namespace geodesic::server::test

#endif  // GEODESIC_TESTS_FUZZ_RPC_FAKE_CALL_H_
