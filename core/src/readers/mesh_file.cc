#include "geodesic/mesh_file.h"

#include <cerrno>
#include <cstdio>
#include <utility>

#include "absl/status/status.h"
#include "absl/strings/str_cat.h"
#include "geodesic/checkpoint.h"

namespace geodesic {
namespace {

constexpr size_t kBlockBytes = 1 << 20;
// More than the largest mesh takes in any format.
constexpr uint64_t kMostGzipBytes = uint64_t{1} << 40;

absl::StatusOr<std::string> ReadBytes(const std::string& path) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(
      std::fopen(path.c_str(), "rb"), &std::fclose);
  std::string bytes;
  // Reading a folder is refused here, opening it is not.
  while (file != nullptr && !std::feof(file.get()) &&
         !std::ferror(file.get())) {
    const size_t before = bytes.size();
    bytes.resize(before + kBlockBytes);
    bytes.resize(before +
                 std::fread(&bytes[before], 1, kBlockBytes, file.get()));
  }
  if (file == nullptr || std::ferror(file.get())) {
    return absl::ErrnoToStatus(errno, absl::StrCat("cannot read '", path, "'"));
  }
  return bytes;
}

absl::StatusOr<std::shared_ptr<const Mesh>> ParseAndBuild(
    const std::string& bytes, MeshFormat format, const ReadLimits& limits) {
  ReadLimits with_gzip = limits;
  if (with_gzip.max_gzip_bytes == 0) with_gzip.max_gzip_bytes = kMostGzipBytes;
  absl::StatusOr<TriangleSoup> soup = ReadMesh(bytes, format, with_gzip);
  if (!soup.ok()) return soup.status();
  NoCheckpoint goes_on;
  return Mesh::Build(*std::move(soup),
                     limits.checkpoint ? *limits.checkpoint : goes_on);
}

}  // namespace

absl::StatusOr<std::shared_ptr<const Mesh>> ReadMeshFile(
    const std::string& path, const ReadLimits& limits) {
  const absl::StatusOr<MeshFormat> format = MeshFormatFromPath(path);
  if (!format.ok()) return format.status();
  const absl::StatusOr<std::string> bytes = ReadBytes(path);
  if (!bytes.ok()) return bytes.status();
  absl::StatusOr<std::shared_ptr<const Mesh>> mesh =
      ParseAndBuild(*bytes, *format, limits);
  if (mesh.ok()) return mesh;
  return absl::Status(mesh.status().code(),
                      absl::StrCat(path, ": ", mesh.status().message()));
}

}  // namespace geodesic
