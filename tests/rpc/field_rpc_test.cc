// FieldService.ComputeField.

#include <gmock/gmock.h>
#include <grpcpp/create_channel.h>
#include <grpcpp/security/credentials.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <fstream>
#include <limits>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "geodesic/solve.h"
#include "tests/engine/uploads.h"
#include "tests/rpc/rpc_fixture.h"
#include "tests/support/curved_meshes.h"

namespace geodesic::server {
namespace {

using test::FieldAtFault;
using test::FieldReply;
using ::testing::HasSubstr;

constexpr std::chrono::seconds kLong{120};

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
    grpc::ClientContext context;
    const FieldReply reply = ComputeField(request, context);
    ASSERT_TRUE(reply.status.ok()) << reply.status.error_message();
    EXPECT_EQ(reply.messages.front().header().algorithm(), algorithm);
    ASSERT_EQ(reply.distances.size(), expected.size());
    for (size_t v = 0; v < expected.size(); ++v) {
      EXPECT_NEAR(reply.distances[v], expected[v], 1e-10);
    }
  }
}

TEST_F(FieldRpcTest, SourcesHaveOffsets) {
  Start();
  v1::ComputeFieldRequest request =
      FieldRequest(Upload(test::Tetrahedron()), 0);
  request.mutable_sources(0)->set_offset(0.25);
  request.add_sources()->set_vertex(1);
  grpc::ClientContext context;
  const FieldReply reply = ComputeField(request, context);
  ASSERT_EQ(reply.distances.size(), 4);
  EXPECT_EQ(reply.distances[0], 0.25);
  EXPECT_EQ(reply.distances[1], 0);
  EXPECT_DOUBLE_EQ(reply.distances[2], 1.25);
  EXPECT_DOUBLE_EQ(reply.distances[3], 1.25);
}

TEST_F(FieldRpcTest, BadRequests) {
  Start();
  const std::string digest = Upload(test::Tetrahedron());
  const auto fault = [&](const v1::ComputeFieldRequest& request) {
    grpc::ClientContext context;
    const FieldReply reply = ComputeField(request, context);
    EXPECT_EQ(reply.status.error_code(), grpc::StatusCode::INVALID_ARGUMENT);
    EXPECT_TRUE(reply.messages.empty());
    return FieldAtFault(reply.status);
  };
  EXPECT_EQ(fault(FieldRequest("horse", 0)), "mesh_digest");
  EXPECT_EQ(fault(FieldRequest(digest, 4)), "sources[0].vertex");
  EXPECT_EQ(fault(FieldRequest(digest, uint64_t{1} << 40)),
            "sources[0].vertex");
  v1::ComputeFieldRequest request = FieldRequest(digest, 0);
  request.clear_sources();
  EXPECT_EQ(fault(request), "sources");
  for (const double offset : {-1.0, std::numeric_limits<double>::infinity(),
                              std::numeric_limits<double>::quiet_NaN()}) {
    request = FieldRequest(digest, 0);
    request.mutable_sources(0)->set_offset(offset);
    EXPECT_EQ(fault(request), "sources[0].offset");
  }
  request = FieldRequest(digest, 0);
  request.set_algorithm(static_cast<v1::Algorithm>(9));
  EXPECT_EQ(fault(request), "algorithm");
}

TEST_F(FieldRpcTest, UnknownMesh) {
  Start();
  const FieldReply reply = ComputeField(std::string(64, 'a'), 0);
  EXPECT_EQ(reply.status.error_code(), grpc::StatusCode::NOT_FOUND);
  EXPECT_THAT(reply.status.error_message(), HasSubstr("upload it again"));
}

TEST_F(FieldRpcTest, TooManySources) {
  Start();
  v1::ComputeFieldRequest request =
      FieldRequest(Upload(test::Tetrahedron()), 0);
  for (int i = 0; i < 10; ++i) request.add_sources()->set_vertex(0);
  grpc::ClientContext context;
  const FieldReply reply = ComputeField(request, context);
  EXPECT_EQ(reply.status.error_code(), grpc::StatusCode::RESOURCE_EXHAUSTED);
  EXPECT_FALSE(test::RetryInfo(reply.status).has_value());
}

