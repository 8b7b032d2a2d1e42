// PairService: how answers are divided and requests refused.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "tests/rpc/questions_fixture.h"
#include "tests/support/http_get.h"
#include "tests/support/until.h"

namespace geodesic::server {
namespace {

using test::Euclid;
using test::Values;

class PairRpcTest : public test::QuestionsTest {
 protected:
  v1::ComputePairsRequest Pairs() const {
    v1::ComputePairsRequest request;
    request.set_mesh_digest(digest_);
    return request;
  }

  v1::ComputePairsRequest OnePair() const {
    v1::ComputePairsRequest request = Pairs();
    v1::PointPair& pair = *request.add_pairs();
    pair.mutable_source()->set_vertex(Vertex(0, 0));
    SetEdge(Vertex(4, 3), Vertex(5, 3), 0.5, *pair.mutable_target());
    return request;
  }
};

TEST_F(PairRpcTest, AnswersOnePair) {
  const auto messages = Messages(OnePair());
  const v1::PairsHeader& header = messages.front().header();
  EXPECT_EQ(header.answer().mesh_digest(), digest_);
  EXPECT_EQ(header.answer().vertex_count(), soup_.positions.size());
  EXPECT_EQ(header.answer().algorithm(), v1::ALGORITHM_FWP_LIST);
  EXPECT_EQ(header.pair_count(), 1);
  EXPECT_EQ(header.value_type(), v1::VALUE_TYPE_FLOAT64);
  const v1::PairsTrailer& trailer = messages.back().trailer();
  EXPECT_EQ(trailer.answer().item_count(), 1);
  EXPECT_GT(trailer.answer().windows_propagated(), 0);
  EXPECT_EQ(trailer.pairs_searched(), 1);
  const auto& chunk = messages[messages.size() - 2].chunk();
  EXPECT_EQ(Values<double>(chunk.distances()),
            std::vector<double>{std::hypot(4.5, 3)});
}

TEST_F(PairRpcTest, CertifiesWhatIsWithinATolerance) {
  v1::ComputePairsRequest request = OnePair();
  request.set_tolerance(0.01);
  auto messages = Messages(request);
  EXPECT_EQ(messages.front().header().answer().relative_tolerance(), 0.01);
  EXPECT_EQ(messages.back().trailer().answer().certified_error(), 0.01);
  // Paths are exact.
  request.set_paths(true);
  messages = Messages(request);
  EXPECT_FALSE(messages.back().trailer().answer().has_certified_error());
}

TEST_F(PairRpcTest, PathsFollowTheirChunk) {
  v1::ComputePairsRequest request = Pairs();
  for (uint32_t i = 0; i < 200; ++i) {
    request.add_vertex_pairs(i % 3);  // fields would cost less
    request.add_vertex_pairs(i * 31 % soup_.positions.size());
  }
  request.set_paths(true);
  uint64_t distances = 0, paths = 0, due = 0;
  const auto messages = Messages(request);
  for (const auto& message : messages) {
    if (message.has_chunk()) {
      EXPECT_EQ(message.chunk().offset(), distances);
      EXPECT_EQ(paths, distances);
      distances += message.chunk().distances().size() / sizeof(double);
    }
    if (!message.has_path()) continue;
    const v1::PairPath& path = message.path();
    EXPECT_EQ(path.pair(), paths);
    if (due == 0) due = path.piece().point_count();
    due -= path.piece().points_size();
    if (due == 0) ++paths;
    EXPECT_LE(paths, distances);
  }
  EXPECT_EQ(distances, 200);
  EXPECT_EQ(paths, 200);
  EXPECT_EQ(messages.back().trailer().pairs_searched(), 200);
}

TEST_F(PairRpcTest, ChunksComeInOrderWhateverAnswersThem) {
  v1::ComputePairsRequest request = Pairs();
  const uint32_t vertices = soup_.positions.size();
  for (uint32_t i = 0; i < 2000; ++i) {
    // Every other pair has a common end.
    request.add_vertex_pairs(i % 2 == 0 ? i * 7 % vertices : 60);
    request.add_vertex_pairs(i * 31 % vertices);
  }
  request.set_value_type(v1::VALUE_TYPE_FLOAT32);
  std::vector<float> distances;
  uint64_t finished = 0;
  const auto messages = Messages(request);
  for (const auto& message : messages) {
    if (message.has_progress()) {
      EXPECT_GE(message.progress().pairs_finished(), finished);
      finished = message.progress().pairs_finished();
    }
    if (!message.has_chunk()) continue;
    EXPECT_EQ(message.chunk().offset(), distances.size());
    const auto values = Values<float>(message.chunk().distances());
    distances.insert(distances.end(), values.begin(), values.end());
  }
  ASSERT_EQ(distances.size(), 2000);
  for (int i = 0; i < 2000; ++i) {
    EXPECT_FLOAT_EQ(distances[i],
                    Euclid(soup_.positions[request.vertex_pairs(2 * i)],
                           soup_.positions[request.vertex_pairs(2 * i + 1)]));
  }
  const v1::PairsTrailer& trailer = messages.back().trailer();
  EXPECT_EQ(trailer.answer().item_count(), 2000);
  EXPECT_GE(trailer.pairs_from_fields(), 1000);
  EXPECT_EQ(trailer.pairs_searched() + trailer.pairs_from_fields(), 2000);
}

class LandmarksRpcTest : public PairRpcTest {
 protected:
  void SetUp() override {
    ServerOptions options = SmallServer();
    options.metrics_listen = "127.0.0.1:0";
    StartWithGrid(/*held=*/false, options);
  }

