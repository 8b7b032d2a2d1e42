// Clients who hold what others need: who takes nothing of an answer, who has
// most of the requests that a server takes, who asks whether it is there.

#include <gmock/gmock.h>
#include <grpcpp/create_channel.h>
#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "absl/strings/str_cat.h"
#include "digest/sha256.h"
#include "tests/engine/uploads.h"
#include "tests/rpc/rpc_fixture.h"
#include "tests/support/http_get.h"
#include "tests/support/meshes/curved_meshes.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/until.h"

namespace geodesic::server {
namespace {

using geodesic::test::HttpGet;
using geodesic::test::Until;
using ::testing::HasSubstr;
using ::testing::Not;

class HeldRequestsTest : public test::RpcTest {
 protected:
  static ServerOptions Watched() {
    ServerOptions options = SmallServer();
    options.metrics_listen = "127.0.0.1:0";
    return options;
  }

  // Whether /metrics comes to have this line.
  bool Measures(const std::string& line) {
    return Until([&] {
      return HttpGet(server_->metrics_port(), "/metrics").find(line) !=
             std::string::npos;
    });
  }
};

TEST_F(HeldRequestsTest, WhoTakesNothingIsCutOff) {
  ServerOptions options = Watched();
  options.send_patience = std::chrono::seconds(1);
  Start(options);
  // Some megabytes of distances, of which 64 KiB are on their way.
  const std::string digest = Upload(geodesic::test::Icosphere(7));
  questions_ = v1::QuestionService::NewStub(SlowChannel(server_->port()));
  std::vector<std::unique_ptr<test::OpenCall>> stalled;
  for (int i = 0; i < 3; ++i) {
    stalled.push_back(Open(digest, 0));
    ASSERT_TRUE(stalled.back()->Read());
  }
  EXPECT_TRUE(Measures("\ngeodesic_active_requests 0\n"));
  EXPECT_TRUE(Measures(
      R"(geodesic_requests_total{code="DEADLINE_EXCEEDED",method="ComputeField"} 3)"));
  // Nor does it hold an answer's last message.
  for (const auto& call : stalled) EXPECT_FALSE(call->End().ok());
}

// The message that comes with the end of the call.
TEST_F(HeldRequestsTest, WhoDoesNotTakeTheLastMessageIsCutOff) {
  ServerOptions options = Watched();
  options.send_patience = std::chrono::seconds(1);
  Start(options);
  // 320 KiB of distances are one message. From the cache there is no other.
  const std::string digest = Upload(geodesic::test::Icosphere(6));
  ASSERT_TRUE(Ask(digest, 0).status.ok());
  questions_ = v1::QuestionService::NewStub(SlowChannel(server_->port()));
  const auto call = Open(digest, 0);
  ASSERT_TRUE(Measures(
      R"(geodesic_requests_total{code="DEADLINE_EXCEEDED",method="ComputeField"} 1)"));
  EXPECT_FALSE(call->End().ok());
}

TEST_F(HeldRequestsTest, WhoWaitsHearsSo) {
  ServerOptions options = SmallServer();
  options.limits.max_concurrent_jobs = 1;
  Start(options, /*held=*/true);
  const std::string digest = Upload(geodesic::test::Icosphere(2));
  const auto held = Open(digest, 0);
  solver_.WaitForStarts(1);
  const auto waits = Open(digest, 1);
  ASSERT_TRUE(waits->Read());
  EXPECT_TRUE(waits->message.has_header());
  for (int i = 0; i < 2; ++i) {
    ASSERT_TRUE(waits->Read());
    EXPECT_TRUE(waits->message.has_progress());
    EXPECT_EQ(waits->message.progress().vertices_reached(), 0u);
  }
  solver_.LetGo();
  EXPECT_TRUE(waits->End().ok());
  EXPECT_TRUE(held->End().ok());
}

TEST_F(HeldRequestsTest, WhoTakesALittleNowAndThenGetsAll) {
  ServerOptions options = Watched();
  options.send_patience = std::chrono::seconds(3);
  Start(options);
  const std::string digest = Upload(geodesic::test::Icosphere(7));
  // From the cache, so without progress, of which a client holds much that it
  // has not read.
  ASSERT_TRUE(Ask(digest, 0).status.ok());
  questions_ = v1::QuestionService::NewStub(SlowChannel(server_->port()));
  const auto call = Open(digest, 0);
  const auto begin = std::chrono::steady_clock::now();
  while (call->Read()) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1500));
  }
  const grpc::Status status = call->reader->Finish();
  EXPECT_TRUE(status.ok()) << status.error_message();
  EXPECT_GT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(3));
}

TEST_F(HeldRequestsTest, ADeadlineIsCountedAsOne) {
  Start(Watched(), /*held=*/true);
  const std::string digest = Upload(test::Tetrahedron());
  for (int i = 0; i < 10; ++i) {
    grpc::ClientContext context;
    context.set_deadline(std::chrono::system_clock::now() +
                         std::chrono::milliseconds(300 + i));
    EXPECT_EQ(Ask(FieldRequest(digest, 0), context).status.error_code(),
              grpc::StatusCode::DEADLINE_EXCEEDED);
  }
  // A call that was late before it came is not counted.
  EXPECT_TRUE(Measures("\ngeodesic_active_requests 0\n"));
  const std::string counts = HttpGet(server_->metrics_port(), "/metrics");
  EXPECT_THAT(counts,
              HasSubstr(R"(code="DEADLINE_EXCEEDED",method="ComputeField")"));
  EXPECT_THAT(counts,
              Not(HasSubstr(R"(code="CANCELLED",method="ComputeField")")));
  // Who leaves before is not late.
  const auto call = Open(digest, 0);
  ASSERT_TRUE(call->Read());
  call->context.TryCancel();
  call->End();
  EXPECT_TRUE(Measures(
      R"(geodesic_requests_total{code="CANCELLED",method="ComputeField"} 1)"));
}