// `header` comes before the solver is done, and progress while it runs.
TEST_F(FieldRpcTest, ProgressWhileItComputes) {
  Start(SmallServer(), /*held=*/true);
  const std::string digest = Upload(geodesic::test::Icosphere(2));
  grpc::ClientContext context;
  const auto reader = fields_->ComputeField(&context, FieldRequest(digest, 0));
  v1::ComputeFieldResponse message;
  ASSERT_TRUE(reader->Read(&message));
  EXPECT_TRUE(message.has_header());
  for (int i = 0; i < 5; ++i) {
    ASSERT_TRUE(reader->Read(&message));
    ASSERT_TRUE(message.has_progress());
    EXPECT_EQ(message.progress().live_windows(), 1);
  }
  solver_.LetGo();
  while (reader->Read(&message)) {
  }
  EXPECT_TRUE(message.has_trailer());
  EXPECT_TRUE(reader->Finish().ok());
}

TEST_F(FieldRpcTest, EqualQueriesAreSolvedOnce) {
  Start(SmallServer(), /*held=*/true);
  const std::string digest = Upload(geodesic::test::Icosphere(2));
  std::vector<std::unique_ptr<grpc::ClientContext>> contexts;
  std::vector<std::unique_ptr<grpc::ClientReader<v1::ComputeFieldResponse>>>
      readers;
  v1::ComputeFieldResponse message;
  for (int i = 0; i < 5; ++i) {
    contexts.push_back(std::make_unique<grpc::ClientContext>());
    readers.push_back(
        fields_->ComputeField(contexts.back().get(), FieldRequest(digest, 0)));
    ASSERT_TRUE(readers.back()->Read(&message));
    EXPECT_EQ(message.header().origin(),
              i == 0 ? v1::FIELD_ORIGIN_COMPUTED : v1::FIELD_ORIGIN_JOINED);
  }
  solver_.LetGo();
  for (const auto& reader : readers) {
    while (reader->Read(&message)) {
    }
    EXPECT_TRUE(reader->Finish().ok());
  }
  EXPECT_EQ(counters().solves_started, 1);
}

TEST_F(FieldRpcTest, CancellingStopsTheSolver) {
  Start();
  const std::string digest = Upload(geodesic::test::Icosphere(7));
  grpc::ClientContext context;
  const auto reader = fields_->ComputeField(&context, FieldRequest(digest, 0));
  v1::ComputeFieldResponse message;
  do {
    ASSERT_TRUE(reader->Read(&message));
  } while (!message.has_progress());
  context.TryCancel();
  while (reader->Read(&message)) {
  }
  EXPECT_EQ(reader->Finish().error_code(), grpc::StatusCode::CANCELLED);
  EXPECT_TRUE(server_->engine().WaitIdle(kLong));
  EXPECT_EQ(counters().solves_stopped, 1);
  EXPECT_EQ(counters().solves_finished, 0);
}

TEST_F(FieldRpcTest, CancellingInTheQueueTakesTheJobOut) {
  Start(SmallServer(), /*held=*/true);
  const std::string digest = Upload(test::Tetrahedron());
  v1::ComputeFieldResponse message;
  std::vector<std::unique_ptr<grpc::ClientContext>> contexts;
  std::vector<std::unique_ptr<grpc::ClientReader<v1::ComputeFieldResponse>>>
      readers;
  for (uint64_t vertex = 0; vertex < 3; ++vertex) {
    contexts.push_back(std::make_unique<grpc::ClientContext>());
    readers.push_back(fields_->ComputeField(contexts.back().get(),
                                            FieldRequest(digest, vertex)));
    ASSERT_TRUE(readers.back()->Read(&message));
  }
  solver_.WaitForStarts(2);
  contexts[2]->TryCancel();
  EXPECT_EQ(readers[2]->Finish().error_code(), grpc::StatusCode::CANCELLED);
  // The client knows at once, the server a little later.
  while (server_->engine().scheduler().queued() > 0) std::this_thread::yield();
  solver_.LetGo();
  for (int i = 0; i < 2; ++i) {
    while (readers[i]->Read(&message)) {
    }
    EXPECT_TRUE(readers[i]->Finish().ok());
  }
  EXPECT_TRUE(server_->engine().WaitIdle(kLong));
  EXPECT_EQ(counters().solves_finished, 2);
}

