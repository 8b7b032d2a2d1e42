// What one client may take of the queue, and how urgent requests are, as far as
// the wire has a part in it; tests/engine/ has the rest.

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "absl/strings/str_cat.h"
#include "digest/sha256.h"
#include "server/rpc/calls/call_metadata.h"
#include "tests/engine/uploads.h"
#include "tests/rpc/questions_fixture.h"
#include "tests/support/temporary_folder.h"

namespace geodesic::server {
namespace {

// A call under way.
struct Asked {
  grpc::ClientContext context;
  std::unique_ptr<grpc::ClientReader<v1::ComputeFieldResponse>> reader;

  // Its first message, or why there is none.
  grpc::Status Begin() {
    v1::ComputeFieldResponse message;
    if (reader->Read(&message)) return grpc::Status::OK;
    return reader->Finish();
  }
  grpc::Status End() {
    v1::ComputeFieldResponse message;
    while (reader->Read(&message)) {
    }
    return reader->Finish();
  }
};

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
    grpc::ClientContext context;
    context.AddMetadata("authorization", "Bearer m");
    const TriangleSoup soup = test::Tetrahedron();
    const std::string bytes = test::ArrayBytes(soup);
    v1::CreateMeshResponse response;
    const auto writer = meshes_->CreateMesh(&context, &response);
    v1::CreateMeshRequest message;
    message.mutable_header()->set_format(v1::MESH_FORMAT_ARRAYS);
    message.mutable_header()->set_size_bytes(bytes.size());
    message.mutable_header()->set_vertex_count(soup.positions.size());
    message.mutable_header()->set_face_count(soup.triangles.size());
    writer->Write(message);
    message.mutable_chunk()->set_data(bytes);
    writer->Write(message);
    writer->WritesDone();
    ASSERT_TRUE(writer->Finish().ok());
    digest_ = response.mesh().digest();
  }

  std::unique_ptr<Asked> Ask(const std::string& token, uint64_t vertex,
                             double offset) {
    auto asked = std::make_unique<Asked>();
    asked->context.AddMetadata("authorization", "Bearer " + token);
    v1::ComputeFieldRequest request = FieldRequest(digest_, vertex);
    request.mutable_sources(0)->set_offset(offset);
    asked->reader = fields_->ComputeField(&asked->context, request);
    return asked;
  }

  const geodesic::test::TemporaryFolder folder_;
  std::string digest_;
};

TEST_F(FairnessTest, OneClientCannotFillTheQueue) {
  std::vector<std::unique_ptr<Asked>> admitted;
  // One that runs, two that wait.
  for (int i = 0; i < 3; ++i) {
    admitted.push_back(Ask("m", 0, i));
    ASSERT_TRUE(admitted.back()->Begin().ok());
    solver_.WaitForStarts(1);
  }
  const auto refused = Ask("m", 0, 3);
  const grpc::Status status = refused->Begin();
  EXPECT_EQ(status.error_code(), grpc::StatusCode::RESOURCE_EXHAUSTED);
  EXPECT_EQ(test::Reason(status), "QUOTA_EXCEEDED");
  EXPECT_TRUE(test::RetryInfo(status).has_value());
  const auto quota = test::Detail<google::rpc::QuotaFailure>(status);
  ASSERT_TRUE(quota.has_value());
  EXPECT_EQ(quota->violations(0).subject(), "client:many");
  const auto& trailers = refused->context.GetServerTrailingMetadata();
  EXPECT_EQ(trailers.count("grpc-retry-pushback-ms"), 1);

  admitted.push_back(Ask("o", 0, 3));
  EXPECT_TRUE(admitted.back()->Begin().ok());
  solver_.LetGo();
  for (const auto& asked : admitted) EXPECT_TRUE(asked->End().ok());
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
    const auto reply = Ask(request);
    EXPECT_TRUE(reply.status.ok()) << reply.status.error_message();
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
  v1::ComputeFieldRequest field = FieldRequest(digest_, 0);
  field.set_priority(static_cast<v1::Priority>(99));
  grpc::ClientContext context;
  EXPECT_EQ(test::FieldAtFault(ComputeField(field, context).status),
            "priority");
}

}  // namespace
}  // namespace geodesic::server