// Two clients by their tokens, and of one of them as many requests as there may
// be.
TEST_F(HeldRequestsTest, NoClientTakesAllRequests) {
  const geodesic::test::TemporaryFolder folder;
  ServerOptions options = Watched();
  options.max_requests = 8;
  options.token_file = folder / "tokens.json";
  const auto entry = [](const std::string& name) {
    return absl::StrCat(R"({"name": ")", name,
                        R"(", "scopes": ["read", "upload"], "sha256": ")",
                        Sha256Hex(name), R"("})");
  };
  std::ofstream(options.token_file) << absl::StrCat(
      R"({"tokens": [)", entry("many"), ",", entry("few"), "]}");
  Start(options, /*held=*/true);
  const std::string digest = Upload(test::Tetrahedron(), "many");
  // The upload counts until a moment after its answer.
  ASSERT_TRUE(Measures("\ngeodesic_active_requests 0\n"));
  const v1::ComputeFieldRequest request = FieldRequest(digest, 0);
  std::vector<std::unique_ptr<test::OpenCall>> calls;
  const auto open = [&](const std::string& token) {
    calls.push_back(Open(request, token));
    if (calls.back()->Read()) return grpc::Status::OK;
    const grpc::Status status = calls.back()->reader->Finish();
    calls.pop_back();
    return status;
  };
  for (int i = 0; i < 6; ++i) {
    const grpc::Status status = open("many");
    ASSERT_TRUE(status.ok()) << i << status.error_message();
  }
  const grpc::Status refused = open("many");
  EXPECT_EQ(refused.error_code(), grpc::StatusCode::RESOURCE_EXHAUSTED);
  EXPECT_EQ(test::Reason(refused), "TOO_MANY_REQUESTS");
  EXPECT_TRUE(test::RetryInfo(refused).has_value());
  EXPECT_THAT(refused.error_message(), HasSubstr("client:many has 6"));
  EXPECT_TRUE(Measures("\ngeodesic_active_requests 6\n"));
  for (int i = 0; i < 2; ++i) {
    const grpc::Status status = open("few");
    EXPECT_TRUE(status.ok()) << i << status.error_message();
  }
  solver_.LetGo();
  for (const auto& call : calls) EXPECT_TRUE(call->End().ok());
  // What has ended counts no more.
  EXPECT_TRUE(Measures("\ngeodesic_active_requests 0\n"));
  EXPECT_TRUE(open("many").ok());
  EXPECT_TRUE(calls.back()->End().ok());
}

// Without tokens a client is an address, however many connections it has.
TEST_F(HeldRequestsTest, NorByManyConnections) {
  ServerOptions options = Watched();
  options.max_requests = 8;
  Start(options, /*held=*/true);
  const std::string digest = Upload(test::Tetrahedron());
  ASSERT_TRUE(Measures("\ngeodesic_active_requests 0\n"));
  std::vector<std::unique_ptr<test::OpenCall>> calls;
  for (int i = 0; i < 6; ++i) {
    if (i == 3) {
      questions_ = v1::QuestionService::NewStub(SlowChannel(server_->port()));
    }
    calls.push_back(Open(digest, 0));
    ASSERT_TRUE(calls.back()->Read()) << i;
  }
  const auto call = Open(digest, 0);
  EXPECT_FALSE(call->Read());
  EXPECT_THAT(call->reader->Finish().error_message(),
              HasSubstr("127.0.0.1 has 6"));
  solver_.LetGo();
  for (const auto& held : calls) EXPECT_TRUE(held->End().ok());
}

TEST_F(HeldRequestsTest, WhoWaitsMayAskWhetherTheServerIsThere) {
  Start(Watched(), /*held=*/true);
  const std::string digest = Upload(test::Tetrahedron());
  grpc::ChannelArguments arguments;
  constexpr int kPingMs = 6000;
  arguments.SetInt(GRPC_ARG_KEEPALIVE_TIME_MS, kPingMs);
  arguments.SetInt(GRPC_ARG_HTTP2_MAX_PINGS_WITHOUT_DATA, 0);
  questions_ = v1::QuestionService::NewStub(
      grpc::CreateCustomChannel(absl::StrCat("127.0.0.1:", server_->port()),
                                grpc::InsecureChannelCredentials(), arguments));
  const auto call = Open(digest, 0);
  ASSERT_TRUE(call->Read());
  // gRPC's own rules allow a ping in five minutes, and forgive two.
  std::this_thread::sleep_for(std::chrono::milliseconds(4 * kPingMs + 500));
  solver_.LetGo();
  const grpc::Status status = call->End();
  EXPECT_TRUE(status.ok()) << status.error_message();
}

}  // namespace
}  // namespace geodesic::server
