#include "server/rpc/streams/mesh_streams.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <string>
#include <utility>

#include "geodesic/triangle_soup.h"
#include "geodesic_types/field_path.h"
#include "server/rpc/messages/translation.h"

namespace geodesic::server {
namespace {

static_assert(std::endian::native == std::endian::little);
static_assert(sizeof(Point) == 24 && sizeof(Triangle) == 12 &&
              sizeof(JoinedVertex) == 8);

constexpr uint64_t kChunkBytes = uint64_t{512} << 10;

// Copies one chunk of the `count` items that `item` gives, from `begin` on;
// returns where the next chunk begins.
template <typename Item>
uint64_t FillChunk(uint64_t count, uint64_t begin, Item item,
                   std::string& bytes) {
  constexpr size_t kItemBytes = sizeof(item(0));
  const uint64_t end = std::min(begin + kChunkBytes / kItemBytes, count);
  bytes.resize((end - begin) * kItemBytes);
  char* to = bytes.data();
  for (uint64_t i = begin; i < end; ++i, to += kItemBytes) {
    std::memcpy(to, &item(i), kItemBytes);
  }
  return end;
}

// The memory that the mesh will take, as far as the header tells. A file's need
// is only known when it is parsed, so its size is used instead.
uint64_t LeastBytes(const UploadHeader& header) {
  return header.format == kArrays ? Mesh::EstimateResidentBytes(
                                        header.vertex_count, header.face_count)
                                  : header.size_bytes;
}

}  // namespace

absl::Status MeshStream::Ask() {
  absl::StatusOr<MeshHandle> mesh = engine().meshes().Get(request().digest());
  if (mesh.ok()) mesh_ = *std::move(mesh);
  return mesh.status();
}

absl::StatusOr<NextMessage> MeshStream::Fill(v1::ReadMeshResponse& message) {
  const Mesh& mesh = *mesh_->mesh;
  if (!std::exchange(has_header_, true)) {
    v1::ReadMeshHeader& header = *message.mutable_header();
    header.set_digest(mesh_->digest);
    header.set_vertex_count(mesh.vertex_count());
    header.set_face_count(mesh.face_count());
    header.set_seam_edge_count(mesh.reading().seam_edges);
    header.set_crossing_polygon_count(mesh.reading().crossing_polygons);
    header.set_first_crossing_polygon(mesh.reading().first_crossing_polygon);
    header.set_joined_vertex_count(mesh.reading().joined.size());
    return NextMessage::kSend;
  }
  if (next_vertex_ < mesh.vertex_count()) {
    v1::VertexChunk& chunk = *message.mutable_vertices();
    chunk.set_first_vertex(next_vertex_);
    next_vertex_ = FillChunk(
        mesh.vertex_count(), next_vertex_,
        [&](uint64_t v) -> const Point& { return mesh.positions()[v]; },
        *chunk.mutable_positions());
    entry().add_bytes(chunk.positions().size());
    return NextMessage::kSend;
  }
  const std::vector<JoinedVertex>& joined = mesh.reading().joined;
  if (next_face_ < mesh.face_count()) {
    v1::FaceChunk& chunk = *message.mutable_faces();
    chunk.set_first_face(next_face_);
    next_face_ = FillChunk(
        mesh.face_count(), next_face_,
        [&](uint64_t face) -> const Triangle& {
          return mesh.NamedTriangle(face);
        },
        *chunk.mutable_indices());
    entry().add_bytes(chunk.indices().size());
    // A mesh has at least one face.
    return next_face_ < mesh.face_count() || !joined.empty()
               ? NextMessage::kSend
               : NextMessage::kSendLast;
  }
  v1::JoinedChunk& chunk = *message.mutable_joined();
  chunk.set_first_pair(next_joined_);
  next_joined_ = FillChunk(
      joined.size(), next_joined_,
      [&](uint64_t i) -> const JoinedVertex& { return joined[i]; },
      *chunk.mutable_pairs());
  entry().add_bytes(chunk.pairs().size());
  return next_joined_ < joined.size() ? NextMessage::kSend
                                      : NextMessage::kSendLast;
}

void UploadStream::OnReceived(bool ok) {
  if (!ok) {
    Complete();
    return;
  }
  {
    MutexLock lock(mutex_);
    if (finished_) return;
    if (absl::Status status = TakeMessage(); !status.ok()) {
      End(std::move(status));
      return;
    }
  }
  ReceiveNext();
}

absl::Status UploadStream::TakeMessage() {
  v1::CreateMeshRequest message;
  const absl::StatusOr<ByteReservation> memory = Decode(message);
  if (!memory.ok()) return memory.status();
  switch (message.part_case()) {
    case v1::CreateMeshRequest::kHeader: {
      if (upload_ != nullptr) {
        return InvalidField("header", "the upload has a second header");
      }
      absl::StatusOr<UploadHeader> header = FromProto(message.header());
      if (!header.ok()) return header.status();
      absl::StatusOr<std::unique_ptr<MeshUpload>> upload =
          engine().meshes().StartUpload(*std::move(header));
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
    MutexLock lock(mutex_);
    if (finished_) return;
    if (context_.IsCancelled()) {
      End(absl::CancelledError(kNoMessage));
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
  // Called without the lock, because the engine may call back at once.
  absl::StatusOr<UploadJobs::Ticket> job = engine().meshes().FinishUpload(
      std::move(upload),
      [self = Shared(this)](const absl::StatusOr<UploadResult>& result) {
        self->OnBuilt(result);
      },
      client,
      // The job holds this callback, so it counts against the quota to its end.
      [&engine = engine(),
       quota = std::move(quota)](const UploadResult& result) {
        if (result.already_resident) return;
        const auto mesh = engine.meshes().Get(result.mesh.digest);
        if (!mesh.ok()) return;
        quota->AddMemory(*mesh, (*mesh)->mesh->resident_bytes());
      });
  MutexLock lock(mutex_);
  if (!job.ok()) {
    End(job.status());
  } else if (finished_) {
    engine().meshes().CancelUpload(*job);
  } else {
    job_ = *job;
  }
}

void UploadStream::OnBuilt(const absl::StatusOr<UploadResult>& result) {
  MutexLock lock(mutex_);
  // After Finish neither response_ nor entry_ may be used.
  if (finished_) return;
  if (!result.ok()) {
    End(result.status());
    return;
  }
  entry_->set_subject(DigestPrefix(result->mesh.digest));
  *response_.mutable_mesh() = ToProto(result->mesh);
  response_.set_already_resident(result->already_resident);
  End(absl::OkStatus(), &response_);
}

void UploadStream::OnCancel() {
  UploadJobs::Ticket job;
  {
    MutexLock lock(mutex_);
    job = job_;
    upload_.reset();
    EndCancelled();
  }
  engine().meshes().CancelUpload(job);
}

}  // namespace geodesic::server
