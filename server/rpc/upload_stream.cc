#include "server/rpc/upload_stream.h"

#include <utility>

#include "server/engine/status_details.h"
#include "server/rpc/mesh_translation.h"

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

grpc::ServerReadReactor<v1::CreateMeshRequest>* UploadStream::Start(
    QueryEngine& engine, RequestLog& log, grpc::CallbackServerContext& context,
    v1::CreateMeshResponse& response) {
  const std::shared_ptr<UploadStream> stream(
      new UploadStream(engine, log, context, response));
  stream->self_ = stream;
  stream->Begin();
  return stream.get();
}

UploadStream::UploadStream(QueryEngine& engine, RequestLog& log,
                           grpc::CallbackServerContext& context,
                           v1::CreateMeshResponse& response)
    : engine_(engine), context_(context), response_(response) {
  entry_.emplace(log, "CreateMesh", context);
}

void UploadStream::Begin() {
  std::lock_guard lock(mutex_);
  if (absl::Status status = entry_->AdmitStream(); !status.ok()) {
    End(std::move(status));
    return;
  }
  StartRead(&message_);
}

void UploadStream::OnReadDone(bool ok) {
  if (!ok) {
    Complete();
    return;
  }
  std::lock_guard lock(mutex_);
  if (finished_) return;
  if (absl::Status status = TakeMessage(); !status.ok()) {
    End(std::move(status));
    return;
  }
  StartRead(&message_);
}

absl::Status UploadStream::TakeMessage() {
  switch (message_.part_case()) {
    case v1::CreateMeshRequest::kHeader: {
      if (upload_ != nullptr) {
        return InvalidField("header", "the upload has a second header");
      }
      absl::StatusOr<UploadHeader> header = FromProto(message_.header());
      if (!header.ok()) return header.status();
      absl::StatusOr<std::unique_ptr<MeshUpload>> upload =
          engine_.StartUpload(*std::move(header));
      if (!upload.ok()) return upload.status();
      upload_ = *std::move(upload);
      return entry_->job().ReserveBytes(LeastBytes(upload_->header()));
    }
    case v1::CreateMeshRequest::kChunk:
      if (upload_ == nullptr) {
        return InvalidField("header",
                            "the upload does not begin with a header");
      }
      entry_->add_bytes(message_.chunk().data().size());
      return upload_->Append(message_.chunk().offset(),
                             message_.chunk().data());
    case v1::CreateMeshRequest::PART_NOT_SET:
      break;
  }
  return InvalidField("part",
                      "a message of the upload has neither header nor chunk");
}

void UploadStream::Complete() {
  std::unique_ptr<MeshUpload> upload;
  Quotas::MeshCharge charge;
  std::string client;
  {
    std::lock_guard lock(mutex_);
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
    charge = entry_->job().mesh_charge();
    client = entry_->client();
  }
  // Without the lock: the engine may call back at once.
  absl::StatusOr<std::optional<Scheduler::JobId>> job = engine_.FinishUpload(
      std::move(upload),
      [self = shared_from_this(),
       charge](const absl::StatusOr<UploadResult>& result) {
        // Whether or not somebody still waits for the answer.
        if (result.ok() && !result->already_resident) {
          const auto mesh = self->engine_.GetMesh(result->mesh.digest);
          if (mesh.ok()) charge.Add(*mesh);
        }
        self->OnBuilt(result);
      },
      client);
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
  std::optional<Scheduler::JobId> job;
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
  Finish(entry_->End(std::move(status)));
}

}  // namespace geodesic::server