TEST_F(FieldRpcTest, ADeadlineStopsTheSolver) {
  Start(SmallServer(), /*held=*/true);
  const std::string digest = Upload(test::Tetrahedron());
  grpc::ClientContext context;
  context.set_deadline(std::chrono::system_clock::now() +
                       std::chrono::milliseconds(300));
  const FieldReply reply = ComputeField(FieldRequest(digest, 0), context);
  EXPECT_EQ(reply.status.error_code(), grpc::StatusCode::DEADLINE_EXCEEDED);
  EXPECT_TRUE(server_->engine().WaitIdle(kLong));
  EXPECT_EQ(counters().solves_finished, 0);
}

TEST_F(FieldRpcTest, AFullQueueSaysWhenToComeBack) {
  Start(SmallServer(), /*held=*/true);
  const std::string digest = Upload(geodesic::test::Icosphere(2));
  std::vector<std::unique_ptr<grpc::ClientContext>> contexts;
  std::vector<std::unique_ptr<grpc::ClientReader<v1::ComputeFieldResponse>>>
      readers;
  v1::ComputeFieldResponse message;
  // Two run, two wait.
  for (uint64_t vertex = 0; vertex < 4; ++vertex) {
    contexts.push_back(std::make_unique<grpc::ClientContext>());
    readers.push_back(fields_->ComputeField(contexts.back().get(),
                                            FieldRequest(digest, vertex)));
    ASSERT_TRUE(readers.back()->Read(&message));
  }
  const FieldReply refused = ComputeField(digest, 4);
  EXPECT_EQ(refused.status.error_code(), grpc::StatusCode::RESOURCE_EXHAUSTED);
  const auto retry = test::RetryInfo(refused.status);
  ASSERT_TRUE(retry.has_value());
  EXPECT_GT(retry->retry_delay().seconds() + retry->retry_delay().nanos(), 0);
  solver_.LetGo();
  for (const auto& reader : readers) {
    while (reader->Read(&message)) {
    }
    EXPECT_TRUE(reader->Finish().ok());
  }
}

TEST_F(FieldRpcTest, UnreachableVerticesAreInfinitelyFar) {
  Start();
  TriangleSoup soup = test::Tetrahedron();
  soup.positions.push_back({5, 5, 5});
  const FieldReply reply = ComputeField(Upload(soup), 0);
  ASSERT_EQ(reply.distances.size(), 5);
  EXPECT_EQ(reply.distances[4], std::numeric_limits<double>::infinity());
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
  grpc::ChannelArguments arguments;
  arguments.SetInt(GRPC_ARG_HTTP2_BDP_PROBE, 0);
  arguments.SetInt(GRPC_ARG_HTTP2_STREAM_LOOKAHEAD_BYTES, 65536);
  const auto slow = v1::FieldService::NewStub(
      grpc::CreateCustomChannel(absl::StrCat("127.0.0.1:", server_->port()),
                                grpc::InsecureChannelCredentials(), arguments));

  const uint64_t before = ResidentBytes();
  std::vector<std::unique_ptr<grpc::ClientContext>> contexts;
  std::vector<std::unique_ptr<grpc::ClientReader<v1::ComputeFieldResponse>>>
      stalled;
  v1::ComputeFieldResponse message;
  for (int i = 0; i < 64; ++i) {
    contexts.push_back(std::make_unique<grpc::ClientContext>());
    stalled.push_back(
        slow->ComputeField(contexts.back().get(), FieldRequest(digest, 0)));
    ASSERT_TRUE(stalled.back()->Read(&message));
    ASSERT_TRUE(stalled.back()->Read(&message));
    ASSERT_TRUE(message.has_chunk());
  }
  // Others are served meanwhile, and the server has had time to run ahead.
  for (int i = 0; i < 5; ++i) {
    EXPECT_EQ(ComputeField(digest, 0).distances.size(), 500'004);
  }
  const uint64_t after = ResidentBytes();
  EXPECT_LT(after > before ? after - before : 0, uint64_t{128} << 20);
  for (const auto& context : contexts) context->TryCancel();
  for (const auto& reader : stalled) {
    EXPECT_EQ(reader->Finish().error_code(), grpc::StatusCode::CANCELLED);
  }
}

}  // namespace
}  // namespace geodesic::server
