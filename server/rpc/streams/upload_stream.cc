#include "server/rpc/streams/upload_stream.h"

#include <utility>

#include "geodesic/field_path.h"
#include "server/rpc/messages/mesh_translation.h"

namespace geodesic::server {
namespace {

// What the mesh will take in memory, as far as its header tells: a file does
// not say before it is read, so its own size stands for it.
uint64_t LeastBytes(const UploadHeader& header) {
  return header.format == UploadFormat::kArrays
             ? Mesh::EstimateResidentBytes(header.vertex_count,
                                           header.face_count)
             : header.size_bytes;
}

}  // namespace

UploadStream::UploadStream(const ServiceContext& service,
                           grpc::CallbackServerContext& context)
    : service_(service),
      engine_(service.engine),
      context_(context),
      peer_(context.peer()) {
  entry_.emplace(service.log, "CreateMesh", context);
}

void UploadStream::Launch(std::shared_ptr<UploadStream> self) {
  {
    std::lock_guard lock(mutex_);
    self_ = std::move(self);
    if (absl::Status status = entry_->AdmitStream(); !status.ok()) {
      End(std::move(status));
      return;
    }
  }
  ReadNext();
}

void UploadStream::ReadNext() {
  {
    std::lock_guard lock(mutex_);
    if (finished_) return;
    arrival_.Start(
        service_.intake.patience(),
        [stream = self_, message = ++messages_] { stream->OnLate(message); });
  }
  service_.intake.slots().Enter(shared_from_this(), peer_);
}

void UploadStream::OnLate(uint64_t message) {
  std::lock_guard lock(mutex_);
  // It may have come in the meantime.
  if (messages_ == message) End(LateError(service_.intake.patience()));
}

void UploadStream::OnSlot() {
  {
    std::lock_guard lock(mutex_);
    if (!finished_) {
      is_receiving_ = true;
      StartRead(&bytes_);
      return;
    }
  }
  service_.intake.slots().Leave(*this);
}

void UploadStream::OnBrokenOff() {
  std::lock_guard lock(mutex_);
  if (!is_receiving_) return;
  if (!finished_) {
    End(BrokenOffError());
  } else {
    // Its client does not even take the answer.
    context_.TryCancel();
  }
}

void UploadStream::OnReadDone(bool ok) {
  {
    std::lock_guard lock(mutex_);
    is_receiving_ = false;
  }
  service_.intake.slots().Leave(*this);
  if (!ok) {
    Complete();
    return;
  }
  {
    std::lock_guard lock(mutex_);
    arrival_.Stop();
    if (finished_) return;
    if (absl::Status status = TakeMessage(); !status.ok()) {
      End(std::move(status));
      return;
    }
  }
  ReadNext();
}

absl::Status UploadStream::TakeMessage() {
  v1::CreateMeshRequest message;
  const absl::StatusOr<ByteReservation> memory =
      service_.intake.Decode(bytes_, message);
  bytes_.Clear();
  if (!memory.ok()) return memory.status();
  switch (message.part_case()) {
    case v1::CreateMeshRequest::kHeader: {
      if (upload_ != nullptr) {
        return InvalidField("header", "the upload has a second header");
      }
      absl::StatusOr<UploadHeader> header = FromProto(message.header());
      if (!header.ok()) return header.status();
      absl::StatusOr<std::unique_ptr<MeshUpload>> upload =
          engine_.StartUpload(*std::move(header));
      if (!upload.ok()) return upload.status();
      upload_ = *std::move(upload);
      return entry_->job()->ReserveBytes(LeastBytes(upload_->header()));
    }
    case v1::CreateMeshRequest::kChunk:
      if (upload_ == nullptr) {
        return InvalidField("header",
                            "the upload does not begin with a header");
      }
      entry_->add_bytes(message.chunk().data().size());
      return upload_->Append(message.chunk().offset(), message.chunk().data());
    case v1::CreateMeshRequest::PART_NOT_SET:
      break;
  }
  return InvalidField("part",
                      "a message of the upload has neither header nor chunk");
}

void UploadStream::Complete() {
  std::unique_ptr<MeshUpload> upload;
  std::shared_ptr<Quotas::Job> quota;
  std::string client;
  {
    std::lock_guard lock(mutex_);
    arrival_.Stop();
    ++messages_;  // there is none
    if (finished_) return;
    if (context_.IsCancelled()) {
      End(absl::CancelledError("the client is gone"));
      return;
    }
    if (upload_ == nullptr) {
      End(InvalidField("header", "the upload ended before its header"));
      return;
    }
    upload = std::move(upload_);
    quota = entry_->job();
    client = entry_->client();
  }
  // Without the lock: the engine may call back at once.
  absl::StatusOr<std::optional<UploadJobs::Ticket>> job = engine_.FinishUpload(
      std::move(upload),
      [self = shared_from_this()](const absl::StatusOr<UploadResult>& result) {
        self->OnBuilt(result);
      },
      client,
      // Held by the job, which counts against the quota to its end.
      [&engine = engine_,
       quota = std::move(quota)](const UploadResult& result) {
        if (result.already_resident) return;
        const auto mesh = engine.GetMesh(result.mesh.digest);
        if (!mesh.ok()) return;
        quota->memory_charge().Add(*mesh, (*mesh)->mesh->resident_bytes());
      });
  std::lock_guard lock(mutex_);
  if (!job.ok()) {
    End(job.status());
  } else if (*job && finished_) {
    engine_.CancelUpload(**job);
  } else {
    job_ = *job;
  }
}

void UploadStream::OnBuilt(const absl::StatusOr<UploadResult>& result) {
  std::lock_guard lock(mutex_);
  // After Finish neither the response nor the log entry is ours.
  if (finished_) return;
  if (result.ok()) {
    entry_->set_subject(DigestPrefix(result->mesh.digest));
    *response_.mutable_mesh() = ToProto(result->mesh);
    response_.set_already_resident(result->already_resident);
  }
  End(result.status());
}

void UploadStream::OnCancel() {
  std::optional<UploadJobs::Ticket> job;
  {
    std::lock_guard lock(mutex_);
    job = job_;
    upload_.reset();
    End(absl::CancelledError("the call was cancelled or its deadline came"));
  }
  if (job) engine_.CancelUpload(*job);
}

void UploadStream::OnDone() {
  std::shared_ptr<UploadStream> self;
  std::lock_guard lock(mutex_);
  entry_.reset();
  // The lock is released before `self`, which may be the last to hold it.
  self = std::move(self_);
}

void UploadStream::End(absl::Status status) {
  if (finished_) return;
  finished_ = true;
  arrival_.Stop();
  if (status.ok()) {
    StartWriteAndFinish(&response_, grpc::WriteOptions(),
                        entry_->End(std::move(status)));
  } else {
    Finish(entry_->End(std::move(status)));
  }
}

}  // namespace geodesic::server
