// What a server with the default limits advertises comes in one message.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "server/engine/base/limits.h"
#include "tests/rpc/questions_fixture.h"
#include "tests/support/meshes/curved_meshes.h"

namespace geodesic::server {
namespace {

class AdvertisedLimitsTest : public test::QuestionsTest {
 protected:
  void SetUp() override {
    ServerOptions options;
    options.listen = "127.0.0.1:0";
    StartWithGrid(/*held=*/false, options);
  }

  // Those between one vertex and all, again and again.
  void ExpectDistances(const std::vector<double>& distances, uint64_t count) {
    ASSERT_EQ(distances.size(), count);
    for (size_t i = 0; i < distances.size(); ++i) {
      ASSERT_NEAR(distances[i],
                  test::Euclid(soup_.positions[Vertex(3, 4)],
                               soup_.positions[i % soup_.positions.size()]),
                  1e-9);
    }
  }

  const Limits limits_ = {};
};

TEST_F(AdvertisedLimitsTest, Targets) {
  v1::ComputeFieldRequest request = FieldRequest(digest_, Vertex(3, 4));
  const auto vertices = static_cast<uint32_t>(soup_.positions.size());
  for (uint64_t i = 0; i < limits_.max_targets; ++i) {
    request.add_vertex_targets(static_cast<uint32_t>(i) % vertices);
  }
  ExpectDistances(Answered(request).Values<double>("target_distance"),
                  limits_.max_targets);
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
  Answered(request);
}

TEST_F(AdvertisedLimitsTest, Rows) {
  v1::ComputeMatrixRequest request;
  request.set_mesh_digest(digest_);
  request.add_vertex_targets(static_cast<uint32_t>(Vertex(3, 4)));
  const auto vertices = static_cast<uint32_t>(soup_.positions.size());
  for (uint64_t i = 0; i < limits_.max_matrix_rows; ++i) {
    request.add_vertex_sources(static_cast<uint32_t>(i) % vertices);
  }
  ExpectDistances(Answered(request).Values<double>("distance"),
                  limits_.max_matrix_rows);
}

}  // namespace
}  // namespace geodesic::server
