#include "bench/load_mesh.h"

#include <fstream>
#include <iterator>
#include <utility>

#include "absl/status/status.h"
#include "geodesic/read_mesh.h"

namespace geodesic {

absl::StatusOr<std::shared_ptr<const Mesh>> LoadMesh(const std::string& path) {
  absl::StatusOr<MeshFormat> format = MeshFormatFromPath(path);
  if (!format.ok()) return format.status();
  std::ifstream file(path, std::ios::binary);
  if (!file) return absl::NotFoundError("cannot open " + path);
  const std::string bytes(std::istreambuf_iterator<char>(file), {});
  absl::StatusOr<TriangleSoup> soup = ReadMesh(bytes, *format);
  if (!soup.ok()) return soup.status();
  return Mesh::Build(*std::move(soup));
}

}  // namespace geodesic
