// ComputePairs: what answers say of themselves, and how requests are refused.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "tests/rpc/questions_fixture.h"
#include "tests/support/http_get.h"
#include "tests/support/until.h"

namespace geodesic::server {
namespace {

using test::Reply;

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
  const Reply reply = Answered(OnePair());
  EXPECT_EQ(reply.header().mesh_digest(), digest_);
  EXPECT_EQ(reply.header().vertex_count(), soup_.positions.size());
  EXPECT_EQ(reply.header().algorithm(), v1::ALGORITHM_FWP_LIST);
  EXPECT_EQ(reply.header().arrays_size(), 1);
  EXPECT_GT(reply.trailer().windows_propagated(), 0);
  EXPECT_EQ(reply.trailer().pairs().searched(), 1);
  EXPECT_EQ(reply.Values<double>("distance"),
            std::vector<double>{std::hypot(4.5, 3)});
}

TEST_F(PairRpcTest, CertifiesWhatIsWithinATolerance) {
  v1::ComputePairsRequest request = OnePair();
  request.set_tolerance(0.01);
  const Reply reply = Answered(request);
  EXPECT_EQ(reply.trailer().relative_tolerance(), 0.01);
  EXPECT_EQ(reply.trailer().certified_error(), 0.01);
  // Paths are exact.
  request.set_paths(true);
  EXPECT_FALSE(Answered(request).trailer().has_certified_error());
}

class LandmarksRpcTest : public PairRpcTest {
 protected:
  void SetUp() override {
    ServerOptions options = SmallServer();
    options.metrics_listen = "127.0.0.1:0";
    StartWithGrid(/*held=*/false, options);
  }

  uint64_t LandmarkCount() {
    v1::Mesh mesh;
    const grpc::Status status = GetMesh(digest_, mesh);
    EXPECT_TRUE(status.ok()) << status.error_message();
    return mesh.landmark_count();
  }
};

TEST_F(LandmarksRpcTest, AreMadeOnceAPairWasAskedFor) {
  EXPECT_EQ(LandmarkCount(), 0);
  Answered(OnePair());
  EXPECT_TRUE(geodesic::test::Until([&] { return LandmarkCount() == 64; }));
  const std::string metrics =
      geodesic::test::HttpGet(server_->metrics_port(), "/metrics");
  EXPECT_THAT(metrics, ::testing::HasSubstr(
                           "geodesic_landmarks_total{origin=\"computed\"} 64"));
  EXPECT_EQ(Answered(OnePair()).Values<double>("distance"),
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
  const Reply reply = Ask(request);
  EXPECT_EQ(reply.status.error_code(), grpc::StatusCode::RESOURCE_EXHAUSTED);
  EXPECT_EQ(reply.status.error_message(),
            "the request has 3001 pairs; max_pairs is 3000 (limit "
            "max-pairs)");
  EXPECT_EQ(test::Reason(reply.status), "LIMIT_EXCEEDED");
}

}  // namespace
}  // namespace geodesic::server
