#include "server/rpc/mesh_stream.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <string>
#include <utility>

#include "server/rpc/status_translation.h"

namespace geodesic::server {
namespace {

// Arrays are sent as they lie in memory.
static_assert(std::endian::native == std::endian::little);
static_assert(sizeof(Point) == 24 && sizeof(Triangle) == 12);

constexpr uint64_t kChunkBytes = uint64_t{512} << 10;

// Copies one chunk of the `count` items that `item` gives from `begin` on;
// returns where the next begins.
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
  const Mesh& mesh = *mesh_->mesh;
  next_vertex_ = FillChunk(
      mesh.vertex_count(), next_vertex_,
      [&](uint64_t v) -> const Point& { return mesh.positions()[v]; },
      *chunk.mutable_positions());
  entry_.add_bytes(chunk.positions().size());
  StartWrite(&message_);
}

void MeshStream::WriteFaces() {
  v1::FaceChunk& chunk = *message_.mutable_faces();
  chunk.set_first_face(next_face_);
  const Mesh& mesh = *mesh_->mesh;
  next_face_ = FillChunk(
      mesh.face_count(), next_face_,
      [&](uint64_t face) -> const Triangle& { return mesh.triangle(face); },
      *chunk.mutable_indices());
  entry_.add_bytes(chunk.indices().size());
  StartWrite(&message_);
}

void MeshStream::OnDone() { delete this; }

void MeshStream::End(absl::Status status) {
  Finish(ToGrpcStatus(status));
  entry_.set_status(std::move(status));
}

}  // namespace geodesic::server
