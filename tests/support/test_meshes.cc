#include "tests/support/test_meshes.h"

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>

#include "absl/status/status.h"
#include "geodesic/read_mesh.h"

namespace geodesic::test {

std::filesystem::path TestMeshFolder() {
  const char* folder = std::getenv("GEODESIC_TEST_MESHES");
  return folder != nullptr ? folder : GEODESIC_DEFAULT_TEST_MESHES;
}

absl::StatusOr<TriangleSoup> LoadTestMesh(std::string_view name) {
  const std::filesystem::path path = TestMeshFolder() / name;
  std::ifstream file(path, std::ios::binary);
  if (!file) return absl::NotFoundError("no test mesh " + path.string());
  std::ostringstream bytes;
  bytes << file.rdbuf();
  const absl::StatusOr<MeshFormat> format = MeshFormatFromPath(name);
  if (!format.ok()) return format.status();
  return ReadMesh(bytes.view(), *format);
}

}  // namespace geodesic::test
