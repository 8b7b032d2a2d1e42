#include "tests/support/meshes/test_meshes.h"

#include <cstdlib>
#include <string>

#include "absl/status/status.h"
#include "geodesic/read_mesh.h"
#include "tests/support/temporary_folder.h"

namespace geodesic::test {

std::filesystem::path TestMeshFolder() {
  const char* folder = std::getenv("GEODESIC_TEST_MESHES");
  return folder != nullptr ? folder : GEODESIC_DEFAULT_TEST_MESHES;
}

absl::StatusOr<TriangleSoup> LoadTestMesh(std::string_view name) {
  const std::filesystem::path path = TestMeshFolder() / name;
  if (!std::filesystem::exists(path)) {
    return absl::NotFoundError("no test mesh " + path.string());
  }
  const absl::StatusOr<MeshFormat> format = MeshFormatFromPath(name);
  if (!format.ok()) return format.status();
  return ReadMesh(FileBytes(path), *format);
}

}  // namespace geodesic::test
