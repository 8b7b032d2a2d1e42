// Tokens, scopes and quotas, asked for by every RPC before anything else.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <spdlog/logger.h>
#include <spdlog/sinks/null_sink.h>

#include <chrono>
#include <future>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "digest/sha256.h"
#include "server/rpc/calls/peer.h"
#include "server/rpc/calls/required_scope.h"
#include "tests/engine/uploads.h"
#include "tests/rpc/rpc_fixture.h"
#include "tests/support/temporary_folder.h"

namespace geodesic::server {
namespace {

using ::testing::HasSubstr;

std::string ReasonOf(const absl::Status& status) {
  const auto payload = status.GetPayload(test::kDetails);
  if (!payload) return "";
  return test::Reason(grpc::Status(static_cast<grpc::StatusCode>(status.code()),
                                   std::string(status.message()),
                                   std::string(*payload)));
}

class AccessTest : public test::RpcTest {
 protected:
  // Starts a server that knows the token "sesame" of the client "ci" with these
  // scopes, and the token "root" of an administrator.
  void StartWith(const std::string& scopes, const std::string& quota = "{}",
                 bool held = false, ServerOptions options = SmallServer()) {
    NameTokens(scopes, quota, options);
    Start(options, held);
  }

  void NameTokens(const std::string& scopes, const std::string& quota,
                  ServerOptions& options) {
    options.token_file = folder_ / "tokens.json";
    geodesic::test::WriteFile(
        options.token_file,
        absl::StrCat(R"({"tokens": [{"name": "ci", "sha256": ")",
                     Sha256Hex("sesame"), R"(", "scopes": )", scopes,
                     R"(}, {"name": "root", "sha256": ")", Sha256Hex("root"),
                     R"(", "scopes": ["admin"]}], "quotas": {"ci": )", quota,
                     "}}"));
  }

  absl::Status Call(const std::string& method, const test::Metadata& metadata) {
    return test::CallMethod(channel_, method, "", metadata).status();
  }

  static void ExpectQuotaExceeded(const grpc::Status& status) {
    EXPECT_EQ(status.error_code(), grpc::StatusCode::RESOURCE_EXHAUSTED);
    EXPECT_EQ(test::Reason(status), "QUOTA_EXCEEDED");
    EXPECT_TRUE(test::RetryInfo(status).has_value());
    const auto quota = test::Detail<google::rpc::QuotaFailure>(status);
    ASSERT_TRUE(quota.has_value());
    EXPECT_EQ(quota->violations(0).subject(), "client:ci");
  }

  const geodesic::test::TemporaryFolder folder_;
};

TEST_F(AccessTest, WithoutATokenNoMethodAnswers) {
  StartWith(R"(["admin"])");
  ASSERT_EQ(test::AllMethods().size(), 16);
  for (const auto* descriptor : test::AllMethods()) {
    const std::string method = test::PathOf(*descriptor);
    const absl::Status none = Call(method, {});
    EXPECT_TRUE(absl::IsUnauthenticated(none)) << method << none;
    EXPECT_EQ(ReasonOf(none), "TOKEN_MISSING") << method;
    const absl::Status wrong =
        Call(method, {{"authorization", "Bearer simsala"}});
    EXPECT_TRUE(absl::IsUnauthenticated(wrong)) << method << wrong;
    EXPECT_EQ(ReasonOf(wrong), "TOKEN_UNKNOWN") << method;
    const absl::Status two = Call(method, {{"authorization", "Bearer sesame"},
                                           {"authorization", "Bearer sesame"}});
    EXPECT_TRUE(absl::IsUnauthenticated(two)) << method << two;
  }
}

TEST_F(AccessTest, ScopesSaySeparatelyWhoAsksUploadsAndDeletes) {
  StartWith(R"(["read"])");
  const std::set<std::string> refused = {"/geodesic.v1.MeshService/CreateMesh",
                                         "/geodesic.v1.MeshService/DeleteMesh"};
  for (const auto* descriptor : test::AllMethods()) {
    const std::string method = test::PathOf(*descriptor);
    const absl::Status status =
        Call(method, {{"authorization", "Bearer sesame"}});
    EXPECT_FALSE(absl::IsUnauthenticated(status)) << method << status;
    EXPECT_EQ(absl::IsPermissionDenied(status), refused.contains(method))
        << method << status;
  }
}

TEST(RequiredScope, WhatIsNotListedNeedsAdmin) {
  EXPECT_EQ(RequiredScope("FormatDisk"), Scope::kAdmin);
  EXPECT_EQ(RequiredScope("DeleteMesh"), Scope::kDelete);
}

TEST_F(AccessTest, HealthAndReflectionAreForEverybody) {
  StartWith(R"(["read"])");
  EXPECT_TRUE(Call("/grpc.health.v1.Health/Check", {}).ok());
}

TEST_F(AccessTest, AQuotaOfJobsCountsStreamsUnderWay) {
  StartWith(R"(["read", "upload"])", R"({"jobs": 1})",
            /*held=*/true);
  const std::string digest = Upload(test::Tetrahedron(), "sesame");
  const auto first = Open(FieldRequest(digest, 0), "sesame");
  solver_.WaitForStarts(1);

  const auto second = Open(FieldRequest(digest, 1), "sesame");
  ExpectQuotaExceeded(second->End());
  // gRPC's own retries wait as long.
  const auto& trailers = second->context.GetServerTrailingMetadata();
  ASSERT_EQ(trailers.count("grpc-retry-pushback-ms"), 1);
  EXPECT_EQ(trailers.find("grpc-retry-pushback-ms")->second, "1000");

  solver_.LetGo();
  EXPECT_TRUE(first->End().ok());
}

