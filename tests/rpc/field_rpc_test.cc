// FieldService.ComputeField.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "geodesic/solve.h"
#include "tests/engine/uploads.h"
#include "tests/rpc/questions_fixture.h"
#include "tests/support/curved_meshes.h"

namespace geodesic::server {
namespace {

using test::Euclid;
using test::FieldReply;
using test::kInfinity;
using test::OpenField;
using test::Values;
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

// Beyond one vertex and the whole mesh: places, targets, limits, precision,
// progressive fields.
class FieldQuestionsTest : public test::QuestionsTest {
 protected:
  // The bytes of the one chunk.
  static std::string Distances(
      const std::vector<v1::ComputeFieldResponse>& messages) {
    for (const auto& message : messages) {
      if (message.has_chunk()) return message.chunk().distances();
    }
    return "";
  }

  v1::ComputeFieldRequest Request() const { return FieldRequest(digest_, 0); }
};

TEST_F(FieldQuestionsTest, SourcesLieAnywhere) {
  v1::ComputeFieldRequest request;
  request.set_mesh_digest(digest_);
  SetEdge(3, 4, 0.25, *request.add_sources());
  const Point at_edge = {3.25, 0, 0};
  v1::FacePoint& face = *request.add_sources()->mutable_face();
  face.set_face(77);
  for (const double weight : {0.2, 0.3, 0.5}) face.add_weights(weight);
  Point in_face{};
  for (int i = 0; i < 3; ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      in_face[axis] +=
          face.weights(i) * soup_.positions[soup_.triangles[77][i]][axis];
    }
  }
  const FieldReply reply = ComputeField(request);
  ASSERT_TRUE(reply.status.ok()) << reply.status.error_message();
  for (size_t v = 0; v < soup_.positions.size(); ++v) {
    EXPECT_NEAR(reply.distances[v],
                std::min(Euclid(soup_.positions[v], at_edge),
                         Euclid(soup_.positions[v], in_face)),
                1e-10);
  }
}

TEST_F(FieldQuestionsTest, ACurveIsASource) {
  v1::ComputeFieldRequest request;
  request.set_mesh_digest(digest_);
  v1::Curve& curve = *request.add_sources()->mutable_curve();
  // Along the lower side from x = 2 to x = 6.
  for (uint64_t x = 2; x <= 6; ++x) curve.add_points()->set_vertex(x);
  const FieldReply reply = ComputeField(request);
  ASSERT_TRUE(reply.status.ok()) << reply.status.error_message();
  for (size_t v = 0; v < soup_.positions.size(); ++v) {
    const Point& p = soup_.positions[v];
    const Point nearest = {std::min(std::max(p[0], 2.0), 6.0), 0, 0};
    EXPECT_NEAR(reply.distances[v], Euclid(p, nearest), 1e-10);
  }
}

TEST_F(FieldQuestionsTest, TargetsComeInTheirOrder) {
  v1::ComputeFieldRequest request = Request();
  request.add_targets()->set_vertex(5);
  SetEdge(8, 7, 0.5, *request.add_targets());
  request.add_targets()->set_vertex(2);
  for (const bool cached : {false, true}) {
    const auto messages = Messages(request);
    EXPECT_EQ(messages.front().header().target_count(), 3);
    EXPECT_EQ(messages.front().header().origin(),
              cached ? v1::FIELD_ORIGIN_CACHED : v1::FIELD_ORIGIN_COMPUTED);
    ASSERT_GE(messages.size(), 4);
    const v1::TargetChunk& targets = messages[messages.size() - 2].targets();
    EXPECT_EQ(targets.offset(), 0);
    const auto distances = Values<double>(targets.distances());
    ASSERT_EQ(distances.size(), 3);
    EXPECT_NEAR(distances[0], 5, 1e-10);
    EXPECT_NEAR(distances[1], 7.5, 1e-10);
    EXPECT_NEAR(distances[2], 2, 1e-10);
  }
}

TEST_F(FieldQuestionsTest, ARadiusCutsWhatIsSent) {
  v1::ComputeFieldRequest request = Request();
  // The whole field first: the cut answer then comes from the cache.
  for (const bool cached : {false, true}) {
    if (cached) Messages(Request());
    request.set_radius(cached ? 3.5 : 4);
    const FieldReply reply = ComputeField(request);
    for (size_t v = 0; v < soup_.positions.size(); ++v) {
      const double expected = Euclid(soup_.positions[0], soup_.positions[v]);
      EXPECT_EQ(reply.distances[v] == kInfinity, expected > request.radius());
    }
    EXPECT_EQ(reply.messages.back().trailer().settled_radius(),
              request.radius());
  }
  // A radius beyond everything is no limit.
  request.set_radius(1000);
  const FieldReply reply = ComputeField(request);
  EXPECT_EQ(reply.messages.back().trailer().settled_radius(), kInfinity);
}

TEST_F(FieldQuestionsTest, SinglePrecisionIsTheNearest) {
  v1::ComputeFieldRequest request = Request();
  const auto exact = Values<double>(Distances(Messages(request)));
  request.set_value_type(v1::VALUE_TYPE_FLOAT32);
  const auto messages = Messages(request);
  EXPECT_EQ(messages[0].header().value_type(), v1::VALUE_TYPE_FLOAT32);
  const auto single = Values<float>(Distances(messages));
  ASSERT_EQ(single.size(), exact.size());
  for (size_t v = 0; v < exact.size(); ++v) {
    EXPECT_EQ(single[v], static_cast<float>(exact[v]));
  }
}

TEST_F(FieldQuestionsTest, AProgressiveFieldComesInOrder) {
  const TriangleSoup soup = geodesic::test::Icosphere(5);
  const std::string digest = Upload(soup);
  v1::ComputeFieldRequest request = FieldRequest(digest, 0);
  request.set_progressive(true);
  std::vector<double> distances(soup.positions.size(), kInfinity);
  double last = 0;
  uint64_t count = 0;
  int chunks = 0;
  const auto messages = Messages(request);
  for (const v1::ComputeFieldResponse& message : messages) {
    EXPECT_FALSE(message.has_chunk());
    if (!message.has_settled()) continue;
    ++chunks;
    EXPECT_EQ(message.settled().offset(), count);
    const auto vertices = Values<uint32_t>(message.settled().vertices());
    const auto values = Values<double>(message.settled().distances());
    ASSERT_EQ(vertices.size(), values.size());
    count += vertices.size();
    for (size_t i = 0; i < vertices.size(); ++i) {
      EXPECT_EQ(distances[vertices[i]], kInfinity);  // once only
      EXPECT_GE(values[i], last);
      distances[vertices[i]] = last = values[i];
    }
  }
  EXPECT_EQ(count, soup.positions.size());
  // It took several, so some came before the end.
  EXPECT_GT(chunks, 1);
  EXPECT_EQ(distances, ComputeField(digest, 0).distances);
  EXPECT_EQ(messages.back().trailer().settled_radius(), kInfinity);
}

TEST_F(FieldQuestionsTest, WhatASettledChunkSaidStaysTrueAfterCancelling) {
  const TriangleSoup soup = geodesic::test::Icosphere(6);
  const std::string digest = Upload(soup);
  v1::ComputeFieldRequest request = FieldRequest(digest, 0);
  request.set_progressive(true);
  const auto call = Open(request);
  do {
    ASSERT_TRUE(call->Read());
  } while (!call->message.has_settled());
  const v1::SettledChunk settled = call->message.settled();
  const auto vertices = Values<uint32_t>(settled.vertices());
  const auto values = Values<double>(settled.distances());
  call->context.TryCancel();
  EXPECT_EQ(call->End().error_code(), grpc::StatusCode::CANCELLED);
  const std::vector<double> whole = ComputeField(digest, 0).distances;
  for (size_t i = 0; i < vertices.size(); ++i) {
    EXPECT_EQ(values[i], whole[vertices[i]]);
  }
}

TEST_F(FieldQuestionsTest, WrongArgumentsAreNamed) {
  ExpectFaults(
      Request(),
      {{"sources {}", "sources[1]"},
       {"sources { vertex: 121 }", "sources[1].vertex"},
       {"sources { vertex: 1099511627776 }", "sources[1].vertex"},
       {"sources { vertex: 0 offset: -1 }", "sources[1].offset"},
       {"sources { vertex: 0 offset: inf }", "sources[1].offset"},
       {"sources { vertex: 0 offset: nan }", "sources[1].offset"},
       {"sources { edge { from: 0 to: 5 } }", "sources[1].edge"},
       {"sources { edge { from: 0 to: 1000 } }", "sources[1].edge.to"},
       {"sources { edge { from: 0 to: 1 t: 1.5 } }", "sources[1].edge.t"},
       {"sources { face { weights: 1 } }", "sources[1].face.weights"},
       {"sources { face { weights: [1, 1, 0] } }", "sources[1].face.weights"},
       {"sources { face { weights: [-1, 1, 0] } }",
        "sources[1].face.weights[0]"},
       {"sources { face { face: 1000 weights: [1, 0, 0] } }",
        "sources[1].face.face"},
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
       {"targets { vertex: 1 } stop_after_targets: 2", "stop_after_targets"},
       {"targets { vertex: 1 } stop_after_targets: 18446744073709551615",
        "stop_after_targets"},
       {"radius: -1", "radius"},
       {"value_type: 9", "value_type"},
       {"quantities: 9", "quantities[0]"},
       {"quantities: FIELD_QUANTITY_GRADIENT progressive: true",
        "quantities"}});
  ExpectUsual(Request());
  v1::ComputeFieldRequest request = Request();
  request.clear_sources();
  EXPECT_EQ(Fault(request), "sources");
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
