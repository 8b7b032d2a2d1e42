// Requests for meshes that are on disk and not in memory.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>

#include "tests/engine/uploads.h"
#include "tests/rpc/rpc_fixture.h"
#include "tests/support/meshes/curved_meshes.h"
#include "tests/support/temporary_folder.h"

namespace geodesic::server {
namespace {

constexpr std::chrono::milliseconds kLong = std::chrono::minutes(1);

class StoredMeshTest : public test::RpcTest {
 protected:
  ~StoredMeshTest() override {
    // Before the folder goes.
    solver_.LetGo();
    server_.reset();
  }

  // One thread, and a queue for whoever comes.
  ServerOptions OneThread() const {
    ServerOptions options = SmallServer();
    options.data_dir = temporary_ / "data";
    options.limits.max_concurrent_jobs = 1;
    options.limits.max_queued_jobs = 10;
    options.limits.mesh_disk_bytes = uint64_t{64} << 20;
    options.limits.field_disk_bytes = uint64_t{64} << 20;
    return options;
  }

  // Two meshes on disk, and a field of the second; nothing is in memory. The
  // only thread is held by a computation on the first, whose stream is open.
  void StartBusy() {
    Start(OneThread());
    first_ = Upload(geodesic::test::Icosphere(1));
    second_ = Upload(geodesic::test::Icosphere(2));
    ASSERT_TRUE(Ask(second_, 0).status.ok());
    // A field is written when nothing else is to do.
    ASSERT_TRUE(server_->engine().scheduler().WaitIdle(kLong));
    server_.reset();
    Start(OneThread(), /*held=*/true);
    busy_ = Open(first_, 0);
    solver_.WaitForStarts(1);
  }

  void EndBusy() {
    solver_.LetGo();
    EXPECT_TRUE(busy_->End().ok());
  }

  // The server knows of it a little later than the client.
  void WaitForLoads(size_t count) {
    while (server_->engine().meshes().loads().size() != count) {
      std::this_thread::yield();
    }
  }

