#include "server/rpc/field_stream.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "server/rpc/call_deadline.h"
#include "server/rpc/message_translation.h"
#include "server/rpc/status_translation.h"

namespace geodesic::server {
namespace {

// Distances are sent as they lie in memory.
static_assert(std::endian::native == std::endian::little);

// 512 KiB a message: large enough to stream at the speed of memory, small
// enough that a stalled reader costs little.
constexpr uint64_t kVerticesPerChunk = 65536;

// What geodesic::Solve guarantees (solve.h).
constexpr double kRelativeTolerance = 1e-10;

}  // namespace

grpc::ServerWriteReactor<v1::ComputeFieldResponse>* FieldStream::Start(
    QueryEngine& engine, RequestLog& log, const std::string& version,
    const grpc::CallbackServerContext& context,
    const v1::ComputeFieldRequest& request) {
  const std::shared_ptr<FieldStream> stream(
      new FieldStream(engine, log, version));
  stream->self_ = stream;
  stream->Begin(log, context, request);
  return stream.get();
}

FieldStream::FieldStream(QueryEngine& engine, RequestLog& log,
                         const std::string& version)
    : engine_(engine), version_(version) {
  entry_.emplace(log, "ComputeField");
}

absl::StatusOr<FieldCall> FieldStream::Ask(
    const RequestLog& log, const grpc::CallbackServerContext& context,
    const v1::ComputeFieldRequest& request) {
  if (absl::Status status = log.CheckRoom(); !status.ok()) return status;
  absl::StatusOr<FieldRequest> query = FromProto(request);
  if (!query.ok()) return query.status();
  query->deadline = CallDeadline(context);
  return engine_.ComputeField(*query, shared_from_this());
}

void FieldStream::Begin(const RequestLog& log,
                        const grpc::CallbackServerContext& context,
                        const v1::ComputeFieldRequest& request) {
  entry_->set_subject(DigestPrefix(request.mesh_digest()));
  // Without the lock: the engine may call back at once.
  absl::StatusOr<FieldCall> call = Ask(log, context, request);
  std::lock_guard lock(mutex_);
  if (!call.ok()) {
    End(call.status());
    return;
  }
  call_ = *std::move(call);
  if (call_.field != nullptr) field_ = std::move(call_.field);
  v1::FieldAccepted& accepted = *message_.mutable_accepted();
  accepted.set_mesh_digest(request.mesh_digest());
  accepted.set_vertex_count(call_.vertex_count);
  accepted.set_algorithm(ToProto(call_.algorithm));
  accepted.set_origin(ToProto(call_.origin));
  begun_ = true;
  Write();
}

void FieldStream::OnWriteDone(bool ok) {
  std::lock_guard lock(mutex_);
  writing_ = false;
  if (!ok) {
    // The stream is broken; OnCancel tells the engine.
    End(absl::CancelledError("the client is gone"));
    return;
  }
  Advance();
}

void FieldStream::OnCancel() {
  FieldCall call;
  {
    std::lock_guard lock(mutex_);
    call = call_;
    End(absl::CancelledError("the call was cancelled or its deadline came"));
  }
  // Without the lock, for the engine has its own.
  engine_.Cancel(call);
}

void FieldStream::OnDone() {
  std::shared_ptr<FieldStream> self;
  std::lock_guard lock(mutex_);
  entry_.reset();
  // The lock is released before `self`, which may be the last to hold it.
  self = std::move(self_);
}

void FieldStream::OnProgress(const Progress& progress) {
  std::lock_guard lock(mutex_);
  progress_ = progress;
  Advance();
}

void FieldStream::OnField(const absl::StatusOr<FieldHandle>& field) {
  std::lock_guard lock(mutex_);
  field_ = field;
  Advance();
}

void FieldStream::Advance() {
  if (!begun_ || writing_ || finished_) return;
  if (field_.has_value()) {
    if (!field_->ok()) {
      End(field_->status());
    } else if (offset_ < (**field_)->distances.size()) {
      WriteChunk();
    } else {
      WriteTrailer();
    }
  } else if (progress_.has_value()) {
    *message_.mutable_progress() = ToProto(*std::exchange(progress_, {}));
    Write();
  }
}

void FieldStream::WriteChunk() {
  const std::vector<double>& distances = (**field_)->distances;
  const uint64_t count =
      std::min<uint64_t>(kVerticesPerChunk, distances.size() - offset_);
  v1::FieldChunk& chunk = *message_.mutable_chunk();
  chunk.set_offset(offset_);
  // Into the string of the chunk before, which has the size already.
  chunk.mutable_distances()->assign(
      reinterpret_cast<const char*>(distances.data() + offset_),
      count * sizeof(double));
  offset_ += count;
  entry_->add_bytes(count * sizeof(double));
  Write();
}

void FieldStream::WriteTrailer() {
  v1::FieldTrailer& trailer = *message_.mutable_trailer();
  trailer.set_origin(ToProto(call_.origin));
  *trailer.mutable_statistics() = ToProto((**field_)->statistics);
  trailer.set_relative_tolerance(kRelativeTolerance);
  trailer.set_server_version(version_);
  finished_ = true;
  StartWriteAndFinish(&message_, grpc::WriteOptions(), grpc::Status::OK);
}

void FieldStream::Write() {
  writing_ = true;
  StartWrite(&message_);
}

void FieldStream::End(absl::Status status) {
  if (finished_) return;
  finished_ = true;
  Finish(ToGrpcStatus(status));
  entry_->set_status(std::move(status));
}

}  // namespace geodesic::server
