// FieldService.ComputeField beyond one vertex and the whole mesh: places,
// targets, limits, precision, progressive fields.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "tests/rpc/rpc_fixture.h"
#include "tests/support/curved_meshes.h"
#include "tests/support/planar_meshes.h"

namespace geodesic::server {
namespace {

using test::FieldAtFault;
using test::FieldReply;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr uint32_t kSide = 10;  // cells of the grid

double Euclid(const Point& a, const Point& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

template <typename T>
std::vector<T> Values(const std::string& bytes) {
  std::vector<T> values(bytes.size() / sizeof(T));
  std::memcpy(values.data(), bytes.data(), values.size() * sizeof(T));
  return values;
}

class FieldQuestionsTest : public test::RpcTest {
 protected:
  void SetUp() override {
    Start();
    soup_ = geodesic::test::MakeGrid({.columns = kSide, .rows = kSide});
    digest_ = Upload(soup_);
  }

  // All messages, with their bytes.
  std::vector<v1::ComputeFieldResponse> Ask(
      const v1::ComputeFieldRequest& request, grpc::Status& status) {
    grpc::ClientContext context;
    const auto reader = fields_->ComputeField(&context, request);
    std::vector<v1::ComputeFieldResponse> messages;
    v1::ComputeFieldResponse message;
    while (reader->Read(&message)) messages.push_back(message);
    status = reader->Finish();
    return messages;
  }
  std::vector<v1::ComputeFieldResponse> Ask(
      const v1::ComputeFieldRequest& request) {
    grpc::Status status;
    auto messages = Ask(request, status);
    EXPECT_TRUE(status.ok()) << status.error_message();
    return messages;
  }
  std::string Fault(const v1::ComputeFieldRequest& request) {
    grpc::Status status;
    EXPECT_TRUE(Ask(request, status).empty());
    EXPECT_EQ(status.error_code(), grpc::StatusCode::INVALID_ARGUMENT);
    return FieldAtFault(status);
  }

  bool IsFine(const v1::ComputeFieldRequest& request) {
    grpc::Status status;
    Ask(request, status);
    return status.ok();
  }

  // The bytes of the one chunk.
  static std::string Distances(
      const std::vector<v1::ComputeFieldResponse>& messages) {
    for (const auto& message : messages) {
      if (message.has_chunk()) return message.chunk().distances();
    }
    return "";
  }

  v1::ComputeFieldRequest Request() const { return FieldRequest(digest_, 0); }

  TriangleSoup soup_;
  std::string digest_;
};

TEST_F(FieldQuestionsTest, SourcesLieAnywhere) {
  v1::ComputeFieldRequest request;
  request.set_mesh_digest(digest_);
  v1::EdgePoint& edge = *request.add_sources()->mutable_edge();
  edge.set_from(3);
  edge.set_to(4);
  edge.set_t(0.25);
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
  grpc::ClientContext context;
  const FieldReply reply = ComputeField(request, context);
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
  grpc::ClientContext context;
  const FieldReply reply = ComputeField(request, context);
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
  v1::EdgePoint& edge = *request.add_targets()->mutable_edge();
  edge.set_from(8);
  edge.set_to(7);
  edge.set_t(0.5);
  request.add_targets()->set_vertex(2);
  for (const bool cached : {false, true}) {
    const auto messages = Ask(request);
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
    if (cached) Ask(Request());
    request.set_radius(cached ? 3.5 : 4);
    grpc::ClientContext context;
    const FieldReply reply = ComputeField(request, context);
    for (size_t v = 0; v < soup_.positions.size(); ++v) {
      const double expected = Euclid(soup_.positions[0], soup_.positions[v]);
      EXPECT_EQ(reply.distances[v] == kInfinity, expected > request.radius());
    }
    EXPECT_EQ(reply.messages.back().trailer().settled_radius(),
              request.radius());
  }
  // A radius beyond everything is no limit.
  request.set_radius(1000);
  grpc::ClientContext context;
  const FieldReply reply = ComputeField(request, context);
  EXPECT_EQ(reply.messages.back().trailer().settled_radius(), kInfinity);
}

TEST_F(FieldQuestionsTest, SinglePrecisionIsTheNearest) {
  v1::ComputeFieldRequest request = Request();
  const auto exact = Values<double>(Distances(Ask(request)));
  request.set_value_type(v1::VALUE_TYPE_FLOAT32);
  const auto messages = Ask(request);
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
  const auto messages = Ask(request);
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
  grpc::ClientContext context;
  const auto reader = fields_->ComputeField(&context, request);
  v1::ComputeFieldResponse message;
  do {
    ASSERT_TRUE(reader->Read(&message));
  } while (!message.has_settled());
  const auto vertices = Values<uint32_t>(message.settled().vertices());
  const auto values = Values<double>(message.settled().distances());
  context.TryCancel();
  while (reader->Read(&message)) {
  }
  EXPECT_EQ(reader->Finish().error_code(), grpc::StatusCode::CANCELLED);
  const std::vector<double> whole = ComputeField(digest, 0).distances;
  for (size_t i = 0; i < vertices.size(); ++i) {
    EXPECT_EQ(values[i], whole[vertices[i]]);
  }
}

TEST_F(FieldQuestionsTest, WrongArgumentsAreNamed) {
  v1::ComputeFieldRequest request = Request();
  request.add_sources();
  EXPECT_EQ(Fault(request), "sources[1]");

  request = Request();
  v1::EdgePoint& edge = *request.add_sources()->mutable_edge();
  edge.set_from(0);
  edge.set_to(5);
  EXPECT_EQ(Fault(request), "sources[1].edge");
  edge.set_to(1000);
  EXPECT_EQ(Fault(request), "sources[1].edge.to");
  edge.set_to(1);
  edge.set_t(1.5);
  EXPECT_EQ(Fault(request), "sources[1].edge.t");

  request = Request();
  v1::FacePoint& face = *request.add_sources()->mutable_face();
  face.add_weights(1);
  EXPECT_EQ(Fault(request), "sources[1].face.weights");
  face.add_weights(1);
  face.add_weights(0);
  EXPECT_EQ(Fault(request), "sources[1].face.weights");
  face.set_weights(0, -1);
  EXPECT_EQ(Fault(request), "sources[1].face.weights[0]");
  face.set_face(1000);
  EXPECT_EQ(Fault(request), "sources[1].face.face");
  face.set_face(uint64_t{1} << 40);
  EXPECT_EQ(Fault(request), "sources[1].face.face");

  request = Request();
  v1::Curve& curve = *request.add_sources()->mutable_curve();
  EXPECT_EQ(Fault(request), "sources[1].curve.points");
  curve.add_points()->set_vertex(0);
  curve.add_points()->set_vertex(50);
  EXPECT_EQ(Fault(request), "sources[1].curve.points[1]");
  curve.mutable_points(1)->set_vertex(1);
  EXPECT_TRUE(IsFine(request));
  // Behind a curve, a source still has its own place in the list.
  request.add_sources()->set_vertex(1000);
  EXPECT_EQ(Fault(request), "sources[2].vertex");
  request.mutable_sources(2)->set_vertex(1);
  request.mutable_sources(1)->set_offset(-1);
  EXPECT_EQ(Fault(request), "sources[1].offset");

  request = Request();
  request.add_targets()->set_vertex(1000);
  EXPECT_EQ(Fault(request), "targets[0].vertex");
  request.mutable_targets(0)->clear_place();
  EXPECT_EQ(Fault(request), "targets[0]");
  request.mutable_targets(0)->set_vertex(1);
  request.set_stop_after_targets(2);
  EXPECT_EQ(Fault(request), "stop_after_targets");
  request.set_stop_after_targets(std::numeric_limits<uint64_t>::max());
  EXPECT_EQ(Fault(request), "stop_after_targets");

  request = Request();
  request.set_radius(-1);
  EXPECT_EQ(Fault(request), "radius");
  request = Request();
  request.set_value_type(static_cast<v1::ValueType>(9));
  EXPECT_EQ(Fault(request), "value_type");
  request = Request();
  request.add_quantities(static_cast<v1::FieldQuantity>(9));
  EXPECT_EQ(Fault(request), "quantities[0]");
  request = Request();
  request.add_quantities(v1::FIELD_QUANTITY_GRADIENT);
  request.set_progressive(true);
  EXPECT_EQ(Fault(request), "quantities");
}

TEST_F(FieldQuestionsTest, CountsHaveLimits) {
  const auto exhausted = [&](const v1::ComputeFieldRequest& request) {
    grpc::Status status;
    Ask(request, status);
    EXPECT_FALSE(test::RetryInfo(status).has_value());
    return status.error_code() == grpc::StatusCode::RESOURCE_EXHAUSTED;
  };
  v1::ComputeFieldRequest request = Request();
  for (int i = 0; i < 101; ++i) request.add_targets();
  EXPECT_TRUE(exhausted(request));
  request = Request();
  for (int i = 0; i < 10; ++i) request.add_sources();
  EXPECT_TRUE(exhausted(request));
  request = Request();
  v1::Curve& curve = *request.add_sources()->mutable_curve();
  for (int i = 0; i < 11; ++i) curve.add_points();
  EXPECT_TRUE(exhausted(request));
}

}  // namespace
}  // namespace geodesic::server
