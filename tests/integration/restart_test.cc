// What a server with --data-dir still has when it comes back.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "geodesic_client/client.h"
#include "tests/integration/meshes.h"
#include "tests/integration/running_server.h"

namespace geodesic::client {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;

class RestartTest : public ::testing::Test {
 protected:
  void SetUp() override { Start(); }

  void Start(std::vector<std::string> flags = {}) {
    flags.insert(flags.end(), {"--data-dir", data_dir()});
    server_.emplace(folder_, flags);
    client_.emplace(server_->address());
  }
  int Stop() {
    client_.reset();
    server_->Terminate();
    return server_->Wait();
  }

  // The distances from a vertex of a planar grid are Euclid's.
  void ExpectEuclid(const MeshArrays& mesh) {
    const absl::StatusOr<Field> field = client_->ComputeField(
        {.mesh_digest = MeshDigest(mesh), .sources = {{VertexPoint{0}}}});
    ASSERT_TRUE(field.ok()) << field.status();
    for (size_t v = 0; v < mesh.positions.size(); ++v) {
      const Point& p = mesh.positions[v];
      ASSERT_NEAR(field->distances[v], std::hypot(p[0], p[1]), 1e-10);
    }
  }

  std::string data_dir() const { return folder_ / "data"; }

  TemporaryFolder folder_;
  std::optional<RunningServer> server_;
  std::optional<Client> client_;
};

// Eight clients ask for twelve meshes where four have room: whoever finds no
// memory waits for the questions that run, and nobody is refused.
TEST_F(RestartTest, MeshesTakeTurnsInMemory) {
  constexpr uint32_t kMeshes = 12, kClients = 8, kQuestions = 15;
  std::vector<std::string> digests;
  uint64_t largest = 0;
  for (uint32_t i = 0; i < kMeshes; ++i) {
    const MeshArrays mesh = PlanarGrid(60 + i);
    ASSERT_TRUE(client_->UploadArrays(mesh).ok());
    digests.push_back(MeshDigest(mesh));
    const auto info = client_->GetMesh(digests.back());
    ASSERT_TRUE(info.ok()) << info.status();
    largest = std::max(largest, info->resident_bytes);
  }
  EXPECT_EQ(Stop(), 0);
  Start({"--mesh-store", std::to_string(4 * largest) + "B"});
  std::vector<std::thread> threads;
  std::atomic<uint32_t> refused = 0;
  for (uint32_t c = 0; c < kClients; ++c) {
    threads.emplace_back([&, c] {
      Client client(server_->address(), {.retry = false});
      for (uint32_t i = 0; i < kQuestions; ++i) {
        const auto field = client.ComputeField(
            {.mesh_digest = digests[(5 * c + 7 * i) % kMeshes],
             .sources = {{VertexPoint{i * kClients + c}}}});
        if (field.ok()) continue;
        ++refused;
        ADD_FAILURE() << field.status();
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(refused, 0);
}

TEST_F(RestartTest, MeshesAndFieldsAreThere) {
  const MeshArrays mesh = PlanarGrid(20);
  WriteFile(folder_ / "hills.off", OffText(HillyGrid(10)));
  ASSERT_TRUE(client_->UploadArrays(mesh).ok());
  ASSERT_TRUE(client_->UploadFile(folder_ / "hills.off").ok());
  ExpectEuclid(mesh);
  EXPECT_EQ(Stop(), 0);

  Start();
  const auto meshes = client_->ListMeshes();
  ASSERT_TRUE(meshes.ok()) << meshes.status();
  ASSERT_THAT(*meshes, SizeIs(2));
  for (const MeshInfo& info : *meshes) {
    EXPECT_EQ(info.resident_bytes, 0);
    EXPECT_GT(info.stored_bytes, 0);
    EXPECT_GT(info.face_count, 0);
  }
  // The file is not sent again, and the field not computed.
  const auto again = client_->UploadFile(folder_ / "hills.off");
  ASSERT_TRUE(again.ok()) << again.status();
  EXPECT_TRUE(again->already_resident);
  EXPECT_EQ(again->bytes_sent, 0);
  const auto field = client_->ComputeField(
      {.mesh_digest = MeshDigest(mesh), .sources = {{VertexPoint{0}}}});
  ASSERT_TRUE(field.ok()) << field.status();
  EXPECT_EQ(field->origin, FieldOrigin::kCached);
  ExpectEuclid(mesh);
  EXPECT_GT(client_->GetMesh(MeshDigest(mesh))->resident_bytes, 0);
}

TEST_F(RestartTest, KilledServersToo) {
  const MeshArrays kept = PlanarGrid(20);
  const MeshArrays deleted = PlanarGrid(10);
  ASSERT_TRUE(client_->UploadArrays(kept).ok());
  ASSERT_TRUE(client_->UploadArrays(deleted).ok());
  ASSERT_TRUE(client_->DeleteMesh(MeshDigest(deleted)).ok());
  client_.reset();
  server_->Kill();
  Start();
  EXPECT_TRUE(
      absl::IsNotFound(client_->ReadMesh(MeshDigest(deleted)).status()));
  const auto read = client_->ReadMesh(MeshDigest(kept));
  ASSERT_TRUE(read.ok()) << read.status();
  EXPECT_EQ(read->positions, kept.positions);
  EXPECT_EQ(read->triangles, kept.triangles);
  ExpectEuclid(kept);
}

// Every question brings the mesh it is about back from the disk.
TEST_F(RestartTest, AnyQuestionFindsItsMesh) {
  const MeshArrays mesh = PlanarGrid(6);
  const std::string digest = MeshDigest(mesh);
  ASSERT_TRUE(client_->UploadArrays(mesh).ok());
  const VertexPoint from{0};
  const VertexPoint to{48};
  const auto expect_found = [&](const auto& ask) {
    Stop();
    Start();
    EXPECT_EQ(client_->GetMesh(digest)->resident_bytes, 0);
    const absl::Status status = ask().status();
    EXPECT_TRUE(status.ok()) << status;
    EXPECT_GT(client_->GetMesh(digest)->resident_bytes, 0);
  };
  expect_found([&] {
    return client_->ComputePaths(
        {.mesh_digest = digest, .sources = {{from}}, .targets = {to}});
  });
  expect_found([&] {
    return client_->ComputeIsolines(
        {.mesh_digest = digest, .sources = {{from}}, .levels = {0.5}});
  });
  expect_found([&] {
    return client_->FindNearest({.mesh_digest = digest,
                                 .sources = {{from}},
                                 .targets = {to},
                                 .count = 1});
  });
  expect_found([&] {
    return client_->SampleFarthestPoints(
        {.mesh_digest = digest, .sources = {{from}}, .count = 2});
  });
  expect_found([&] {
    return client_->ComputeLogMap({.mesh_digest = digest, .source = from});
  });
  expect_found([&] { return client_->ReadMesh(digest); });
}

TEST_F(RestartTest, AFolderHasOneServer) {
  const ProcessResult second = RunProgram(
      {GEODESICD_BINARY, "--listen", "127.0.0.1:0", "--data-dir", data_dir()});
  EXPECT_EQ(second.exit_code, 1);
  EXPECT_THAT(second.err, HasSubstr("in use by process"));
  EXPECT_TRUE(client_->ListMeshes().ok());
}

}  // namespace
}  // namespace geodesic::client
