#include "tests/reliability/raw_call.h"

#include <grpcpp/client_context.h>
#include <grpcpp/create_channel.h>
#include <grpcpp/security/credentials.h>
#include <grpcpp/support/channel_arguments.h>
#include <grpcpp/support/client_callback.h>

#include <cstddef>
#include <utility>

namespace geodesic::client {
namespace {

constexpr std::chrono::seconds kPatience{60};

}  // namespace

grpc::ByteBuffer BufferOf(const std::string& bytes) {
  const grpc::Slice slice(bytes);
  return {&slice, 1};
}

std::string BytesOf(const grpc::ByteBuffer& buffer) {
  std::vector<grpc::Slice> slices;
  buffer.Dump(&slices);
  std::string bytes;
  bytes.reserve(buffer.Length());
  for (const grpc::Slice& slice : slices) {
    bytes.append(reinterpret_cast<const char*>(slice.begin()), slice.size());
  }
  return bytes;
}

std::shared_ptr<grpc::Channel> OwnConnection(const std::string& address,
                                             Window window) {
  grpc::ChannelArguments arguments;
  arguments.SetInt(GRPC_ARG_USE_LOCAL_SUBCHANNEL_POOL, 1);
  arguments.SetInt(GRPC_ARG_ENABLE_RETRIES, 0);
  arguments.SetMaxReceiveMessageSize(-1);
  if (window == Window::kSmall) {
    arguments.SetInt(GRPC_ARG_HTTP2_BDP_PROBE, 0);
    arguments.SetInt(GRPC_ARG_HTTP2_STREAM_LOOKAHEAD_BYTES, 1024);
  }
  return grpc::CreateCustomChannel(address, grpc::InsecureChannelCredentials(),
                                   arguments);
}

// Writes all, reads all, and deletes itself. Reads and writes go on at the same
// time, each in turn, so no two reactions touch the same member.
class RawConnection::Exchange final
    : public grpc::ClientBidiReactor<grpc::ByteBuffer, grpc::ByteBuffer> {
 public:
  Exchange(RawConnection& connection, RawRequest request,
           std::function<void(RawAnswer)> done)
      : connection_(connection),
        request_(std::move(request)),
        done_(std::move(done)) {
    context_.set_deadline(std::chrono::system_clock::now() + kPatience);
  }

  void Start() {
    connection_.stub_.PrepareBidiStreamingCall(&context_, request_.method, {},
                                               this);
    Write();
    StartRead(&incoming_);
    StartCall();
  }

  void OnWriteDone(bool ok) override {
    if (ok && next_ < request_.messages.size()) Write();
  }

  void OnReadDone(bool ok) override {
    if (!ok) return;
    answer_.messages.push_back(BytesOf(incoming_));
    StartRead(&incoming_);
  }

  void OnDone(const grpc::Status& status) override {
    answer_.end = std::chrono::steady_clock::now();
    answer_.status = status;
    done_(std::move(answer_));
    RawConnection& connection = connection_;
    delete this;
    // Under the lock, so that who waits finds nobody in the connection.
    std::lock_guard lock(connection.mutex_);
    if (--connection.active_ == 0) connection.idle_.notify_all();
  }

 private:
  void Write() {
    outgoing_ = BufferOf(request_.messages[next_++]);
    if (next_ == request_.messages.size()) {
      StartWriteLast(&outgoing_, grpc::WriteOptions());
    } else {
      StartWrite(&outgoing_);
    }
  }

  RawConnection& connection_;
  grpc::ClientContext context_;
  const RawRequest request_;
  size_t next_ = 0;
  grpc::ByteBuffer outgoing_;
  grpc::ByteBuffer incoming_;
  RawAnswer answer_;
  const std::function<void(RawAnswer)> done_;
};

RawConnection::RawConnection(const std::string& address)
    : stub_(OwnConnection(address)) {}

RawConnection::~RawConnection() { WaitIdle(); }

void RawConnection::Send(RawRequest request,
                         std::function<void(RawAnswer)> done) {
  {
    std::lock_guard lock(mutex_);
    ++active_;
  }
  (new Exchange(*this, std::move(request), std::move(done)))->Start();
}

void RawConnection::WaitIdle() {
  std::unique_lock lock(mutex_);
  idle_.wait(lock, [this] { return active_ == 0; });
}

}  // namespace geodesic::client