  geodesic::test::TemporaryFolder temporary_;
  std::string first_;
  std::string second_;
  std::unique_ptr<test::OpenCall> busy_;
};

TEST_F(StoredMeshTest, AMeshWhoseFileWasRemovedIsWrittenAgain) {
  Start(OneThread());
  const TriangleSoup tetrahedron = test::Tetrahedron();
  const std::string digest = Upload(tetrahedron);
  const std::filesystem::path file =
      std::filesystem::path(temporary_ / "data") / "meshes" /
      (digest + ".mesh");
  ASSERT_TRUE(std::filesystem::remove(file));
  EXPECT_EQ(Upload(tetrahedron), digest);
  EXPECT_TRUE(std::filesystem::exists(file));
  // And one that was cut.
  std::filesystem::resize_file(file, 100);
  EXPECT_EQ(Upload(tetrahedron), digest);
  EXPECT_GT(std::filesystem::file_size(file), 100u);
  // As a file, which the server knows without reading it.
  const std::string off = test::kTetrahedronOff;
  v1::UploadHeader header;
  header.set_format(v1::MESH_FORMAT_OFF);
  header.set_size_bytes(off.size());
  v1::CreateMeshResponse response;
  for (const bool is_known : {true, false, true}) {
    if (!is_known) {
      ASSERT_TRUE(std::filesystem::remove(file));
    }
    ASSERT_TRUE(Upload(header, off, response).ok());
    EXPECT_EQ(response.mesh().digest(), digest);
    EXPECT_GT(response.mesh().stored_bytes(), 0u);
    EXPECT_TRUE(std::filesystem::exists(file));
  }
  server_.reset();
  Start(OneThread());
  EXPECT_TRUE(Ask(digest, 0).status.ok());
}

TEST_F(StoredMeshTest, UploadsSayThatTheDataFolderIsGone) {
  Start(OneThread());
  const std::string first = Upload(geodesic::test::Icosphere(1));
  std::filesystem::remove_all(temporary_ / "data");
  const TriangleSoup sphere = geodesic::test::Icosphere(2);
  v1::CreateMeshResponse response;
  const grpc::Status status = RpcTest::Upload(
      test::ArraysHeader(sphere), test::ArrayBytes(sphere), response);
  EXPECT_EQ(status.error_code(), grpc::StatusCode::UNAVAILABLE);
  EXPECT_THAT(status.error_message(),
              ::testing::HasSubstr("its data folder has been removed"));
  // What is in memory answers.
  EXPECT_TRUE(Ask(first, 0).status.ok());
}

TEST_F(StoredMeshTest, AQuestionWaitsForItsMesh) {
  StartBusy();
  const auto call = Open(second_, 0);
  WaitForLoads(1);
  EndBusy();
  ASSERT_TRUE(call->Read());
  EXPECT_EQ(call->message.header().mesh_digest(), second_);
  EXPECT_EQ(call->message.header().origin(), v1::ANSWER_ORIGIN_CACHED);
  EXPECT_TRUE(call->End().ok());
  EXPECT_EQ(server_->engine().counters().meshes_loaded, 2);
}

// Its mesh is in memory, so that loading it would not help.
TEST_F(StoredMeshTest, AnAnswerThatIsNotKeptIsNotFound) {
  Start(OneThread());
  v1::ComputeFieldRequest request =
      FieldRequest(Upload(geodesic::test::Icosphere(1)), 0);
  request.mutable_resumption()->set_answer_id(std::string(64, 'a'));
  const grpc::Status status = Ask(request).status;
  EXPECT_EQ(status.error_code(), grpc::StatusCode::NOT_FOUND);
  EXPECT_EQ(test::Reason(status), "ANSWER_NOT_KEPT");
}

TEST_F(StoredMeshTest, WhoCancelsWaitsNoLonger) {
  StartBusy();
  const auto call = Open(second_, 0);
  WaitForLoads(1);
  call->context.TryCancel();
  EXPECT_EQ(call->End().error_code(), grpc::StatusCode::CANCELLED);
  WaitForLoads(0);
  EndBusy();
  EXPECT_TRUE(server_->engine().scheduler().WaitIdle(kLong));
  EXPECT_EQ(server_->engine().counters().meshes_loaded, 1);
}

TEST_F(StoredMeshTest, ADeadlineEndsTheWait) {
  StartBusy();
  grpc::ClientContext context;
  context.set_deadline(std::chrono::system_clock::now() +
                       std::chrono::milliseconds(200));
  EXPECT_EQ(Ask(FieldRequest(second_, 0), context).status.error_code(),
            grpc::StatusCode::DEADLINE_EXCEEDED);
  WaitForLoads(0);
  EndBusy();
}

TEST_F(StoredMeshTest, AServerThatStopsSaysSo) {
  StartBusy();
  const auto call = Open(second_, 0);
  WaitForLoads(1);
  server_->Shutdown(std::chrono::milliseconds(0));
  server_->Wait();
  EXPECT_EQ(call->End().error_code(), grpc::StatusCode::UNAVAILABLE);
  EXPECT_FALSE(busy_->End().ok());
}

TEST_F(StoredMeshTest, MeshesComeAndGoWhileTheyAreDescribed) {
  constexpr int kTimes = 300;
  ServerOptions options = OneThread();
  options.limits.max_concurrent_jobs = 2;
  Start(options);
  const TriangleSoup soup = geodesic::test::Icosphere(2);
  const std::string digest = Upload(soup);
  std::atomic<bool> is_over = false;
  // Between disk and memory a mesh is in one of the two only.
  std::jthread describer([&] {
    while (!is_over) {
      v1::Mesh mesh;
      const grpc::Status status = GetMesh(digest, mesh);
      EXPECT_TRUE(status.ok() ||
                  status.error_code() == grpc::StatusCode::NOT_FOUND)
          << status.error_message();
    }
  });
  for (int i = 0; i < kTimes; ++i) {
    EXPECT_TRUE(DeleteMesh(digest).ok());
    EXPECT_EQ(Upload(soup), digest);
  }
  is_over = true;
}

}  // namespace
}  // namespace geodesic::server
