// /livez and /readyz through the life of a server; /metrics under load.

#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <memory>
#include <string>

#include "absl/strings/str_cat.h"
#include "tests/engine/uploads.h"
#include "tests/rpc/rpc_fixture.h"

namespace geodesic::server {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

// The whole answer, head and body.
std::string Get(int port, const std::string& path) {
  const int connection = socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address = {};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  EXPECT_EQ(connect(connection, reinterpret_cast<const sockaddr*>(&address),
                    sizeof(address)),
            0);
  const std::string request =
      absl::StrCat("GET ", path, " HTTP/1.1\r\nHost: test\r\n\r\n");
  EXPECT_EQ(write(connection, request.data(), request.size()),
            static_cast<ssize_t>(request.size()));
  std::string answer;
  char buffer[4096];
  for (ssize_t n = 0; (n = read(connection, buffer, sizeof(buffer))) > 0;) {
    answer.append(buffer, static_cast<size_t>(n));
  }
  close(connection);
  return answer;
}

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
  EXPECT_THAT(Get(port, "/readyz"), StartsWith("HTTP/1.1 200 "));
  const std::string digest = Upload(test::Tetrahedron());
  grpc::ClientContext context;
  const auto stream = fields_->ComputeField(&context, FieldRequest(digest, 0));
  solver_.WaitForStarts(1);
  EXPECT_THAT(Get(port, "/metrics"),
              HasSubstr("geodesic_jobs{state=\"running\"} 1"));

  server_->Shutdown(std::chrono::minutes(1));
  EXPECT_THAT(Get(port, "/readyz"), StartsWith("HTTP/1.1 503 "));
  EXPECT_THAT(Get(port, "/livez"), StartsWith("HTTP/1.1 200 "));

  solver_.LetGo();
  v1::ComputeFieldResponse message;
  while (stream->Read(&message)) {
  }
  EXPECT_TRUE(stream->Finish().ok());
  EXPECT_TRUE(server_->Wait());
  EXPECT_THAT(Get(port, "/metrics"),
              HasSubstr("geodesic_jobs{state=\"running\"} 0"));
}

TEST_F(PagesTest, CancelledWorkIsCounted) {
  const std::string digest = Upload(test::Tetrahedron());
  grpc::ClientContext context;
  const auto stream = fields_->ComputeField(&context, FieldRequest(digest, 0));
  solver_.WaitForStarts(1);
  context.TryCancel();
  EXPECT_EQ(stream->Finish().error_code(), grpc::StatusCode::CANCELLED);
  ASSERT_TRUE(server_->engine().WaitIdle(std::chrono::minutes(1)));
  const std::string page = Get(server_->metrics_port(), "/metrics");
  EXPECT_EQ(page.find("geodesic_cancelled_compute_seconds_total 0\n"),
            std::string::npos);
  EXPECT_THAT(page,
              HasSubstr("geodesic_solves_ended_total{result=\"stopped\"} 1"));
}

}  // namespace
}  // namespace geodesic::server
