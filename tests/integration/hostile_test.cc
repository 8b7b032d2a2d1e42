// Files nobody should have to read, and the server that reads them.

#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "geodesic_client/client.h"
#include "tests/integration/running_server.h"
#include "tests/support/test_meshes.h"

namespace geodesic::client {
namespace {

using nlohmann::json;

std::filesystem::path HostileFolder() {
  return test::TestMeshFolder() / "hostile";
}

class HostileTest : public IntegrationTest {
 protected:
  // Uploads a file; the server must say yes or name what is wrong, and go on.
  // The digest, or nothing if it was refused.
  std::string Upload(const std::string& path) {
    const ProcessResult result = Geodesic({"upload", path, "--json"});
    const json answer = json::parse(result.out, nullptr, false);
    EXPECT_FALSE(answer.is_discarded()) << path << ": " << result.out;
    if (result.exit_code == 0) return answer["mesh"]["digest"];
    EXPECT_TRUE(result.exit_code == 5 || result.exit_code == 3)
        << path << ": " << result.exit_code << " " << result.err;
    if (result.exit_code == 5) {
      EXPECT_EQ(answer["error"]["code"], "INVALID_ARGUMENT") << path;
      EXPECT_NE(answer["error"]["message"], "") << path;
    }
    return "";
  }

  void ExpectAlive(const std::string& after) {
    absl::StatusOr<Capabilities> capabilities = client_.GetCapabilities();
    ASSERT_TRUE(capabilities.ok()) << after << ": " << capabilities.status();
  }

  Client client_{server_.address()};
};

TEST_F(HostileTest, GeneratedFiles) {
  const std::vector<std::pair<std::string, std::string>> files = {
      {"empty.obj", ""},
      {"empty.ply", ""},
      {"bomb.off", "OFF\n9223372036854775808 1 0\n"},
      {"bomb.ply",
       "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\n"
       "property double x\nproperty double y\nproperty double z\n"
       "element face 4000000000\nproperty list uchar int vertex_indices\n"
       "end_header\n"},
      {"noise.stl", std::string(1000, '\xff')},
      {"nan.obj", "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"},
      {"range.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n"}};
  for (const auto& [name, bytes] : files) {
    WriteFile(folder_ / name, bytes);
    EXPECT_EQ(Upload(folder_ / name), "") << name;
    ExpectAlive(name);
  }
}

TEST_F(HostileTest, EveryFileOfTheFolder) {
  if (!std::filesystem::is_directory(HostileFolder())) {
    GTEST_SKIP() << "no " << HostileFolder();
  }
  std::set<std::string> paths;
  for (const auto& entry :
       std::filesystem::directory_iterator(HostileFolder())) {
    paths.insert(entry.path().string());
  }
  size_t accepted = 0;
  for (const std::string& path : paths) {
    const std::string digest = Upload(path);
    ExpectAlive(path);
    if (digest.empty()) continue;
    ++accepted;
    // What loads can also be solved.
    absl::StatusOr<Field> field = client_.ComputeField(
        {.mesh_digest = digest, .sources = {{VertexPoint{0}}}});
    ASSERT_TRUE(field.ok()) << path << ": " << field.status();
    ASSERT_FALSE(field->distances.empty()) << path;
    EXPECT_EQ(field->distances[0], 0) << path;
  }
  // Some files are merely odd, others are broken.
  EXPECT_GT(accepted, paths.size() / 4);
  EXPECT_LT(accepted, paths.size());
  EXPECT_EQ(Geodesic({"capabilities"}).exit_code, 0);
}

}  // namespace
}  // namespace geodesic::client
