#include "tests/reliability/raw_call.h"

#include <grpcpp/create_channel.h>
#include <grpcpp/security/credentials.h>
#include <grpcpp/support/channel_arguments.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace geodesic::client {
namespace {

constexpr std::chrono::seconds kPatience{60};

void ShowToken(const RawRequest& request, grpc::ClientContext& context) {
  if (request.token.empty()) return;
  context.AddMetadata("authorization", "Bearer " + request.token);
}

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
    ShowToken(request_, context_);
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

PacedCall::PacedCall(const std::string& address, RawRequest request,
                     size_t writes, size_t reads)
    : request_(std::move(request)),
      channel_(OwnConnection(address, Window::kSmall)),
      stub_(channel_),
      may_write_(std::min(writes, request_.messages.size())),
      may_read_(reads) {
  ShowToken(request_, context_);
  stub_.PrepareBidiStreamingCall(&context_, request_.method, {}, this);
  // Reads and writes are started from outside of reactions.
  AddHold();
  std::lock_guard lock(mutex_);
  Advance();
  StartCall();
}

PacedCall::~PacedCall() {
  context_.TryCancel();
  std::unique_lock lock(mutex_);
  End();
  changed_.wait(lock, [this] { return is_done_; });
}

void PacedCall::AllowWrite() {
  std::lock_guard lock(mutex_);
  may_write_ = std::min(may_write_ + 1, request_.messages.size());
  Advance();
}

void PacedCall::AwaitStall() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] {
    return has_ended_ || (!is_writing_ && written_ == may_write_ &&
                          answer_.messages.size() == may_read_);
  });
}

RawAnswer PacedCall::Finish() {
  std::unique_lock lock(mutex_);
  may_write_ = request_.messages.size();
  may_read_ = std::numeric_limits<size_t>::max();
  Advance();
  changed_.wait(lock, [this] { return is_done_; });
  return std::move(answer_);
}

void PacedCall::OnWriteDone(bool ok) {
  std::lock_guard lock(mutex_);
  is_writing_ = false;
  // A stream that has ended takes no more; what it says is read.
  if (!ok) may_write_ = written_;
  Advance();
}

void PacedCall::OnReadDone(bool ok) {
  std::lock_guard lock(mutex_);
  is_reading_ = false;
  if (ok) {
    answer_.messages.push_back(BytesOf(incoming_));
  } else {
    has_ended_ = true;
  }
  Advance();
}

void PacedCall::OnDone(const grpc::Status& status) {
  // Under the lock, so that who waits finds nobody in the call.
  std::lock_guard lock(mutex_);
  answer_.status = status;
  answer_.end = std::chrono::steady_clock::now();
  is_done_ = true;
  changed_.notify_all();
}

void PacedCall::Advance() {
  if (!is_held_) return;
  if (!is_writing_ && written_ < may_write_) {
    is_writing_ = true;
    outgoing_ = BufferOf(request_.messages[written_++]);
    if (written_ == request_.messages.size()) {
      StartWriteLast(&outgoing_, grpc::WriteOptions());
    } else {
      StartWrite(&outgoing_);
    }
  }
  if (!has_ended_ && !is_reading_ && answer_.messages.size() < may_read_) {
    is_reading_ = true;
    StartRead(&incoming_);
  }
  if (has_ended_) End();
  changed_.notify_all();
}

void PacedCall::End() {
  if (std::exchange(is_held_, false)) RemoveHold();
}

}  // namespace geodesic::client
