#include "tests/reliability/paced_call.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace geodesic::client {

PacedCall::PacedCall(const std::string& address, RawRequest request,
                     size_t writes, size_t reads)
    : request_(std::move(request)),
      channel_(OwnConnection(address, Window::kSmall)),
      stub_(channel_),
      may_write_(std::min(writes, request_.messages.size())),
      may_read_(reads) {
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
