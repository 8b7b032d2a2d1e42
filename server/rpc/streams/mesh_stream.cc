#include "server/rpc/streams/mesh_stream.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <memory>
#include <string>
#include <utility>

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

absl::Status MeshStream::Ask() {
  absl::StatusOr<MeshHandle> mesh = engine().GetMesh(request().digest());
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
  v1::FaceChunk& chunk = *message.mutable_faces();
  chunk.set_first_face(next_face_);
  next_face_ = FillChunk(
      mesh.face_count(), next_face_,
      [&](uint64_t face) -> const Triangle& { return mesh.triangle(face); },
      *chunk.mutable_indices());
  entry().add_bytes(chunk.indices().size());
  // A mesh has at least one face.
  return next_face_ < mesh.face_count() ? NextMessage::kSend
                                        : NextMessage::kSendLast;
}

}  // namespace geodesic::server
