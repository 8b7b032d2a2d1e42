// libFuzzer target of a mesh reader, that of the format FUZZED_FORMAT: reads
// the bytes and aborts if the reader breaks a promise of read_mesh.h. What was
// read is then built into a Mesh, which must not crash either.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string_view>
#include <utility>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/mesh.h"
#include "geodesic/read_mesh.h"

namespace geodesic {
namespace {

// Memory may grow with the bytes read: 24 bytes for a vertex of three bytes,
// 12 for a corner of one, and twice that where arrays grow by doubling.
constexpr size_t kMostBytesPerByte = 32;
// What zlib makes of a byte, where a format has arrays that it compresses.
constexpr size_t kMostInflation = 1032;

void Require(bool promise) {
  if (!promise) std::abort();
}

void RequireSound(const TriangleSoup& soup, size_t size, MeshFormat format) {
  for (const Point& point : soup.positions) {
    for (const double coordinate : point) Require(std::isfinite(coordinate));
  }
  for (const Triangle& triangle : soup.triangles) {
    for (const uint32_t vertex : triangle) {
      Require(vertex < soup.positions.size());
    }
  }
  Require(soup.positions.capacity() * sizeof(Point) +
              soup.triangles.capacity() * sizeof(Triangle) <=
          (format == MeshFormat::kVtp ? kMostInflation : 1) *
              kMostBytesPerByte * size);
}

void CheckReader(const uint8_t* data, size_t size, MeshFormat format) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  absl::StatusOr<TriangleSoup> soup = ReadMesh(bytes, format);
  if (!soup.ok()) {
    Require(absl::IsInvalidArgument(soup.status()));
    Require(!soup.status().message().empty());
    return;
  }
  RequireSound(*soup, size, format);
  const absl::StatusOr<std::shared_ptr<const Mesh>> mesh =
      Mesh::Build(*std::move(soup));
  Require(mesh.ok() || absl::IsInvalidArgument(mesh.status()));
}

}  // namespace
}  // namespace geodesic

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  geodesic::CheckReader(data, size, geodesic::MeshFormat::FUZZED_FORMAT);
  return 0;
}
