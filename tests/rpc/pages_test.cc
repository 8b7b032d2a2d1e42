// /livez and /readyz through the life of a server; /metrics under load.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "tests/engine/uploads.h"
#include "tests/rpc/rpc_fixture.h"
#include "tests/support/http_get.h"

namespace geodesic::server {
namespace {

using geodesic::test::HttpGet;
using ::testing::HasSubstr;
using ::testing::StartsWith;

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
  EXPECT_THAT(HttpGet(port, "/metrics"),
              HasSubstr("geodesic_jobs{state=\"running\"} 1"));

  server_->Shutdown(std::chrono::minutes(1));
  EXPECT_THAT(HttpGet(port, "/readyz"), StartsWith("HTTP/1.1 503 "));
  EXPECT_THAT(HttpGet(port, "/livez"), StartsWith("HTTP/1.1 200 "));

  solver_.LetGo();
  EXPECT_TRUE(call->End().ok());
  EXPECT_TRUE(server_->Wait());
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

TEST_F(PagesTest, CancelledWorkIsCounted) {
  const std::string digest = Upload(test::Tetrahedron());
  const auto call = Open(digest, 0);
  solver_.WaitForStarts(1);
  call->context.TryCancel();
  EXPECT_EQ(call->End().error_code(), grpc::StatusCode::CANCELLED);
  ASSERT_TRUE(server_->engine().WaitIdle(std::chrono::minutes(1)));
  const std::string page = HttpGet(server_->metrics_port(), "/metrics");
  EXPECT_EQ(page.find("geodesic_cancelled_compute_seconds_total 0\n"),
            std::string::npos);
  EXPECT_THAT(page,
              HasSubstr("geodesic_solves_ended_total{result=\"stopped\"} 1"));
}

}  // namespace
}  // namespace geodesic::server