// Or a client of one job could take all threads, by leaving each time.
TEST_F(AccessTest, AQuotaOfJobsCountsThemUntilTheyHaveStopped) {
  ServerOptions options = SmallServer();
  NameTokens(R"(["read", "upload"])", R"({"jobs": 1})", options);
  std::promise<void> begun, let_go;
  bool is_first = true;
  RpcTest::StartWith(options,
                     [&, waits = let_go.get_future().share()](
                         const Mesh& mesh, const ValidQuery& query,
                         const SolveOptions& solve_options)
                         -> absl::StatusOr<std::unique_ptr<Computation>> {
                       // Deaf, as no solver should be.
                       if (std::exchange(is_first, false)) begun.set_value();
                       waits.wait();
                       return StartComputation(mesh, query, solve_options);
                     });
  const std::string digest = Upload(test::Tetrahedron(), "sesame");
  const auto first = Open(FieldRequest(digest, 0), "sesame");
  begun.get_future().wait();
  first->context.TryCancel();
  EXPECT_EQ(first->End().error_code(), grpc::StatusCode::CANCELLED);
  // Whether the server has heard of it yet or not, the solver runs.
  ExpectQuotaExceeded(Open(FieldRequest(digest, 1), "sesame")->End());

  let_go.set_value();
  ASSERT_TRUE(
      server_->engine().scheduler().WaitIdle(std::chrono::seconds(120)));
  EXPECT_TRUE(Open(FieldRequest(digest, 1), "sesame")->End().ok());
}

using FairnessTest = AccessTest;

TEST_F(FairnessTest, OneClientCannotFillTheQueue) {
  ServerOptions options = SmallServer();
  options.limits.max_concurrent_jobs = 1;
  options.limits.max_queued_jobs = 10;
  options.limits.max_queued_jobs_per_client = 2;
  StartWith(R"(["read", "upload"])", "{}", /*held=*/true, options);
  v1::ComputeFieldRequest request =
      FieldRequest(Upload(test::Tetrahedron(), "sesame"), 0);
  std::vector<std::unique_ptr<test::OpenCall>> admitted;
  // One that runs, two that wait.
  for (int i = 0; i < 3; ++i) {
    request.mutable_sources(0)->set_offset(i);
    admitted.push_back(Open(request, "sesame"));
    ASSERT_TRUE(admitted.back()->Read());
    solver_.WaitForStarts(1);
  }
  request.mutable_sources(0)->set_offset(3);
  const auto refused = Open(request, "sesame");
  ExpectQuotaExceeded(refused->End());
  const auto& trailers = refused->context.GetServerTrailingMetadata();
  EXPECT_EQ(trailers.count("grpc-retry-pushback-ms"), 1);

  admitted.push_back(Open(request, "root"));
  EXPECT_TRUE(admitted.back()->Read());
  solver_.LetGo();
  for (const auto& call : admitted) EXPECT_TRUE(call->End().ok());
}

TEST_F(AccessTest, AServerWithoutThePasswordOfItsTierDoesNotStart) {
  ServerOptions options = SmallServer();
  options.shared_tier = "127.0.0.1:9";
  options.shared_tier_password_file = folder_ / "missing";
  const auto logger = std::make_shared<spdlog::logger>(
      "test", std::make_shared<spdlog::sinks::null_sink_mt>());
  const absl::Status status =
      Server(options, logger, &StartComputation).Start();
  EXPECT_TRUE(absl::IsNotFound(status)) << status;
  EXPECT_THAT(std::string(status.message()),
              HasSubstr(options.shared_tier_password_file));
}

TEST(PeerHost, IsTheAddressWithoutThePort) {
  EXPECT_EQ(PeerHost("ipv4:10.1.2.3:53412"), "ipv4:10.1.2.3");
  EXPECT_EQ(PeerHost("ipv6:%5B2001:db8::1%5D:53412"), "ipv6:%5B2001:db8::1%5D");
  EXPECT_EQ(PeerHost("unix:/run/geodesicd"), "unix:/run/geodesicd");
}

TEST_F(AccessTest, ARateIsHeldAndSaysWhenToComeAgain) {
  // A second request would have to wait for a quarter of an hour.
  StartWith(R"(["read"])", R"({"requests_per_second": 0.001})");
  const std::string method = "/geodesic.v1.MeshService/ListMeshes";
  EXPECT_TRUE(Call(method, {{"authorization", "Bearer sesame"}}).ok());
  const absl::Status status =
      Call(method, {{"authorization", "Bearer sesame"}});
  EXPECT_TRUE(absl::IsResourceExhausted(status)) << status;
  EXPECT_EQ(ReasonOf(status), "QUOTA_EXCEEDED");
  EXPECT_THAT(std::string(status.message()), HasSubstr("requests_per_second"));
}

}  // namespace
}  // namespace geodesic::server
