#include "server/rpc/streams/decimate_stream.h"

#include <utility>
#include <vector>

#include "server/rpc/streams/array_chunks.h"

namespace geodesic::server {

absl::Status DecimateStream::Ask() {
  absl::StatusOr<MeshHandle> mesh = engine().meshes().Get(request().digest());
  if (!mesh.ok()) return mesh.status();
  mesh_ = *std::move(mesh);
  absl::StatusOr<DecimationJobs::Ticket> ticket =
      engine().decimations().Decimate(
          mesh_, request().max_faces(),
          {.done =
               [self = Shared(this)](
                   const absl::StatusOr<DecimationHandle>& made) {
                 self->Update([&] { self->made_ = made; });
               }},
          requester());
  if (ticket.ok()) ticket_ = *std::move(ticket);
  return ticket.status();
}

absl::StatusOr<NextMessage> DecimateStream::Fill(
    v1::DecimateMeshResponse& message) {
  if (!made_.has_value()) return NextMessage::kWait;
  if (!made_->ok()) return made_->status();
  const std::vector<Triangle>& triangles = ***made_;
  if (!std::exchange(has_header_, true)) {
    v1::DecimateMeshHeader& header = *message.mutable_header();
    header.set_digest(mesh_->digest);
    header.set_face_count(triangles.size());
    return NextMessage::kSend;
  }
  v1::FaceChunk& chunk = *message.mutable_faces();
  chunk.set_first_face(next_face_);
  next_face_ = FillChunk(
      triangles.size(), next_face_,
      [&](uint64_t face) -> const Triangle& { return triangles[face]; },
      *chunk.mutable_indices());
  entry().add_bytes(chunk.indices().size());
  // A component keeps a face.
  return next_face_ < triangles.size() ? NextMessage::kSend
                                       : NextMessage::kSendLast;
}

}  // namespace geodesic::server
