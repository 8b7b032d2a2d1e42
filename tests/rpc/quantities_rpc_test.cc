// FieldService beside distances: labels, gradients, log maps, samples.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "tests/rpc/questions_fixture.h"

namespace geodesic::server {
namespace {

using test::Euclid;
using test::kInfinity;
using test::Values;

constexpr uint32_t kNobody = 0xffffffffu;

using QuantitiesTest = test::QuestionsTest;

// The chunks of a field put together.
struct Quantities {
  std::vector<double> distances;
  std::vector<uint32_t> nearest;
  std::vector<double> gradients;
};

template <typename T>
void Append(const std::string& bytes, std::vector<T>& to) {
  const auto values = Values<T>(bytes);
  to.insert(to.end(), values.begin(), values.end());
}

TEST_F(QuantitiesTest, LabelsAndGradients) {
  v1::ComputeFieldRequest request;
  request.set_mesh_digest(digest_);
  // Numbered against the order of their vertices.
  request.add_sources()->set_vertex(Vertex(9, 8));
  request.add_sources()->set_vertex(Vertex(1, 2));
  request.add_quantities(v1::FIELD_QUANTITY_NEAREST_SOURCE);
  request.add_quantities(v1::FIELD_QUANTITY_GRADIENT);
  for (const double radius : {kInfinity, 5.1, 3.1}) {
    if (!std::isinf(radius)) request.set_radius(radius);
    Quantities all;
    for (const auto& message : Messages(request)) {
      if (!message.has_chunk()) continue;
      EXPECT_EQ(message.chunk().offset(), all.distances.size());
      Append(message.chunk().distances(), all.distances);
      Append(message.chunk().nearest_sources(), all.nearest);
      Append(message.chunk().gradients(), all.gradients);
    }
    ASSERT_EQ(all.nearest.size(), soup_.positions.size());
    ASSERT_EQ(all.gradients.size(), 3 * soup_.positions.size());
    const Point sources[] = {{9, 8, 0}, {1, 2, 0}};
    for (size_t v = 0; v < soup_.positions.size(); ++v) {
      const Point& p = soup_.positions[v];
      const double d[] = {Euclid(p, sources[0]), Euclid(p, sources[1])};
      const double least = std::min(d[0], d[1]);
      const double* gradient = &all.gradients[3 * v];
      if (least > radius) {
        EXPECT_EQ(all.distances[v], kInfinity);
        EXPECT_EQ(all.nearest[v], kNobody);
        EXPECT_EQ(gradient[0], 0);
        EXPECT_EQ(gradient[1], 0);
        continue;
      }
      EXPECT_NEAR(all.distances[v], least, 1e-10);
      if (std::abs(d[0] - d[1]) < 1e-9) continue;  // either will do
      const int nearest = d[1] < d[0];
      EXPECT_EQ(all.nearest[v], nearest);
      for (int axis = 0; axis < 3; ++axis) {
        const double expected =
            least == 0 ? 0 : (p[axis] - sources[nearest][axis]) / least;
        EXPECT_NEAR(gradient[axis], expected, 1e-9);
      }
    }
  }
  // The traced field answers those who want distances alone.
  request.clear_quantities();
  request.clear_radius();
  EXPECT_EQ(Messages(request).front().header().origin(),
            v1::FIELD_ORIGIN_CACHED);
}

TEST_F(QuantitiesTest, ALogMapOfAPlaneIsThePlane) {
  v1::ComputeLogMapRequest request;
  request.set_mesh_digest(digest_);
  request.mutable_source()->set_vertex(Vertex(4, 5));
  request.set_radius(4);
  const auto messages = Messages(request);
  ExpectHeader(messages.front().header());
  Point zero{};
  std::vector<double> uv;
  for (const auto& message : messages) {
    if (message.has_frame()) {
      const v1::Point& direction = message.frame().zero_direction();
      zero = {direction.x(), direction.y(), direction.z()};
      EXPECT_TRUE(uv.empty());
    }
    if (message.has_chunk()) {
      EXPECT_EQ(message.chunk().offset(), uv.size() / 2);
      Append(message.chunk().coordinates(), uv);
    }
  }
  EXPECT_NEAR(std::hypot(zero[0], zero[1]), 1, 1e-12);
  ASSERT_EQ(uv.size(), 2 * soup_.positions.size());
  for (size_t v = 0; v < soup_.positions.size(); ++v) {
    const double x = soup_.positions[v][0] - 4;
    const double y = soup_.positions[v][1] - 5;
    if (std::hypot(x, y) > 4) {
      EXPECT_TRUE(std::isnan(uv[2 * v]));
      continue;
    }
    // The plane turned so that `zero` is the first axis.
    EXPECT_NEAR(uv[2 * v], x * zero[0] + y * zero[1], 1e-9);
    EXPECT_NEAR(uv[2 * v + 1], y * zero[0] - x * zero[1], 1e-9);
  }
}

TEST_F(QuantitiesTest, ALogMapNamesWhatIsWrong) {
  v1::ComputeLogMapRequest request;
  request.set_mesh_digest(digest_);
  EXPECT_EQ(Fault(request), "source");
  ExpectFaults(request, {{"source { vertex: 1000 }", "source.vertex"},
                         {"source { face { weights: [0.5, -0.5, 1] } }",
                          "source.face.weights[1]"},
                         {"source { vertex: 0 } radius: -1", "radius"},
                         {"source { vertex: 0 } value_type: 7", "value_type"}});
  request.mutable_source()->set_vertex(0);
  ExpectUsual(request);
}

TEST_F(QuantitiesTest, SamplesAreFarthest) {
  v1::SampleFarthestPointsRequest request;
  request.set_mesh_digest(digest_);
  request.add_sources()->set_vertex(0);
  request.set_count(12);
  const auto messages = Messages(request);
  ExpectHeader(messages.front().header());
  std::vector<Point> chosen = {soup_.positions[0]};
  for (const auto& message : messages) {
    for (const v1::FarthestSample& sample : message.samples().samples()) {
      double farthest = 0;
      const auto distance = [&](const Point& p) {
        double least = kInfinity;
        for (const Point& other : chosen) {
          least = std::min(least, Euclid(p, other));
        }
        return least;
      };
      for (const Point& p : soup_.positions) {
        farthest = std::max(farthest, distance(p));
      }
      const Point& p = soup_.positions[sample.vertex()];
      EXPECT_NEAR(sample.distance(), farthest, 1e-10);
      EXPECT_NEAR(distance(p), farthest, 1e-10);
      chosen.push_back(p);
    }
  }
  EXPECT_EQ(chosen.size(), 13);
  EXPECT_EQ(messages.back().trailer().item_count(), 12);
}

TEST_F(QuantitiesTest, SamplesHaveLimits) {
  v1::SampleFarthestPointsRequest request;
  request.set_mesh_digest(digest_);
  request.add_sources()->set_vertex(0);
  EXPECT_EQ(Fault(request), "count");
  request.set_count(1);
  ExpectUsual(request);
  request.clear_sources();
  EXPECT_EQ(Fault(request), "sources");
  request.set_count(21);
  EXPECT_EQ(CodeOf(request), grpc::StatusCode::RESOURCE_EXHAUSTED);
}

}  // namespace
}  // namespace geodesic::server
