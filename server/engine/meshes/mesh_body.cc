#include "server/engine/meshes/mesh_body.h"

#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include "server/engine/base/binary_codec.h"
#include "server/engine/meshes/mesh_digest.h"

namespace geodesic::server {
namespace {

// A cancelled read stops within this many bytes, about 10 ms.
constexpr size_t kPieceBytes = size_t{8} << 20;

template <typename T>
absl::Status ReadArray(BlobBody& body, Checkpoint& checkpoint,
                       std::vector<T>& values) {
  std::span<char> bytes = AsWritableBytes(values);
  while (!bytes.empty()) {
    const size_t count = std::min(bytes.size(), kPieceBytes);
    absl::Status status = checkpoint.Poll({});
    if (status.ok()) status = body.Read(bytes.first(count));
    if (!status.ok()) return status;
    bytes = bytes.subspan(count);
  }
  return absl::OkStatus();
}

constexpr uint64_t kTailBytes = 4 * sizeof(uint64_t);

// What was joined, behind the arrays.
absl::Status ReadTail(BlobBody& body, Checkpoint& checkpoint,
                      TriangleSoup& soup) {
  std::vector<uint64_t> numbers(4);
  absl::Status status = ReadArray(body, checkpoint, numbers);
  if (!status.ok()) return status;
  Reading& reading = soup.reading;
  reading.seam_edges = numbers[0];
  reading.crossing_polygons = numbers[1];
  reading.first_crossing_polygon = numbers[2];
  if (body.bytes_left() / sizeof(JoinedVertex) != numbers[3] ||
      body.bytes_left() % sizeof(JoinedVertex) != 0) {
    return absl::DataLossError("the joined vertices are not as many as named");
  }
  reading.joined.resize(numbers[3]);
  return ReadArray(body, checkpoint, reading.joined);
}

}  // namespace

uint64_t MeshBodyBytes(uint64_t vertices, uint64_t faces) {
  return MeshDigestHead(vertices, faces).size() + vertices * sizeof(Point) +
         faces * sizeof(Triangle);
}

uint64_t MeshBodyBytes(const Mesh& mesh) {
  return MeshBodyBytes(mesh.vertex_count(), mesh.face_count()) +
         MeshDigestTail(mesh.reading()).size() +
         mesh.reading().joined.size() * sizeof(JoinedVertex);
}

bool IsMeshBodySize(uint64_t bytes, uint64_t vertices, uint64_t faces) {
  const uint64_t plain = MeshBodyBytes(vertices, faces);
  return bytes == plain ||
         (bytes >= plain + kTailBytes &&
          bytes <= plain + kTailBytes + vertices * sizeof(JoinedVertex));
}

absl::Status WriteMeshBody(
    const Mesh& mesh,
    absl::FunctionRef<absl::Status(std::string_view bytes)> append) {
  absl::Status status =
      append(MeshDigestHead(mesh.vertex_count(), mesh.face_count()));
  if (status.ok()) status = append(AsBytes(mesh.positions()));
  // Mesh stores its faces in another order.
  constexpr uint32_t kPiece = 64 << 10;
  std::vector<Triangle> piece;
  for (uint32_t face = 0; status.ok() && face < mesh.face_count();) {
    piece.clear();
    for (; face < mesh.face_count() && piece.size() < kPiece; ++face) {
      piece.push_back(mesh.NamedTriangle(face));
    }
    status = append(AsBytes(piece));
  }
  const Reading& reading = mesh.reading();
  if (reading.is_plain() || !status.ok()) return status;
  status = append(MeshDigestTail(reading));
  return status.ok() ? append(AsBytes(reading.joined)) : status;
}

absl::StatusOr<TriangleSoup> ReadMeshBody(BlobBody& body, uint64_t vertices,
                                          uint64_t faces,
                                          Checkpoint& checkpoint) {
  const std::string expected = MeshDigestHead(vertices, faces);
  if (!IsMeshBodySize(body.bytes_left(), vertices, faces)) {
    return absl::DataLossError("the body has not the size of the mesh");
  }
  // The head holds the counts, which the digest covers.
  std::string head(expected.size(), '\0');
  absl::Status status = body.Read(head);
  if (!status.ok()) return status;
  if (head != expected) {
    return absl::DataLossError("the counts are not those of the mesh");
  }
  TriangleSoup soup;
  soup.positions.resize(vertices);
  soup.triangles.resize(faces);
  status = ReadArray(body, checkpoint, soup.positions);
  if (status.ok()) status = ReadArray(body, checkpoint, soup.triangles);
  if (status.ok() && body.bytes_left() > 0) {
    status = ReadTail(body, checkpoint, soup);
  }
  if (!status.ok()) return status;
  return soup;
}

}  // namespace geodesic::server
