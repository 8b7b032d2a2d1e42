// Shutting down.

#include <gtest/gtest.h>

#include <future>
#include <memory>
#include <string>

#include "tests/engine/uploads.h"
#include "tests/rpc/rpc_fixture.h"

namespace geodesic::server {
namespace {

constexpr std::chrono::hours kPatience{1};
const std::string kNotServing("\x08\x02", 2);

class DrainTest : public test::RpcTest {
 protected:
  // A server with one query in the hands of its solver.
  void SetUp() override {
    Start(SmallServer(), /*held=*/true);
    digest_ = Upload(test::Tetrahedron());
    call_ = Open(digest_, 0);
    ASSERT_TRUE(call_->Read());
    solver_.WaitForStarts(1);
    stopped_ =
        std::async(std::launch::async, [this] { return server_->Wait(); });
  }

  void TearDown() override {
    // Wait may be called once only, and was.
    if (stopped_.valid()) stopped_.get();
  }

  std::string digest_;
  std::unique_ptr<test::OpenField> call_;
  std::future<bool> stopped_;
};

TEST_F(DrainTest, WhatRunsFinishesAndNothingNewBegins) {
  server_->Shutdown(kPatience);
  const auto health =
      test::CallMethod(channel_, "/grpc.health.v1.Health/Check", "");
  ASSERT_TRUE(health.ok()) << health.status();
  EXPECT_EQ(*health, kNotServing);
  EXPECT_EQ(ComputeField(digest_, 1).status.error_code(),
            grpc::StatusCode::UNAVAILABLE);
  v1::CreateMeshResponse response;
  v1::UploadHeader header;
  header.set_format(v1::MESH_FORMAT_OFF);
  header.set_size_bytes(1);
  EXPECT_EQ(Upload(header, "x", response).error_code(),
            grpc::StatusCode::UNAVAILABLE);

  solver_.LetGo();
  EXPECT_TRUE(call_->End().ok());
  EXPECT_TRUE(call_->message.has_trailer());
  EXPECT_TRUE(stopped_.get());
}

TEST_F(DrainTest, GraceEnds) {
  server_->Shutdown(std::chrono::milliseconds(1));
  EXPECT_EQ(call_->End().error_code(), grpc::StatusCode::UNAVAILABLE);
  EXPECT_FALSE(stopped_.get());
}

TEST_F(DrainTest, ASecondCallCutsItShort) {
  server_->Shutdown(kPatience);
  server_->Shutdown(kPatience);
  EXPECT_EQ(call_->End().error_code(), grpc::StatusCode::UNAVAILABLE);
  EXPECT_FALSE(stopped_.get());
}

}  // namespace
}  // namespace geodesic::server
