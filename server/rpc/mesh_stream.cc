#include "server/rpc/mesh_stream.h"

#include <algorithm>
#include <bit>
#include <span>
#include <string>
#include <utility>

#include "server/rpc/status_translation.h"

namespace geodesic::server {
namespace {

// Arrays are sent as they lie in memory.
static_assert(std::endian::native == std::endian::little);
static_assert(sizeof(Point) == 24 && sizeof(Triangle) == 12);

constexpr uint64_t kChunkBytes = uint64_t{512} << 10;

// Copies one chunk of `items` from `begin` on; returns where the next begins.
template <typename T>
uint64_t FillChunk(std::span<const T> items, uint64_t begin,
                   std::string& bytes) {
  const uint64_t count =
      std::min<uint64_t>(kChunkBytes / sizeof(T), items.size() - begin);
  bytes.assign(reinterpret_cast<const char*>(items.data() + begin),
               count * sizeof(T));
  return begin + count;
}

}  // namespace

MeshStream::MeshStream(QueryEngine& engine, RequestLog& log,
                       const v1::ReadMeshRequest& request)
    : entry_(log, "ReadMesh") {
  entry_.set_subject(DigestPrefix(request.digest()));
  if (absl::Status status = log.CheckRoom(); !status.ok()) {
    End(std::move(status));
    return;
  }
  absl::StatusOr<MeshHandle> mesh = engine.GetMesh(request.digest());
  if (!mesh.ok()) {
    End(mesh.status());
    return;
  }
  mesh_ = *std::move(mesh);
  v1::ReadMeshHeader& header = *message_.mutable_header();
  header.set_digest(mesh_->digest);
  header.set_vertex_count(mesh_->mesh->vertex_count());
  header.set_face_count(mesh_->mesh->face_count());
  StartWrite(&message_);
}

void MeshStream::OnWriteDone(bool ok) {
  if (!ok) {
    End(absl::CancelledError("the client is gone"));
  } else if (next_vertex_ < mesh_->mesh->vertex_count()) {
    WriteVertices();
  } else if (next_face_ < mesh_->mesh->face_count()) {
    WriteFaces();
  } else {
    End(absl::OkStatus());
  }
}

void MeshStream::WriteVertices() {
  v1::VertexChunk& chunk = *message_.mutable_vertices();
  chunk.set_first_vertex(next_vertex_);
  next_vertex_ = FillChunk(mesh_->mesh->positions(), next_vertex_,
                           *chunk.mutable_positions());
  entry_.add_bytes(chunk.positions().size());
  StartWrite(&message_);
}

void MeshStream::WriteFaces() {
  v1::FaceChunk& chunk = *message_.mutable_faces();
  chunk.set_first_face(next_face_);
  next_face_ =
      FillChunk(mesh_->mesh->triangles(), next_face_, *chunk.mutable_indices());
  entry_.add_bytes(chunk.indices().size());
  StartWrite(&message_);
}

void MeshStream::OnDone() { delete this; }

void MeshStream::End(absl::Status status) {
  Finish(ToGrpcStatus(status));
  entry_.set_status(std::move(status));
}

}  // namespace geodesic::server
