// What one client may take of the queue, and how urgent requests are, as far as
// the wire has a part in it; tests/engine/ has the rest.

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "absl/strings/str_cat.h"
#include "digest/sha256.h"
#include "server/rpc/calls/request_log.h"
#include "tests/engine/uploads.h"
#include "tests/rpc/questions_fixture.h"
#include "tests/support/temporary_folder.h"

namespace geodesic::server {
namespace {

class FairnessTest : public test::RpcTest {
 protected:
  // One thread, whose solver waits; two clients.
  void SetUp() override {
    geodesic::test::WriteFile(
        folder_ / "tokens.json",
        absl::StrCat(R"({"tokens": [{"name": "many", "sha256": ")",
                     Sha256Hex("m"), R"(", "scopes": ["read", "upload"]}, )",
                     R"({"name": "one", "sha256": ")", Sha256Hex("o"),
                     R"(", "scopes": ["admin"]}]})"));
    ServerOptions options = SmallServer();
    options.token_file = folder_ / "tokens.json";
    options.limits.max_concurrent_jobs = 1;
    options.limits.max_queued_jobs = 10;
    options.limits.max_queued_jobs_per_client = 2;
    Start(options, /*held=*/true);
    digest_ = Upload(test::Tetrahedron(), "m");
  }

  std::unique_ptr<test::OpenField> Ask(const std::string& token,
                                       double offset) {
    v1::ComputeFieldRequest request = FieldRequest(digest_, 0);
    request.mutable_sources(0)->set_offset(offset);
    return Open(request, token);
  }

  const geodesic::test::TemporaryFolder folder_;
  std::string digest_;
};

TEST_F(FairnessTest, OneClientCannotFillTheQueue) {
  std::vector<std::unique_ptr<test::OpenField>> admitted;
  // One that runs, two that wait.
  for (int i = 0; i < 3; ++i) {
    admitted.push_back(Ask("m", i));
    ASSERT_TRUE(admitted.back()->Read());
    solver_.WaitForStarts(1);
  }
  const auto refused = Ask("m", 3);
  const grpc::Status status = refused->End();
  EXPECT_EQ(status.error_code(), grpc::StatusCode::RESOURCE_EXHAUSTED);
  EXPECT_EQ(test::Reason(status), "QUOTA_EXCEEDED");
  EXPECT_TRUE(test::RetryInfo(status).has_value());
  const auto quota = test::Detail<google::rpc::QuotaFailure>(status);
  ASSERT_TRUE(quota.has_value());
  EXPECT_EQ(quota->violations(0).subject(), "client:many");
  const auto& trailers = refused->context.GetServerTrailingMetadata();
  EXPECT_EQ(trailers.count("grpc-retry-pushback-ms"), 1);

  admitted.push_back(Ask("o", 3));
  EXPECT_TRUE(admitted.back()->Read());
  solver_.LetGo();
  for (const auto& call : admitted) EXPECT_TRUE(call->End().ok());
}

TEST(PeerHost, IsTheAddressWithoutThePort) {
  EXPECT_EQ(PeerHost("ipv4:10.1.2.3:53412"), "ipv4:10.1.2.3");
  EXPECT_EQ(PeerHost("ipv6:%5B2001:db8::1%5D:53412"), "ipv6:%5B2001:db8::1%5D");
  EXPECT_EQ(PeerHost("unix:/run/geodesicd"), "unix:/run/geodesicd");
}

class PriorityTest : public test::QuestionsTest {
 protected:
  template <typename Request>
  void ExpectPriority(Request request) {
    request.set_mesh_digest(digest_);
    request.set_priority(static_cast<v1::Priority>(99));
    EXPECT_EQ(Fault(request), "priority");
    request.set_priority(v1::PRIORITY_BATCH);
    EXPECT_FALSE(Messages(request).empty());
  }
};

TEST_F(PriorityTest, EveryQuestionHasOne) {
  v1::ComputePathsRequest paths;
  paths.add_sources()->set_vertex(0);
  paths.add_targets()->set_vertex(5);
  ExpectPriority(paths);
  v1::ComputeIsolinesRequest isolines;
  isolines.add_sources()->set_vertex(0);
  isolines.add_levels(2);
  ExpectPriority(isolines);
  v1::ComputeLogMapRequest log_map;
  log_map.mutable_source()->set_vertex(Vertex(5, 5));
  ExpectPriority(log_map);
  v1::SampleFarthestPointsRequest samples;
  samples.add_sources()->set_vertex(0);
  samples.set_count(2);
  ExpectPriority(samples);
  v1::ComputeMatrixRequest matrix;
  matrix.add_sources()->set_vertex(0);
  ExpectPriority(matrix);
  v1::FindNearestRequest nearest;
  nearest.add_sources()->set_vertex(0);
  nearest.add_targets()->set_vertex(5);
  nearest.set_count(1);
  ExpectPriority(nearest);
  ExpectPriority(FieldRequest(digest_, 0));
}

}  // namespace
}  // namespace geodesic::server
