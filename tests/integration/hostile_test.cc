// Files nobody should have to read, and the server that reads them.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "geodesic_client/client.h"
#include "tests/integration/running_server.h"
#include "tests/support/meshes/test_meshes.h"

namespace geodesic::client {
namespace {

using nlohmann::json;

std::filesystem::path HostileFolder() {
  return test::TestMeshFolder() / "hostile";
}

using HostileTest = IntegrationTest;

// The server says yes or names what is wrong, and goes on.
TEST_F(HostileTest, EveryFileOfTheFolder) {
  if (!std::filesystem::is_directory(HostileFolder())) {
    GTEST_SKIP() << "no " << HostileFolder();
  }
  Client client(server_.address());
  size_t accepted = 0;
  size_t refused = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(HostileFolder())) {
    SCOPED_TRACE(entry.path());
    const ProcessResult result =
        Geodesic({"upload", entry.path().string(), "--json"});
    const json answer = json::parse(result.out, nullptr, false);
    ASSERT_FALSE(answer.is_discarded()) << result.out;
    const absl::StatusOr<Capabilities> capabilities = client.GetCapabilities();
    ASSERT_TRUE(capabilities.ok()) << capabilities.status();
    if (result.exit_code != 0) {
      ++refused;
      EXPECT_TRUE(result.exit_code == 5 || result.exit_code == 3)
          << result.exit_code << " " << result.err;
      if (result.exit_code == 3) continue;
      EXPECT_EQ(answer["error"]["code"], "INVALID_ARGUMENT");
      EXPECT_NE(answer["error"]["message"], "");
      continue;
    }
    ++accepted;
    // What loads can also be solved.
    const absl::StatusOr<Field> field = client.ComputeField(
        {.mesh_digest = answer["mesh"]["digest"].get<std::string>(),
         .sources = {{VertexPoint{0}}}});
    ASSERT_TRUE(field.ok()) << field.status();
    ASSERT_FALSE(field->distances.empty());
    EXPECT_EQ(field->distances[0], 0);
  }
  // Some files are merely odd, others are broken.
  EXPECT_GT(accepted, refused / 3);
  EXPECT_GT(refused, 0);
}

}  // namespace
}  // namespace geodesic::client
