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
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace geodesic::server::test {

// What happens next, in order.
using Events = std::deque<std::function<void()>>;

inline void Require(bool promise) {
  if (!promise) std::abort();
}

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

// A server stream. `take` gets each message.
template <typename Request, typename Response>
class FakeStream final : public FakeCall,
                         private grpc::ServerCallbackWriter<Response> {
 public:
  using Take = std::function<void(const Response&)>;

  template <typename Method>
  FakeStream(Events& events, Request request, Take take, Method method)
      : events_(events), request_(std::move(request)), take_(std::move(take)) {
    reactor_ = method(&context_, &request_);
    this->BindReactor(reactor_);
  }

  void Cancel() override {
    was_cancelled_ = true;
    reactor_->OnCancel();
  }
  bool is_over() const override { return is_over_; }

 private:
  void SendInitialMetadata() override { std::abort(); }

  void Write(const Response* message, grpc::WriteOptions) override {
    Require(!is_writing_ && !status_.has_value());
    is_writing_ = true;
    take_(*message);
    events_.emplace_back([this] {
      is_writing_ = false;
      reactor_->OnWriteDone(!was_cancelled_);
    });
  }

  void WriteAndFinish(const Response* message, grpc::WriteOptions,
                      grpc::Status status) override {
    Require(!is_writing_);
    take_(*message);
    Finish(std::move(status));
  }

  void Finish(grpc::Status status) override {
    Require(!status_.has_value());
    status_ = std::move(status);
    End();
  }

  // OnDone comes after the reaction to a write that is under way.
  void End() {
    events_.emplace_back([this] {
      if (is_writing_) {
        End();
        return;
      }
      is_over_ = true;
      reactor_->OnDone();
    });
  }

  grpc::internal::ServerReactor* reactor() override { return reactor_; }
  void CallOnDone() override { std::abort(); }

  Events& events_;
  const Request request_;
  const Take take_;
  grpc::CallbackServerContext context_;
  grpc::ServerWriteReactor<Response>* reactor_ = nullptr;
  bool is_writing_ = false;
  bool is_over_ = false;
};

// A client stream of these requests.
template <typename Request, typename Response>
class FakeUpload final : public FakeCall,
                         private grpc::ServerCallbackReader<Request> {
 public:
  template <typename Method>
  FakeUpload(Events& events, std::vector<Request> requests, Method method)
      : events_(events), requests_(std::move(requests)) {
    reactor_ = method(&context_, &response_);
    this->BindReactor(reactor_);
  }

  void Cancel() override {
    was_cancelled_ = true;
    reactor_->OnCancel();
  }
  bool is_over() const override { return is_over_; }

 private:
  void SendInitialMetadata() override { std::abort(); }

  void Read(Request* message) override {
    Require(!is_reading_);
    is_reading_ = true;
    events_.emplace_back([this, message] {
      is_reading_ = false;
      const bool ok =
          next_ < requests_.size() && !was_cancelled_ && !status_.has_value();
      if (ok) *message = requests_[next_++];
      reactor_->OnReadDone(ok);
    });
  }

  void Finish(grpc::Status status) override {
    Require(!status_.has_value());
    status_ = std::move(status);
    End();
  }

  void End() {
    events_.emplace_back([this] {
      if (is_reading_) {
        End();
        return;
      }
      is_over_ = true;
      reactor_->OnDone();
    });
  }

  grpc::internal::ServerReactor* reactor() override { return reactor_; }
  void CallOnDone() override { std::abort(); }

  Events& events_;
  const std::vector<Request> requests_;
  size_t next_ = 0;
  Response response_;
  grpc::CallbackServerContext context_;
  grpc::ServerReadReactor<Request>* reactor_ = nullptr;
  bool is_reading_ = false;
  bool is_over_ = false;
};

}  // namespace geodesic::server::test

#endif  // GEODESIC_TESTS_FUZZ_RPC_FAKE_CALL_H_
