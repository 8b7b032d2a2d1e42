// ComputeField.

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "geodesic/solve.h"
#include "tests/engine/uploads.h"
#include "tests/rpc/questions_fixture.h"
#include "tests/support/meshes/curved_meshes.h"

namespace geodesic::server {
namespace {

using test::Euclid;
using test::kInfinity;
using test::OpenCall;
using test::Reply;

using FieldRpcTest = test::RpcTest;

TEST_F(FieldRpcTest, StreamsAFieldInOrder) {
  Start();
  // More vertices than a message holds.
  const TriangleSoup soup = geodesic::test::Terrain(300, 300, 0.5, 1);
  const std::string digest = Upload(soup);
  const Reply reply = Ask(digest, 17);
  ASSERT_TRUE(reply.status.ok()) << reply.status.error_message();

  NoCheckpoint checkpoint;
  const auto direct = Solve(
      **Mesh::Build(soup), {.sources = {{VertexPoint{17}, 0}}}, {}, checkpoint);
  ASSERT_TRUE(direct.ok());
  EXPECT_EQ(reply.Values<double>("distance"), direct->distances);
  EXPECT_GT(reply.pieces(), 1);

  const v1::AnswerHeader& header = reply.header();
  EXPECT_EQ(header.mesh_digest(), digest);
  EXPECT_EQ(header.vertex_count(), soup.positions.size());
  EXPECT_EQ(header.algorithm(), v1::ALGORITHM_FWP_LIST);
  EXPECT_EQ(header.origin(), v1::ANSWER_ORIGIN_COMPUTED);
  EXPECT_EQ(header.server_version(), ServerVersion());
  const v1::AnswerTrailer& trailer = reply.trailer();
  EXPECT_EQ(trailer.origin(), v1::ANSWER_ORIGIN_COMPUTED);
  EXPECT_EQ(trailer.relative_tolerance(), 1e-10);
  EXPECT_EQ(trailer.statistics().windows_created(),
            direct->statistics.windows_created);
  EXPECT_GT(trailer.statistics().windows_propagated(), 0);
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
  std::vector<std::unique_ptr<OpenCall>> calls;
  for (int i = 0; i < 5; ++i) {
    calls.push_back(Open(digest, 0));
    ASSERT_TRUE(calls.back()->Read());
    EXPECT_EQ(calls.back()->message.header().origin(),
              i == 0 ? v1::ANSWER_ORIGIN_COMPUTED : v1::ANSWER_ORIGIN_JOINED);
  }
  solver_.LetGo();
  for (const auto& call : calls) EXPECT_TRUE(call->End().ok());
  EXPECT_EQ(server_->engine().counters().solves_started, 1);
  EXPECT_EQ(server_->engine().counters().queries_joined, 4);
}

uint64_t ResidentBytes() {
  std::ifstream statm("/proc/self/statm");
  uint64_t total = 0;
  uint64_t resident = 0;
  statm >> total >> resident;
  return resident * static_cast<uint64_t>(sysconf(_SC_PAGESIZE));
}

// Readers that stall after the first blocks hold one message each, not their
// whole field: 64 times 4 MB would be 256 MB.
TEST_F(FieldRpcTest, SlowReadersTakeLittleMemory) {
  Start();
  TriangleSoup soup = test::Tetrahedron();
  soup.positions.resize(500'004, {7, 7, 7});
  const std::string digest = Upload(soup);
  ASSERT_TRUE(Ask(digest, 0).status.ok());

  // The client lives in this process too: it must not read ahead.
  questions_ = v1::QuestionService::NewStub(SlowChannel(server_->port()));
  const uint64_t before = ResidentBytes();
  std::vector<std::unique_ptr<OpenCall>> stalled;
  for (int i = 0; i < 64; ++i) {
    stalled.push_back(Open(digest, 0));
    do {
      ASSERT_TRUE(stalled.back()->Read());
    } while (stalled.back()->message.blocks().empty());
  }
  questions_ = v1::QuestionService::NewStub(channel_);
  // Others are served meanwhile, and the server has had time to run ahead.
  for (int i = 0; i < 5; ++i) {
    EXPECT_TRUE(Ask(digest, 0).status.ok());
  }
  const uint64_t after = ResidentBytes();
  EXPECT_LT(after > before ? after - before : 0, uint64_t{128} << 20);
  for (const auto& call : stalled) call->context.TryCancel();
  for (const auto& call : stalled) {
    EXPECT_EQ(call->reader->Finish().error_code(), grpc::StatusCode::CANCELLED);
  }
}

// Beyond the distances of the whole mesh: targets, limits, quantities,
// progressive fields.
class FieldQuestionsTest : public test::QuestionsTest {
 protected:
  v1::ComputeFieldRequest Request() const { return FieldRequest(digest_, 0); }
};

// All its parts.
TEST_F(FieldQuestionsTest, ASmallAnswerThatIsThereIsOneMessage) {
  v1::ComputeFieldRequest request = Request();
  request.add_targets()->set_vertex(5);
  SetEdge(8, 7, 0.5, *request.add_targets());
  request.add_targets()->set_vertex(2);
  Answered(request);
  const Reply reply = Answered(request);
  EXPECT_EQ(reply.messages.size(), 1);
  const auto distances = reply.Values<double>("target_distance");
  ASSERT_EQ(distances.size(), 3);
  EXPECT_NEAR(distances[0], 5, 1e-10);
  EXPECT_NEAR(distances[1], 7.5, 1e-10);
  EXPECT_NEAR(distances[2], 2, 1e-10);
  EXPECT_EQ(reply.header().origin(), v1::ANSWER_ORIGIN_CACHED);
  EXPECT_EQ(reply.trailer().origin(), v1::ANSWER_ORIGIN_CACHED);
  EXPECT_EQ(reply.Values<double>("distance").size(), soup_.positions.size());
}

// Wherever the solver stopped, and whatever the cache has.
TEST_F(FieldQuestionsTest, TheLastTargetCutsWhatIsSent) {
  v1::ComputeFieldRequest request = Request();
  request.add_targets()->set_vertex(5);
  request.add_targets()->set_vertex(2);
  request.set_stop_after_targets(1);
  for (const bool cached : {false, true}) {
    if (cached) Answered(Request());
    const Reply reply = Answered(request);
    const auto distances = reply.Values<double>("distance");
    EXPECT_EQ(reply.trailer().settled_radius(), distances[2]);
    for (size_t v = 0; v < soup_.positions.size(); ++v) {
      const double expected = Euclid(soup_.positions[0], soup_.positions[v]);
      EXPECT_EQ(distances[v] == kInfinity, expected > 2) << v;
    }
  }
}

TEST_F(FieldQuestionsTest, LabelsAndGradientsEndWhereDistancesDo) {
  v1::ComputeFieldRequest request;
  request.set_mesh_digest(digest_);
  // Numbered against the order of their vertices.
  request.add_sources()->set_vertex(Vertex(9, 8));
  request.add_sources()->set_vertex(Vertex(1, 2));
  request.add_quantities(v1::FIELD_QUANTITY_NEAREST_SOURCE);
  request.add_quantities(v1::FIELD_QUANTITY_GRADIENT);
  const std::vector<Point> sources = {{9, 8, 0}, {1, 2, 0}};
  // A radius beyond everything is no limit.
  for (const double radius : {kInfinity, 1000.0, 5.1, 3.1}) {
    if (!std::isinf(radius)) request.set_radius(radius);
    const Reply reply = Answered(request);
    EXPECT_EQ(reply.trailer().settled_radius(),
              radius < 1000 ? radius : kInfinity);
    const auto distances = reply.Values<double>("distance");
    const auto nearest = reply.Values<uint32_t>("nearest_source");
    const auto gradients = reply.Values<Point>("gradient");
    ASSERT_EQ(distances.size(), soup_.positions.size());
    for (size_t v = 0; v < distances.size(); ++v) {
      const Point& p = soup_.positions[v];
      const double d[] = {Euclid(p, sources[0]), Euclid(p, sources[1])};
      const double least = std::min(d[0], d[1]);
      if (least > radius) {
        EXPECT_EQ(distances[v], kInfinity);
        EXPECT_EQ(nearest[v], 0xffffffff);
        EXPECT_EQ(gradients[v], Point());
        continue;
      }
      EXPECT_NEAR(distances[v], least, 1e-10);
      EXPECT_NEAR(d[nearest[v]], least, 1e-10);
      EXPECT_NEAR(Euclid(gradients[v], Point()), least == 0 ? 0 : 1, 1e-10);
    }
  }
  // The traced field answers those who want distances alone.
  request.clear_quantities();
  request.clear_radius();
  EXPECT_EQ(Answered(request).header().origin(), v1::ANSWER_ORIGIN_CACHED);
}

TEST_F(FieldQuestionsTest, AProgressiveFieldComesInOrder) {
  const TriangleSoup soup = geodesic::test::Icosphere(5);
  const std::string digest = Upload(soup);
  v1::ComputeFieldRequest request = FieldRequest(digest, 0);
  request.set_progressive(true);
  const Reply reply = Answered(request);
  EXPECT_EQ(reply.header().arrays_size(), 2);
  const auto vertices = reply.Values<uint32_t>("settled_vertex");
  const auto values = reply.Values<double>("settled_distance");
  ASSERT_EQ(vertices.size(), soup.positions.size());
  ASSERT_EQ(values.size(), vertices.size());
  EXPECT_TRUE(std::ranges::is_sorted(values));
  std::vector<double> distances(vertices.size(), kInfinity);
  for (size_t i = 0; i < vertices.size(); ++i) {
    EXPECT_EQ(distances[vertices[i]], kInfinity);  // once only
    distances[vertices[i]] = values[i];
  }
  // It took several messages, so some came before the end.
  EXPECT_GT(reply.pieces(), 1);
  EXPECT_EQ(distances, Ask(digest, 0).Values<double>("distance"));
  EXPECT_EQ(reply.trailer().settled_radius(), kInfinity);
}

TEST_F(FieldQuestionsTest, WrongArgumentsAreNamed) {
  ExpectFaults(
      Request(),
      {{"sources {}", "sources[1]"},
       {"sources { vertex: 121 }", "sources[1].vertex"},
       {"sources { vertex: 1099511627776 }", "sources[1].vertex"},
       {"sources { vertex: 0 offset: -1 }", "sources[1].offset"},
       {"sources { face { weights: 1 } }", "sources[1].face.weights"},
       {"sources { face { face: 1099511627776 weights: [1, 0, 0] } }",
        "sources[1].face.face"},
       {"sources { curve {} }", "sources[1].curve.points"},
       {"sources { curve { points { vertex: 0 } points { vertex: 50 } } }",
        "sources[1].curve.points[1]"},
       // Behind a curve, a source still has its own place in the list.
       {"sources { curve { points { vertex: 0 } points { vertex: 1 } } } "
        "sources { vertex: 1000 }",
        "sources[2].vertex"},
       {"sources { curve { points { vertex: 0 } points { vertex: 1 } } "
        "offset: -1 }",
        "sources[1].offset"},
       {"targets { vertex: 1000 }", "targets[0].vertex"},
       {"targets {}", "targets[0]"},
       {"targets { vertex: 1 } stop_after_targets: 0", "stop_after_targets"},
       {"targets { vertex: 1 } stop_after_targets: 2", "stop_after_targets"},
       {"targets { vertex: 1 } stop_after_targets: 18446744073709551615",
        "stop_after_targets"},
       {"radius: -1", "radius"},
       {"priority: 99", "priority"},
       {"algorithm: 99", "algorithm"},
       {"value_type: 9", "value_type"},
       {"quantities: 9", "quantities[0]"},
       {"quantities: FIELD_QUANTITY_GRADIENT progressive: true",
        "quantities"}});
  v1::ComputeFieldRequest request = Request();
  request.clear_sources();
  EXPECT_EQ(Fault(request), "sources");
  request = Request();
  request.set_mesh_digest("horse");
  EXPECT_EQ(Fault(request), "mesh_digest");
  request.set_mesh_digest(std::string(64, 'a'));
  EXPECT_EQ(CodeOf(request), grpc::StatusCode::NOT_FOUND);
}

TEST_F(FieldQuestionsTest, CountsHaveLimits) {
  const auto expect_exhausted = [&](const v1::ComputeFieldRequest& request) {
    const grpc::Status status = Ask(request).status;
    EXPECT_EQ(status.error_code(), grpc::StatusCode::RESOURCE_EXHAUSTED);
    EXPECT_FALSE(test::RetryInfo(status).has_value());
  };
  v1::ComputeFieldRequest request = Request();
  for (int i = 0; i < 101; ++i) request.add_targets();
  expect_exhausted(request);
  request = Request();
  for (int i = 0; i < 10; ++i) request.add_sources();
  expect_exhausted(request);
  request = Request();
  v1::Curve& curve = *request.add_sources()->mutable_curve();
  for (int i = 0; i < 11; ++i) curve.add_points();
  expect_exhausted(request);
}

}  // namespace
}  // namespace geodesic::server
