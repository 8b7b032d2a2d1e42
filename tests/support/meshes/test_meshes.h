// Meshes that lie outside the project and are tested when present.

#ifndef GEODESIC_TESTS_SUPPORT_MESHES_TEST_MESHES_H_
#define GEODESIC_TESTS_SUPPORT_MESHES_TEST_MESHES_H_

#include <filesystem>
#include <string_view>

#include "absl/status/statusor.h"
#include "geodesic/triangle_soup.h"

namespace geodesic::test {

// The folder the environment variable GEODESIC_TEST_MESHES names, by default
// shared/meshes beside the project. It need not exist.
std::filesystem::path TestMeshFolder();

// Reads a file of that folder, such as "real/bunny.obj".
// Errors: NOT_FOUND if there is no such file; as ReadMesh.
absl::StatusOr<TriangleSoup> LoadTestMesh(std::string_view name);

}  // namespace geodesic::test

#endif  // GEODESIC_TESTS_SUPPORT_MESHES_TEST_MESHES_H_
