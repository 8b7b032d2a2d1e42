// FieldService.ComputeField.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "geodesic/solve.h"
#include "tests/engine/uploads.h"
#include "tests/rpc/rpc_fixture.h"
#include "tests/support/curved_meshes.h"

namespace geodesic::server {
namespace {

using test::FieldReply;
using test::OpenField;
using ::testing::HasSubstr;

class FieldRpcTest : public test::RpcTest {
 protected:
  EngineCounters counters() { return server_->engine().counters(); }
};

TEST_F(FieldRpcTest, StreamsAFieldInOrder) {
  Start();
  // More vertices than a chunk holds.
  const TriangleSoup soup = geodesic::test::Terrain(300, 300, 0.5, 1);
  const std::string digest = Upload(soup);
  const FieldReply reply = ComputeField(digest, 17);
  ASSERT_TRUE(reply.status.ok()) << reply.status.error_message();

  NoCheckpoint checkpoint;
  const auto direct = Solve(
      **Mesh::Build(soup), {.sources = {{VertexPoint{17}, 0}}}, {}, checkpoint);
  ASSERT_TRUE(direct.ok());
  EXPECT_EQ(reply.distances, direct->distances);

  ASSERT_GE(reply.messages.size(), 4);
  const v1::FieldHeader& header = reply.messages.front().header();
  EXPECT_EQ(header.mesh_digest(), digest);
  EXPECT_EQ(header.vertex_count(), soup.positions.size());
  EXPECT_EQ(header.algorithm(), v1::ALGORITHM_FWP_LIST);
  EXPECT_EQ(header.origin(), v1::FIELD_ORIGIN_COMPUTED);
  int stage = 0;  // header, progress, chunk, trailer
  for (const v1::ComputeFieldResponse& message : reply.messages) {
    EXPECT_GE(message.part_case(), stage);
    stage = message.part_case();
  }
  const v1::FieldTrailer& trailer = reply.messages.back().trailer();
  EXPECT_EQ(trailer.origin(), v1::FIELD_ORIGIN_COMPUTED);
  EXPECT_EQ(trailer.relative_tolerance(), 1e-10);
  EXPECT_EQ(trailer.server_version(), ServerVersion());
  EXPECT_EQ(trailer.statistics().windows_created(),
            direct->statistics.windows_created);
  EXPECT_GT(trailer.statistics().windows_propagated(), 0);
}

TEST_F(FieldRpcTest, TheCacheAnswersTheSecondTime) {
  Start();
  const std::string digest = Upload(geodesic::test::Icosphere(3));
  const FieldReply first = ComputeField(digest, 1);
  const FieldReply second = ComputeField(digest, 1);
  ASSERT_TRUE(second.status.ok());
  EXPECT_EQ(second.distances, first.distances);
  EXPECT_EQ(second.messages.front().header().origin(), v1::FIELD_ORIGIN_CACHED);
  EXPECT_EQ(second.messages.back().trailer().origin(), v1::FIELD_ORIGIN_CACHED);
  EXPECT_EQ(second.messages.back().trailer().statistics().windows_created(),
            first.messages.back().trailer().statistics().windows_created());
  // header, one chunk, trailer: no progress.
  EXPECT_EQ(second.messages.size(), 3);
  EXPECT_EQ(counters().solves_finished, 1);
}

TEST_F(FieldRpcTest, EveryAlgorithmAnswers) {
  Start();
  const std::string digest = Upload(geodesic::test::Icosphere(2));
  const std::vector<double> expected = ComputeField(digest, 0).distances;
  for (const auto algorithm :
       {v1::ALGORITHM_FWP_CH, v1::ALGORITHM_FWP_MMP, v1::ALGORITHM_ICH,
        v1::ALGORITHM_MMP, v1::ALGORITHM_CH, v1::ALGORITHM_LC_MMP,
        v1::ALGORITHM_LC_CH, v1::ALGORITHM_FWP_LIST}) {
    v1::ComputeFieldRequest request = FieldRequest(digest, 0);
    request.set_algorithm(algorithm);
    const FieldReply reply = ComputeField(request);
    ASSERT_TRUE(reply.status.ok()) << reply.status.error_message();
    EXPECT_EQ(reply.messages.front().header().algorithm(), algorithm);
    ASSERT_EQ(reply.distances.size(), expected.size());
    for (size_t v = 0; v < expected.size(); ++v) {
      EXPECT_NEAR(reply.distances[v], expected[v], 1e-10);
    }
  }
}

TEST_F(FieldRpcTest, UnknownMesh) {
  Start();
  const FieldReply reply = ComputeField(std::string(64, 'a'), 0);
  EXPECT_EQ(reply.status.error_code(), grpc::StatusCode::NOT_FOUND);
  EXPECT_THAT(reply.status.error_message(), HasSubstr("upload it again"));
}

// `header` comes before the solver is done, and progress while it runs.
TEST_F(FieldRpcTest, ProgressWhileItComputes) {
  Start(SmallServer(), /*held=*/true);
  const std::string digest = Upload(geodesic::test::Icosphere(2));
  const auto call = Open(digest, 0);
  ASSERT_TRUE(call->Read());
  EXPECT_TRUE(call->message.has_header());
  for (int i = 0; i < 5; ++i) {
    ASSERT_TRUE(call->Read());
    ASSERT_TRUE(call->message.has_progress());
    EXPECT_EQ(call->message.progress().live_windows(), 1);
  }
  solver_.LetGo();
  EXPECT_TRUE(call->End().ok());
  EXPECT_TRUE(call->message.has_trailer());
}

TEST_F(FieldRpcTest, EqualQueriesAreSolvedOnce) {
  Start(SmallServer(), /*held=*/true);
  const std::string digest = Upload(geodesic::test::Icosphere(2));
  std::vector<std::unique_ptr<OpenField>> calls;
  for (int i = 0; i < 5; ++i) {
    calls.push_back(Open(digest, 0));
    ASSERT_TRUE(calls.back()->Read());
    EXPECT_EQ(calls.back()->message.header().origin(),
              i == 0 ? v1::FIELD_ORIGIN_COMPUTED : v1::FIELD_ORIGIN_JOINED);
  }
  solver_.LetGo();
  for (const auto& call : calls) EXPECT_TRUE(call->End().ok());
  EXPECT_EQ(counters().solves_started, 1);
}

TEST_F(FieldRpcTest, AFullQueueSaysWhenToComeBack) {
  Start(SmallServer(), /*held=*/true);
  const std::string digest = Upload(geodesic::test::Icosphere(2));
  // Two run, two wait.
  std::vector<std::unique_ptr<OpenField>> calls;
  for (uint64_t vertex = 0; vertex < 4; ++vertex) {
    calls.push_back(Open(digest, vertex));
    ASSERT_TRUE(calls.back()->Read());
  }
  const FieldReply refused = ComputeField(digest, 4);
  EXPECT_EQ(refused.status.error_code(), grpc::StatusCode::RESOURCE_EXHAUSTED);
  const auto retry = test::RetryInfo(refused.status);
  ASSERT_TRUE(retry.has_value());
  EXPECT_GT(retry->retry_delay().seconds() + retry->retry_delay().nanos(), 0);
  solver_.LetGo();
  for (const auto& call : calls) EXPECT_TRUE(call->End().ok());
}

uint64_t ResidentBytes() {
  std::ifstream statm("/proc/self/statm");
  uint64_t total = 0;
  uint64_t resident = 0;
  statm >> total >> resident;
  return resident * static_cast<uint64_t>(sysconf(_SC_PAGESIZE));
}

// Readers that stall after the first chunk hold one message each, not their
// whole field: 64 times 4 MB would be 256 MB.
TEST_F(FieldRpcTest, SlowReadersTakeLittleMemory) {
  Start();
  TriangleSoup soup = test::Tetrahedron();
  soup.positions.resize(500'004, {7, 7, 7});
  const std::string digest = Upload(soup);
  ASSERT_TRUE(ComputeField(digest, 0).status.ok());

  // The client lives in this process too: it must not read ahead.
  fields_ = v1::FieldService::NewStub(SlowChannel(server_->port()));
  const uint64_t before = ResidentBytes();
  std::vector<std::unique_ptr<OpenField>> stalled;
  for (int i = 0; i < 64; ++i) {
    stalled.push_back(Open(digest, 0));
    ASSERT_TRUE(stalled.back()->Read());
    ASSERT_TRUE(stalled.back()->Read());
    ASSERT_TRUE(stalled.back()->message.has_chunk());
  }
  fields_ = v1::FieldService::NewStub(channel_);
  // Others are served meanwhile, and the server has had time to run ahead.
  for (int i = 0; i < 5; ++i) {
    EXPECT_EQ(ComputeField(digest, 0).distances.size(), 500'004);
  }
  const uint64_t after = ResidentBytes();
  EXPECT_LT(after > before ? after - before : 0, uint64_t{128} << 20);
  for (const auto& call : stalled) call->context.TryCancel();
  for (const auto& call : stalled) {
    EXPECT_EQ(call->reader->Finish().error_code(), grpc::StatusCode::CANCELLED);
  }
}

}  // namespace
}  // namespace geodesic::server
