// What operators and tools ask: capabilities, health, reflection, pages; and
// shutting down.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <spdlog/spdlog.h>

#include <chrono>
#include <future>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "geodesic/v1/capabilities_service.grpc.pb.h"
#include "tests/engine/uploads.h"
#include "tests/rpc/rpc_fixture.h"
#include "tests/support/http_get.h"
#include "tests/support/until.h"

namespace geodesic::server {
namespace {

using geodesic::test::HttpGet;
using geodesic::test::Until;
using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr char kHealthCheck[] = "/grpc.health.v1.Health/Check";

// HealthCheckRequest{service}; HealthCheckResponse{SERVING}.
std::string HealthRequest(const std::string& service) {
  return service.empty() ? ""
                         : std::string("\x0a") +
                               static_cast<char>(service.size()) + service;
}
const std::string kServing("\x08\x01", 2);

const std::string kNotServing("\x08\x02", 2);

constexpr const char* kServices[] = {"geodesic.v1.MeshService",
                                     "geodesic.v1.QuestionService",
                                     "geodesic.v1.CapabilitiesService"};

constexpr std::chrono::hours kPatience{1};

class OperationsTest : public test::RpcTest {
 protected:
  void SetUp() override { Start(); }
};

TEST_F(OperationsTest, CapabilitiesTellTheLimits) {
  const auto stub = v1::CapabilitiesService::NewStub(channel_);
  grpc::ClientContext context;
  v1::GetCapabilitiesResponse response;
  ASSERT_TRUE(stub->GetCapabilities(&context, {}, &response).ok());
  EXPECT_EQ(response.version(), ServerVersion());
  ASSERT_EQ(response.algorithms_size(), kAlgorithms.size());
  EXPECT_EQ(response.algorithms(0).name(), "fwp-list");
  EXPECT_EQ(response.algorithms(0).algorithm(), v1::ALGORITHM_FWP_LIST);
  EXPECT_TRUE(response.algorithms(0).is_default());
  EXPECT_FALSE(response.algorithms(1).is_default());
  EXPECT_FALSE(response.algorithms(3).summary().empty());
  // All but MESH_FORMAT_UNSPECIFIED.
  EXPECT_EQ(response.formats_size(),
            v1::MeshFormat_descriptor()->value_count() - 1);
  const ServerOptions options = SmallServer();
  const v1::Limits& limits = response.limits();
  EXPECT_EQ(limits.max_upload_bytes(), options.limits.max_upload_bytes);
  EXPECT_EQ(limits.max_vertices(), options.limits.max_vertices);
  EXPECT_EQ(limits.max_faces(), options.limits.max_faces);
  EXPECT_EQ(limits.max_sources(), options.limits.max_sources);
  EXPECT_EQ(limits.max_message_bytes(), options.max_message_bytes);
  EXPECT_EQ(limits.max_concurrent_jobs(), options.limits.max_concurrent_jobs);
  EXPECT_EQ(limits.max_queued_jobs(), options.limits.max_queued_jobs);
  EXPECT_EQ(limits.mesh_store_bytes(), options.limits.mesh_store_bytes);
  EXPECT_EQ(limits.field_cache_bytes(), options.limits.field_cache_bytes);
  EXPECT_EQ(limits.landmark_memory_bytes(),
            options.limits.landmark_memory_bytes);
  EXPECT_EQ(limits.max_curve_points(), options.limits.max_curve_points);
  EXPECT_EQ(limits.max_targets(), options.limits.max_targets);
  EXPECT_EQ(limits.max_levels(), options.limits.max_levels);
  EXPECT_EQ(limits.max_samples(), options.limits.max_samples);
  EXPECT_EQ(limits.max_pairs(), options.limits.max_pairs);
  EXPECT_EQ(limits.max_matrix_rows(), options.limits.max_matrix_rows);
  EXPECT_EQ(limits.max_matrix_values(), options.limits.max_matrix_values);
  // This server keeps nothing on disk.
  EXPECT_EQ(limits.mesh_disk_bytes(), 0);
  EXPECT_EQ(limits.field_disk_bytes(), 0);
}

TEST_F(OperationsTest, HealthIsServing) {
  const auto expect_serving = [&](const char* service) {
    const auto answer =
        test::CallMethod(channel_, kHealthCheck, HealthRequest(service));
    ASSERT_TRUE(answer.ok()) << answer.status();
    EXPECT_EQ(*answer, kServing) << service;
  };
  expect_serving("");
  for (const char* service : kServices) expect_serving(service);
  EXPECT_TRUE(absl::IsNotFound(
      test::CallMethod(channel_, kHealthCheck, HealthRequest("unknown"))
          .status()));
}

TEST_F(OperationsTest, ReflectionListsTheServices) {
  // ServerReflectionRequest{list_services: ""}.
  const auto answer = test::CallMethod(
      channel_,
      "/grpc.reflection.v1alpha.ServerReflection/ServerReflectionInfo",
      std::string("\x3a\x00", 2));
  ASSERT_TRUE(answer.ok()) << answer.status();
  for (const char* service : kServices) {
    EXPECT_THAT(*answer, HasSubstr(service));
  }
}

TEST_F(OperationsTest, ReflectionDescribesTheHealthService) {
  // ServerReflectionRequest{file_containing_symbol: "grpc.health.v1.Health"}.
  const auto answer = test::CallMethod(
      channel_,
      "/grpc.reflection.v1alpha.ServerReflection/ServerReflectionInfo",
      "\x22\x15grpc.health.v1.Health");
  ASSERT_TRUE(answer.ok()) << answer.status();
  EXPECT_THAT(*answer, HasSubstr("HealthCheckRequest"));
}

class CrowdTest : public test::RpcTest {};

TEST_F(CrowdTest, StreamsHaveALimit) {
  ServerOptions options = SmallServer();
  options.max_requests = 2;
  Start(options, /*held=*/true);
  const std::string digest = Upload(test::Tetrahedron());
  std::vector<std::unique_ptr<test::OpenCall>> calls;
  while (calls.size() < 2) {
    auto call = Open(digest, 0);
    if (call->Read()) {
      calls.push_back(std::move(call));
    } else {
      // The server still counts the upload: its client hears the end first.
      ASSERT_EQ(call->reader->Finish().error_code(),
                grpc::StatusCode::RESOURCE_EXHAUSTED);
    }
  }
  v1::CreateMeshResponse response;
  for (const grpc::Status& status :
       {Ask(digest, 0).status, Upload(v1::UploadHeader(), "", response)}) {
    EXPECT_EQ(status.error_code(), grpc::StatusCode::RESOURCE_EXHAUSTED);
    EXPECT_TRUE(test::RetryInfo(status).has_value());
  }
  // What is answered at once still is.
  const auto health = test::CallMethod(channel_, kHealthCheck, "");
  EXPECT_TRUE(health.ok()) << health.status();
  solver_.LetGo();
  for (const auto& call : calls) EXPECT_TRUE(call->End().ok());
}

TEST_F(OperationsTest, OnePortHasOneServer) {
  ServerOptions options = SmallServer();
  options.listen = absl::StrCat("127.0.0.1:", server_->port());
  Server second(options, spdlog::default_logger());
  const absl::Status status = second.Start();
  EXPECT_TRUE(absl::IsUnavailable(status));
  EXPECT_THAT(std::string(status.message()), HasSubstr(options.listen));
}

// /livez and /readyz through the life of a server; /metrics under load.
class PagesTest : public test::RpcTest {
 protected:
  void SetUp() override {
    ServerOptions options = SmallServer();
    options.metrics_listen = "127.0.0.1:0";
    Start(options, /*held=*/true);
  }
};

TEST_F(PagesTest, ADrainingServerIsAliveAndNotReady) {
  const int port = server_->metrics_port();
  EXPECT_THAT(HttpGet(port, "/readyz"), StartsWith("HTTP/1.1 200 "));
  const std::string digest = Upload(test::Tetrahedron());
  const auto call = Open(digest, 0);
  solver_.WaitForStarts(1);
  // The upload's job counts until a moment after its answer.
  EXPECT_TRUE(Until([&] {
    return HttpGet(port, "/metrics")
               .find("geodesic_jobs{state=\"running\"} 1") != std::string::npos;
  }));

  server_->Shutdown(std::chrono::minutes(1));
  EXPECT_THAT(HttpGet(port, "/readyz"), StartsWith("HTTP/1.1 503 "));
  EXPECT_THAT(HttpGet(port, "/livez"), StartsWith("HTTP/1.1 200 "));

  solver_.LetGo();
  EXPECT_TRUE(call->End().ok());
  EXPECT_EQ(server_->Wait(), Server::Ending::kInOrder);
  EXPECT_THAT(HttpGet(port, "/metrics"),
              HasSubstr("geodesic_jobs{state=\"running\"} 0"));
}

// Answered while all of them are still waited for.
TEST_F(PagesTest, HalfRequestsHoldNobodyUp) {
  const int port = server_->metrics_port();
  std::vector<int> halves;
  for (int i = 0; i < 50; ++i) {
    halves.push_back(
        geodesic::test::ConnectAndSend(port, "GET /livez HTTP/1.1\r\nHost:"));
  }
  EXPECT_THAT(HttpGet(port, "/livez"), StartsWith("HTTP/1.1 200 "));
  for (const int half : halves) {
    char byte;
    EXPECT_EQ(recv(half, &byte, 1, MSG_DONTWAIT), -1) << "was given up";
    close(half);
  }
}

TEST_F(PagesTest, OneAddressHoldsNoOtherUp) {
  const int port = server_->metrics_port();
  // More than the port takes of all.
  std::vector<int> silent;
  for (int i = 0; i < 600; ++i) {
    silent.push_back(geodesic::test::ConnectAndSend(port, "", "127.0.0.2"));
  }
  EXPECT_THAT(HttpGet(port, "/livez"), StartsWith("HTTP/1.1 200 "));
  // One that was taken is there still.
  char byte;
  EXPECT_EQ(recv(silent[0], &byte, 1, MSG_DONTWAIT), -1) << "was given up";
  for (const int connection : silent) close(connection);
}

// Shutting down.
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
  std::unique_ptr<test::OpenCall> call_;
  std::future<Server::Ending> stopped_;
};

TEST_F(DrainTest, WhatRunsFinishesAndNothingNewBegins) {
  server_->Shutdown(kPatience);
  const auto health = test::CallMethod(channel_, kHealthCheck, "");
  ASSERT_TRUE(health.ok()) << health.status();
  EXPECT_EQ(*health, kNotServing);
  EXPECT_EQ(Ask(digest_, 1).status.error_code(), grpc::StatusCode::UNAVAILABLE);
  // So who asks before it begins knows.
  EXPECT_TRUE(absl::IsUnavailable(
      test::CallMethod(channel_,
                       "/geodesic.v1.CapabilitiesService/GetCapabilities", "")
          .status()));
  v1::CreateMeshResponse response;
  v1::UploadHeader header;
  header.set_format(v1::MESH_FORMAT_OFF);
  header.set_size_bytes(1);
  EXPECT_EQ(Upload(header, "x", response).error_code(),
            grpc::StatusCode::UNAVAILABLE);

  solver_.LetGo();
  EXPECT_TRUE(call_->End().ok());
  EXPECT_TRUE(call_->message.has_trailer());
  EXPECT_EQ(stopped_.get(), Server::Ending::kInOrder);
}

TEST_F(DrainTest, GraceEnds) {
  server_->Shutdown(std::chrono::milliseconds(1));
  EXPECT_EQ(call_->End().error_code(), grpc::StatusCode::UNAVAILABLE);
  EXPECT_EQ(stopped_.get(), Server::Ending::kCancelled);
}

TEST_F(DrainTest, ASecondCallCutsItShort) {
  server_->Shutdown(kPatience);
  server_->Shutdown(kPatience);
  EXPECT_EQ(call_->End().error_code(), grpc::StatusCode::UNAVAILABLE);
  EXPECT_EQ(stopped_.get(), Server::Ending::kCancelled);
}

}  // namespace
}  // namespace geodesic::server
