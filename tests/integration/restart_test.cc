// What a server with --data-dir still has when it comes back.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
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

  std::string data_dir() const { return folder_ / "data"; }

  TemporaryFolder folder_;
  std::optional<RunningServer> server_;
  std::optional<Client> client_;
};

// Eight clients ask for twelve meshes where four have room: whoever finds no
// memory waits for the questions that run, and nobody is refused for good. What
// has just ended may hold its mesh for a moment, when none runs to be waited
// for.
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
  Start({"--limit", "mesh-store=" + std::to_string(4 * largest) + "B"});
  std::vector<std::thread> threads;
  std::atomic<uint32_t> refused = 0;
  for (uint32_t c = 0; c < kClients; ++c) {
    threads.emplace_back([&, c] {
      Client client(server_->address());
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