  uint64_t LandmarkCount() {
    v1::GetMeshRequest request;
    request.set_digest(digest_);
    v1::GetMeshResponse response;
    grpc::ClientContext context;
    const grpc::Status status = meshes_->GetMesh(&context, request, &response);
    EXPECT_TRUE(status.ok()) << status.error_message();
    return response.mesh().landmark_count();
  }
};

TEST_F(LandmarksRpcTest, AreMadeOnceAPairWasAskedFor) {
  EXPECT_EQ(LandmarkCount(), 0);
  Messages(OnePair());
  EXPECT_TRUE(geodesic::test::Until([&] { return LandmarkCount() == 64; }));
  const std::string metrics =
      geodesic::test::HttpGet(server_->metrics_port(), "/metrics");
  EXPECT_THAT(metrics, ::testing::HasSubstr(
                           "geodesic_landmarks_total{origin=\"computed\"} 64"));
  const auto messages = Messages(OnePair());
  const auto& chunk = messages[messages.size() - 2].chunk();
  EXPECT_EQ(Values<double>(chunk.distances()),
            std::vector<double>{std::hypot(4.5, 3)});
}

TEST_F(PairRpcTest, RefusesWrongRequests) {
  ExpectFaults(
      OnePair(),
      {{"priority: 99", "priority"},
       {"value_type: 99", "value_type"},
       {"mesh_digest: \"AB\"", "mesh_digest"},
       {"vertex_pairs: 1 vertex_pairs: 2", "vertex_pairs"},
       {"pairs { source { vertex: 1 } }", "pairs[1].target"},
       {"pairs { source { vertex: 1 } target { vertex: 5000 } }",
        "pairs[1].target.vertex"},
       {"pairs { source { vertex: 9999999999 } }", "pairs[1].source.vertex"},
       {"tolerance: 0.2", "tolerance"},
       {"tolerance: 1e-10", "tolerance"},
       {"tolerance: nan", "tolerance"},
       {"tolerance: 0.01 algorithm: ALGORITHM_SVG", "tolerance"}});
  ExpectFaults(Pairs(), {{"", "pairs"},
                         {"vertex_pairs: 1", "vertex_pairs"},
                         {"vertex_pairs: 1 vertex_pairs: 2 vertex_pairs: 5000 "
                          "vertex_pairs: 2",
                          "pairs[1].source.vertex"}});
  v1::ComputePairsRequest missing = OnePair();
  missing.set_mesh_digest(std::string(64, '0'));
  EXPECT_EQ(CodeOf(missing), grpc::StatusCode::NOT_FOUND);
}

TEST_F(PairRpcTest, RefusesMoreThanTheLimit) {
  v1::ComputePairsRequest request = Pairs();
  for (int i = 0; i < 2 * 3001; ++i) request.add_vertex_pairs(0);
  const auto reply = Ask(request);
  EXPECT_EQ(reply.status.error_code(), grpc::StatusCode::RESOURCE_EXHAUSTED);
  EXPECT_EQ(reply.status.error_message(),
            "the request has 3001 pairs; max_pairs is 3000 (limit "
            "max-pairs)");
  EXPECT_EQ(test::Reason(reply.status), "LIMIT_EXCEEDED");
}

// Its pairs are a field each, because they share their ends.
class HeldPairsTest : public PairRpcTest {
 protected:
  void SetUp() override {
    ServerOptions options = SmallServer();
    options.limits.landmark_memory_bytes = 0;  // their fields would be held too
    StartWithGrid(/*held=*/true, options);
  }
};

TEST_F(HeldPairsTest, CancellingStopsItsWork) {
  v1::ComputePairsRequest request = Pairs();
  for (uint32_t i = 0; i < 100; ++i) {
    request.add_vertex_pairs(i / 20);
    request.add_vertex_pairs(50 + i % 20);
  }
  grpc::ClientContext context;
  const auto reader = Begin(context, request);
  solver_.WaitForStarts(1);
  context.TryCancel();
  EXPECT_EQ(ReadAll(*reader).status.error_code(), grpc::StatusCode::CANCELLED);
  EXPECT_TRUE(
      server_->engine().scheduler().WaitIdle(std::chrono::seconds(120)));
  EXPECT_EQ(server_->engine().solver_memory().used(), 0);
}

}  // namespace
}  // namespace geodesic::server
