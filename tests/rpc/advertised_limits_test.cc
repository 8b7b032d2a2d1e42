// What a server with the default limits advertises comes in one message.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>

#include "server/engine/base/limits.h"
#include "tests/rpc/questions_fixture.h"
#include "tests/support/curved_meshes.h"

namespace geodesic::server {
namespace {

using test::Values;

class AdvertisedLimitsTest : public test::QuestionsTest {
 protected:
  void SetUp() override {
    ServerOptions options;
    options.listen = "127.0.0.1:0";
    StartWithGrid(/*held=*/false, options);
  }

  const Limits limits_ = {};
};

TEST_F(AdvertisedLimitsTest, Targets) {
  v1::ComputeFieldRequest request = FieldRequest(digest_, Vertex(3, 4));
  const auto vertices = static_cast<uint32_t>(soup_.positions.size());
  for (uint64_t i = 0; i < limits_.max_targets; ++i) {
    request.add_vertex_targets(static_cast<uint32_t>(i) % vertices);
  }
  uint64_t next = 0;
  for (const auto& message : Messages(request)) {
    if (!message.has_targets()) continue;
    EXPECT_EQ(message.targets().offset(), next);
    for (const double distance :
         Values<double>(message.targets().distances())) {
      ASSERT_NEAR(distance,
                  test::Euclid(soup_.positions[Vertex(3, 4)],
                               soup_.positions[next % vertices]),
                  1e-9);
      ++next;
    }
  }
  EXPECT_EQ(next, limits_.max_targets);
}

TEST_F(AdvertisedLimitsTest, SourcesInsideFaces) {
  const TriangleSoup sphere = geodesic::test::Icosphere(7);
  v1::ComputeFieldRequest request;
  request.set_mesh_digest(Upload(sphere));
  for (uint64_t i = 0; i < limits_.max_sources; ++i) {
    v1::Source& source = *request.add_sources();
    source.set_offset(0.001);
    source.mutable_face()->set_face(i);
    for (const double weight : {0.3, 0.3, 0.4}) {
      source.mutable_face()->add_weights(weight);
    }
  }
  const auto messages = Messages(request);
  EXPECT_TRUE(messages.back().has_trailer());
}

TEST_F(AdvertisedLimitsTest, Rows) {
  v1::ComputeMatrixRequest request;
  request.set_mesh_digest(digest_);
  request.add_vertex_targets(static_cast<uint32_t>(Vertex(3, 4)));
  const auto vertices = static_cast<uint32_t>(soup_.positions.size());
  for (uint64_t i = 0; i < limits_.max_matrix_rows; ++i) {
    request.add_vertex_sources(static_cast<uint32_t>(i) % vertices);
  }
  grpc::ClientContext context;
  const auto reader = matrices_->ComputeMatrix(&context, request);
  v1::ComputeMatrixResponse message;
  uint64_t next = 0;
  while (reader->Read(&message)) {
    if (!message.has_chunk()) continue;
    ASSERT_EQ(message.chunk().row(), next);
    ASSERT_NEAR(Values<double>(message.chunk().values())[0],
                test::Euclid(soup_.positions[Vertex(3, 4)],
                             soup_.positions[next % vertices]),
                1e-9);
    ++next;
  }
  EXPECT_TRUE(reader->Finish().ok());
  EXPECT_EQ(next, limits_.max_matrix_rows);
}

}  // namespace
}  // namespace geodesic::server
