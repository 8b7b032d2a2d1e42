// The client library against the real server.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <thread>

#include "geodesic_client/client.h"
#include "tests/integration/meshes.h"
#include "tests/integration/running_server.h"

namespace geodesic::client {
namespace {

class LibraryTest : public IntegrationTest {
 protected:
  Client client_{server_.address()};
};

TEST_F(LibraryTest, UploadsTellOfTheirProgress) {
  const MeshArrays mesh = HillyGrid(30);
  uint64_t last_sent = 0;
  absl::StatusOr<UploadOutcome> upload =
      client_.UploadArrays(mesh, {}, [&](uint64_t sent, uint64_t total) {
        EXPECT_GT(sent, last_sent);
        EXPECT_LE(sent, total);
        last_sent = sent;
      });
  ASSERT_TRUE(upload.ok()) << upload.status();
  EXPECT_EQ(upload->mesh.digest, MeshDigest(mesh));
  EXPECT_EQ(upload->bytes_sent,
            24 * mesh.positions.size() + 12 * mesh.triangles.size());
  EXPECT_EQ(last_sent, upload->bytes_sent);
  // What is there is not sent.
  const absl::StatusOr<UploadOutcome> again = client_.UploadArrays(mesh);
  ASSERT_TRUE(again.ok()) << again.status();
  EXPECT_TRUE(again->already_resident);
  EXPECT_EQ(again->bytes_sent, 0);
}

TEST_F(LibraryTest, AMeshThatIsForgottenIsUploadedAgain) {
  WriteFile(folder_ / "grid.off", OffText(PlanarGrid(4)));
  int asked = 0;
  const absl::StatusOr<Field> field = AskAboutFile(
      client_, folder_ / "grid.off", [&](const std::string& digest) {
        // As if it had been evicted.
        if (++asked == 1) {
          EXPECT_TRUE(client_.DeleteMesh(digest).ok());
        }
        return client_.ComputeField(
            {.mesh_digest = digest, .sources = {{VertexPoint{0}}}});
      });
  EXPECT_TRUE(field.ok()) << field.status();
  EXPECT_EQ(asked, 2);
}

TEST_F(LibraryTest, OtherErrorsAreNotAskedForTwice) {
  WriteFile(folder_ / "grid.off", OffText(PlanarGrid(4)));
  int asked = 0;
  const absl::StatusOr<Field> field = AskAboutFile(
      client_, folder_ / "grid.off", [&](const std::string& digest) {
        ++asked;
        return client_.ComputeField(
            {.mesh_digest = digest, .sources = {{VertexPoint{25}}}});
      });
  EXPECT_TRUE(absl::IsInvalidArgument(field.status()));
  EXPECT_EQ(ErrorReason(field.status()), "INVALID_REQUEST");
  EXPECT_EQ(asked, 1);
}

TEST_F(LibraryTest, MeshesOfSeveralChunksComeBackAsTheyWent) {
  // 300 x 300: 2.2 MB of vertices and 2.2 MB of faces.
  const MeshArrays mesh = HillyGrid(300);
  absl::StatusOr<UploadOutcome> upload = client_.UploadArrays(mesh);
  ASSERT_TRUE(upload.ok()) << upload.status();
  EXPECT_EQ(upload->mesh.digest, MeshDigest(mesh));
  // The same mesh as a file of many chunks.
  WriteFile(folder_ / "mesh.off", OffText(mesh));
  absl::StatusOr<UploadOutcome> file = client_.UploadFile(folder_ / "mesh.off");
  ASSERT_TRUE(file.ok()) << file.status();
  EXPECT_EQ(file->mesh.digest, upload->mesh.digest);
  EXPECT_TRUE(file->already_resident);
  absl::StatusOr<MeshArrays> read = client_.ReadMesh(upload->mesh.digest);
  ASSERT_TRUE(read.ok()) << read.status();
  EXPECT_EQ(read->positions, mesh.positions);
  EXPECT_EQ(read->triangles, mesh.triangles);
}

TEST_F(LibraryTest, ListsMoreMeshesThanAPageHolds) {
  constexpr size_t kCount = 1003;  // A page holds a thousand.
  for (size_t i = 1; i <= kCount; ++i) {
    const auto x = static_cast<double>(i);
    absl::StatusOr<UploadOutcome> upload =
        client_.UploadArrays({{{0, 0, 0}, {x, 0, 0}, {0, x, 0}}, {{0, 1, 2}}});
    ASSERT_TRUE(upload.ok()) << upload.status();
  }
  absl::StatusOr<std::vector<MeshInfo>> meshes = client_.ListMeshes();
  ASSERT_TRUE(meshes.ok()) << meshes.status();
  ASSERT_EQ(meshes->size(), kCount);
  for (size_t i = 1; i < kCount; ++i) {
    EXPECT_LT(meshes->at(i - 1).digest, meshes->at(i).digest);
  }
}

TEST_F(LibraryTest, LocalFilesThatCannotBeReadAreNamed) {
  absl::Status missing = client_.UploadFile(folder_ / "no.off").status();
  EXPECT_TRUE(absl::IsNotFound(missing)) << missing;
  EXPECT_NE(missing.message().find("no.off"), absl::string_view::npos);
  WriteFile(folder_ / "m.xyz", "");
  EXPECT_TRUE(
      absl::IsInvalidArgument(client_.UploadFile(folder_ / "m.xyz").status()));
}

TEST_F(LibraryTest, TheAlgorithmThatIsNamedAnswers) {
  const MeshArrays mesh = HillyGrid(8);
  ASSERT_TRUE(client_.UploadArrays(mesh).ok());
  const absl::StatusOr<Capabilities> server = client_.GetCapabilities();
  ASSERT_EQ(server->algorithms.size(), 8);
  for (const AlgorithmCapability& algorithm : server->algorithms) {
    const absl::StatusOr<Field> field =
        client_.ComputeField({.mesh_digest = MeshDigest(mesh),
                              .sources = {{VertexPoint{0}}},
                              .algorithm = algorithm.name});
    ASSERT_TRUE(field.ok()) << field.status();
    EXPECT_EQ(field->algorithm, algorithm.name);
  }
}

TEST_F(LibraryTest, ThreadsShareAClient) {
  const MeshArrays mesh = PlanarGrid(24);
  ASSERT_TRUE(client_.UploadArrays(mesh).ok());
  const std::string digest = MeshDigest(mesh);
  std::vector<std::thread> threads;
  for (uint32_t source = 0; source < 8; ++source) {
    threads.emplace_back([&, source] {
      for (int repeat = 0; repeat < 10; ++repeat) {
        absl::StatusOr<Field> field = client_.ComputeField(
            {.mesh_digest = digest, .sources = {{VertexPoint{source}}}});
        ASSERT_TRUE(field.ok()) << field.status();
        const Point& from = mesh.positions[source];
        for (size_t v = 0; v < mesh.positions.size(); ++v) {
          const Point& to = mesh.positions[v];
          ASSERT_NEAR(field->distances[v],
                      std::hypot(from[0] - to[0], from[1] - to[1]), 1e-10);
        }
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
}

}  // namespace
}  // namespace geodesic::client
