// FieldService.ComputeField beyond one vertex and the whole mesh: places,
// targets, limits, precision, progressive fields.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "tests/rpc/questions_fixture.h"
#include "tests/support/curved_meshes.h"

namespace geodesic::server {
namespace {

using test::Euclid;
using test::FieldReply;
using test::kInfinity;
using test::Values;

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
