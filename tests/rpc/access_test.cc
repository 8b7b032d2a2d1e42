// Tokens, scopes and quotas, asked for by every RPC before anything else.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "absl/strings/str_cat.h"
#include "digest/sha256.h"
#include "server/rpc/calls/request_log.h"
#include "tests/engine/uploads.h"
#include "tests/rpc/generic_call.h"
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
  // Starts a server that knows `token` of the client "ci" with these scopes.
  void StartWith(const std::string& token, const std::string& scopes,
                 const std::string& quota = "{}", bool held = false) {
    geodesic::test::WriteFile(
        folder_ / "tokens.json",
        absl::StrCat(R"({"tokens": [{"name": "ci", "sha256": ")",
                     Sha256Hex(token), R"(", "scopes": )", scopes,
                     R"(}], "quotas": {"ci": )", quota, "}}"));
    ServerOptions options = SmallServer();
    options.token_file = folder_ / "tokens.json";
    Start(options, held);
  }

  absl::Status Call(const std::string& method, const test::Metadata& metadata) {
    return test::CallMethod(channel_, method, "", metadata).status();
  }

  const geodesic::test::TemporaryFolder folder_;
};

TEST_F(AccessTest, WithoutATokenNoMethodAnswers) {
  StartWith("sesame", R"(["admin"])");
  ASSERT_EQ(test::AllMethods().size(), 14);
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
  StartWith("sesame", R"(["read"])");
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
  StartWith("sesame", R"(["read"])");
  EXPECT_TRUE(Call("/grpc.health.v1.Health/Check", {}).ok());
}

TEST_F(AccessTest, AQuotaOfJobsCountsStreamsUnderWay) {
  StartWith("sesame", R"(["read", "upload"])", R"({"jobs": 1})",
            /*held=*/true);
  const std::string digest = Upload(test::Tetrahedron(), "sesame");
  const auto first = Open(FieldRequest(digest, 0), "sesame");
  solver_.WaitForStarts(1);

  grpc::ClientContext second_context;
  test::AddToken("sesame", second_context);
  const test::FieldReply second =
      ComputeField(FieldRequest(digest, 1), second_context);
  EXPECT_EQ(second.status.error_code(), grpc::StatusCode::RESOURCE_EXHAUSTED);
  EXPECT_EQ(test::Reason(second.status), "QUOTA_EXCEEDED");
  EXPECT_TRUE(test::RetryInfo(second.status).has_value());
  const auto quota = test::Detail<google::rpc::QuotaFailure>(second.status);
  ASSERT_TRUE(quota.has_value());
  EXPECT_EQ(quota->violations(0).subject(), "client:ci");
  // gRPC's own retries wait as long.
  const auto& trailers = second_context.GetServerTrailingMetadata();
  ASSERT_EQ(trailers.count("grpc-retry-pushback-ms"), 1);
  EXPECT_EQ(trailers.find("grpc-retry-pushback-ms")->second, "1000");

  solver_.LetGo();
  EXPECT_TRUE(first->End().ok());
}

TEST_F(AccessTest, ARateIsHeldAndSaysWhenToComeAgain) {
  // A second request would have to wait for a quarter of an hour.
  StartWith("sesame", R"(["read"])", R"({"requests_per_second": 0.001})");
  const std::string method = "/geodesic.v1.MeshService/ListMeshes";
  EXPECT_TRUE(Call(method, {{"authorization", "Bearer sesame"}}).ok());
  const absl::Status status =
      Call(method, {{"authorization", "Bearer sesame"}});
  EXPECT_TRUE(absl::IsResourceExhausted(status)) << status;
  EXPECT_EQ(ReasonOf(status), "QUOTA_EXCEEDED");
  EXPECT_THAT(std::string(status.message()), HasSubstr("requests_per_second"));
}

TEST_F(AccessTest, AReloadTakesATokenAwayFromLiveConnections) {
  StartWith("sesame", R"(["read"])");
  const std::string method = "/geodesic.v1.MeshService/ListMeshes";
  const test::Metadata token = {{"authorization", "Bearer sesame"}};
  ASSERT_TRUE(Call(method, token).ok());
  geodesic::test::WriteFile(folder_ / "tokens.json", R"({"tokens": []})");
  server_->Reload();
  EXPECT_TRUE(absl::IsUnauthenticated(Call(method, token)));
  // What is not well-formed changes nothing.
  geodesic::test::WriteFile(folder_ / "tokens.json", "{");
  server_->Reload();
  EXPECT_TRUE(absl::IsUnauthenticated(Call(method, token)));
}

}  // namespace
}  // namespace geodesic::server
