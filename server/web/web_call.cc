#include "server/web/web_call.h"

#include <microhttpd.h>

#include <algorithm>
#include <cstring>
#include <utility>
#include <vector>

#include "absl/strings/escaping.h"
#include "absl/strings/string_view.h"
#include "server/rpc/calls/streams_requests.h"
#include "server/rpc/messages/grpc_status.h"

namespace geodesic::server {
namespace {

// Messages up to this size are received without a slot: connections are
// bounded.
constexpr size_t kSmallMessage = 64 << 10;

}  // namespace

WebCall::~WebCall() {
  if (stream_ == nullptr) return;
  stream_.reset();
  door_.queue.Leave();
}

void WebCall::Start(const std::string& method) {
  MutexLock lock(mutex_);
  self_ = shared_from_this();
  streams_requests_ = StreamsRequests(method);
  stream_ = door_.queue.Enter(context_, method);
  stream_->StartCall(Begin(started_));
}

size_t WebCall::Receive(std::string_view body) {
  size_t taken = 0;
  Take(body, taken);
  return taken;
}

bool WebCall::Take(std::string_view body, size_t& taken) {
  for (bool goes_on = true; goes_on;) {
    if (!MakeRoom()) return false;
    MutexLock lock(mutex_);
    // An answer cannot begin before the request has ended, and a browser would
    // take an end in between for a broken connection.
    if (is_closed_ || failure_) {
      taken = body.size();
      return true;
    }
    if (reader_.has_message()) {
      Suspend();
      return false;
    }
    const absl::StatusOr<size_t> read = reader_.Read(body.substr(taken));
    if (!read.ok()) {
      Fail(read.status());
      taken = body.size();
      return true;
    }
    taken += *read;
    Forward();
    goes_on =
        taken < body.size() || reader_.wants_room() || reader_.has_pending();
  }
  return true;
}

bool WebCall::MakeRoom() {
  {
    MutexLock lock(mutex_);
    if (!reader_.wants_room() || is_closed_ || failure_) return true;
    const bool needs_slot = reader_.message_bytes() > kSmallMessage;
    if (!needs_slot || has_slot_) {
      reader_.MakeRoom();
      Forward();
      return true;
    }
    if (waits_for_slot_) {
      Suspend();
      return false;
    }
    waits_for_slot_ = true;
  }
  // May call OnSlot at once.
  door_.intake.Enter(shared_from_this(), address_);
  return MakeRoom();
}

void WebCall::OnSlot() {
  {
    MutexLock lock(mutex_);
    waits_for_slot_ = false;
    has_slot_ = true;
    Wake();
  }
  ReturnSlot();
}

void WebCall::OnBrokenOff() {
  {
    MutexLock lock(mutex_);
    // What is whole goes its way.
    if (!is_writing_ && !reader_.has_message()) Fail(BrokenOffError());
    Wake();
  }
  ReturnSlot();
}

void WebCall::ReturnSlot() {
  {
    MutexLock lock(mutex_);
    const bool is_receiving = reader_.wants_room() || reader_.has_room();
    const bool has_ended = is_closed_ || failure_ || has_left_;
    if (!has_slot_ || is_writing_ || (is_receiving && !has_ended)) return;
    if (has_ended) reader_.Drop();
    has_slot_ = false;
  }
  door_.intake.Leave(*this);
}

bool WebCall::EndBody() {
  if (size_t none = 0; !Take({}, none)) return false;
  MutexLock lock(mutex_);
  if (body_ended_) return true;
  body_ended_ = true;
  if (!reader_.has_message() && !is_closed_ && !failure_) {
    const absl::Status status = reader_.CheckEnd();
    if (!status.ok()) Fail(status);
  }
  Forward();
  return true;
}

bool WebCall::CanAnswer() {
  MutexLock lock(mutex_);
  if (has_metadata_ || is_finished_) return true;
  Suspend();
  return false;
}

HttpHeaders WebCall::Headers() const {
  MutexLock lock(mutex_);
  return has_metadata_ ? ToHeaders(context_.GetServerInitialMetadata())
                       : HttpHeaders();
}

ssize_t WebCall::Read(char* out, size_t room) {
  MutexLock lock(mutex_);
  if (has_left_) return MHD_CONTENT_READER_END_WITH_ERROR;
  if (!outgoing_.empty() || Refill()) {
    return static_cast<ssize_t>(CopyOut(out, room));
  }
  if (trailers_sent_) return MHD_CONTENT_READER_END_OF_STREAM;
  Suspend();
  return 0;
}

bool WebCall::Refill() {
  if (has_response_) {
    has_response_ = false;
    std::vector<grpc::Slice> slices;
    if (!response_.Dump(&slices).ok()) slices.clear();
    outgoing_.emplace_back(FrameHeader(response_.Length()));
    outgoing_.insert(outgoing_.end(), slices.begin(), slices.end());
    response_.Clear();
    return true;
  }
  if (is_finished_ && !trailers_sent_) {
    trailers_sent_ = true;
    outgoing_.emplace_back(
        TrailerFrame(failure_.value_or(status_), Trailers()));
    return true;
  }
  if (!is_reading_ && !is_closed_) ReadNext();
  return false;
}

HttpHeaders WebCall::Trailers() const {
  if (!failure_) return ToHeaders(context_.GetServerTrailingMetadata());
  return {{"grpc-status-details-bin",
           absl::Base64Escape(failure_->error_details())}};
}

size_t WebCall::CopyOut(char* out, size_t room) {
  // Each piece of text is base64 by itself.
  std::string piece;
  const size_t most = encoding_ == WebEncoding::kText ? room / 4 * 3 : room;
  size_t size = 0;
  while (size < most && !outgoing_.empty()) {
    const grpc::Slice& slice = outgoing_.front();
    const size_t count = std::min(most - size, slice.size() - sent_);
    if (encoding_ == WebEncoding::kText) {
      piece.append(reinterpret_cast<const char*>(slice.begin()) + sent_, count);
    } else {
      std::memcpy(out + size, slice.begin() + sent_, count);
    }
    size += count;
    sent_ += count;
    if (sent_ < slice.size()) break;
    outgoing_.pop_front();
    sent_ = 0;
  }
  if (encoding_ != WebEncoding::kText) return size;
  const std::string text = absl::Base64Escape(piece);
  text.copy(out, text.size());
  return text.size();
}

void WebCall::Leave() {
  const auto self = shared_from_this();
  {
    MutexLock lock(mutex_);
    if (has_left_) return;
    has_left_ = true;
    if (!is_finished_) context_.TryCancel();
    // A read that is under way ends, and closes the call then.
    if (!is_reading_) Close();
    Wake();
  }
  ReturnSlot();
}

bool WebCall::has_left() const {
  MutexLock lock(mutex_);
  return has_left_;
}

uint64_t WebCall::messages() const {
  MutexLock lock(mutex_);
  return messages_;
}

void WebCall::OnStarted(bool ok) {
  const auto self = shared_from_this();
  MutexLock lock(mutex_);
  is_writing_ = false;
  is_reading_ = false;
  if (ok && !has_left_ && !failure_) {
    ReadNext();
    Forward();
  } else {
    Close();
  }
  Wake();
  Done();
}

void WebCall::OnRead(bool ok) {
  const auto self = shared_from_this();
  {
    MutexLock lock(mutex_);
    is_reading_ = false;
    has_response_ = ok;
    has_metadata_ |= ok;
    if (!ok || has_left_ || failure_) Close();
    Forward();
    Wake();
    Done();
  }
  ReturnSlot();
}

void WebCall::OnWritten(bool ok) {
  const auto self = shared_from_this();
  {
    MutexLock lock(mutex_);
    is_writing_ = false;
    request_.Clear();
    // If it was not taken, the call has ended, which the read will say.
    if (ok) Forward();
    Wake();
    Done();
  }
  ReturnSlot();
}

void WebCall::OnWritesEnded(bool) {
  const auto self = shared_from_this();
  MutexLock lock(mutex_);
  Done();
}

void WebCall::OnFinished(bool) {
  const auto self = shared_from_this();
  MutexLock lock(mutex_);
  is_finished_ = true;
  // gRPC 1.51 keeps both ends of a call in a process (26 KB) as long as the
  // channel lives if the server's status comes before the end of the request.
  // Of two ends that are open yet, a late cancellation closes both; so the end
  // of a request is told only if the server waits for it.
  context_.TryCancel();
  Wake();
  Done();
}

CallQueue::Event* WebCall::Begin(CallQueue::Event& event) {
  ++under_way_;
  return &event;
}

void WebCall::Done() {
  --under_way_;
  if (is_finished_ && under_way_ == 0) self_.reset();
}

void WebCall::Suspend() {
  // Whoever has left is not waited for.
  if (has_left_ || is_suspended_) return;
  is_suspended_ = true;
  MHD_suspend_connection(&connection_);
}

void WebCall::Wake() {
  if (!is_suspended_) return;
  is_suspended_ = false;
  MHD_resume_connection(&connection_);
}

void WebCall::Forward() {
  if (is_closed_ || failure_) return;
  // Who answers reads no more: browsers' calls do not go both ways. The answer
  // is read when the request has ended, so what comes of that must not wait.
  if (has_metadata_ && reader_.has_message()) reader_.TakeMessage();
  if (is_writing_) return;
  if (reader_.has_message()) {
    is_writing_ = true;
    ++messages_;
    request_ = reader_.TakeMessage();
    stream_->Write(request_, Begin(written_));
  } else if (body_ended_ && !ended_writes_ &&
             (streams_requests_ || messages_ == 0)) {
    ended_writes_ = true;
    stream_->WritesDone(Begin(writes_ended_));
  }
}

void WebCall::Close() {
  if (is_closed_) return;
  is_closed_ = true;
  stream_->Finish(&status_, Begin(finished_));
}

void WebCall::ReadNext() {
  is_reading_ = true;
  stream_->Read(&response_, Begin(read_));
}

void WebCall::Fail(const absl::Status& status) {
  if (failure_) return;
  failure_ = ToGrpcStatus(status);
  context_.TryCancel();
  if (!is_reading_) Close();
}

}  // namespace geodesic::server
