// TraceLines: lines on a flat grid are straight.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "tests/rpc/questions_fixture.h"

namespace geodesic::server {
namespace {

using test::Euclid;
using test::Reply;

class TraceRpcTest : public test::QuestionsTest {
 protected:
  v1::TraceLinesRequest Request() const {
    v1::TraceLinesRequest request;
    request.set_mesh_digest(digest_);
    request.add_vertex_sources(static_cast<uint32_t>(Vertex(5, 5)));
    return request;
  }
  // Where each line ends.
  static std::vector<Point> Ends(const Reply& reply) {
    const auto points = reply.Values<Point>("position");
    std::vector<Point> ends;
    for (const uint64_t end : reply.Values<uint64_t>("line_end")) {
      ends.push_back(points.at(end - 1));
    }
    return ends;
  }
};

TEST_F(TraceRpcTest, AllFormsOfDirectionsAreTheSame) {
  v1::TraceLinesRequest vectors = Request();
  v1::TraceLinesRequest towards = Request();
  v1::TraceLinesRequest angles = Request();
  const double toward[2] = {2, 1};
  for (const double coordinate : {toward[0], toward[1], 0.0}) {
    vectors.add_vectors(coordinate);
  }
  towards.add_towards()->set_vertex(Vertex(7, 6));
  v1::ComputeLogMapRequest map;
  map.set_mesh_digest(digest_);
  map.mutable_source()->set_vertex(Vertex(5, 5));
  const auto zero = Answered(map).Values<double>("zero_direction");
  angles.add_angles(std::atan2(toward[1], toward[0]) -
                    std::atan2(zero[1], zero[0]));
  const Point& from = soup_.positions[Vertex(5, 5)];
  for (v1::TraceLinesRequest request : {vectors, towards, angles}) {
    request.add_lengths(2.5);
    const Reply reply = Answered(request);
    const double norm = std::hypot(toward[0], toward[1]);
    const Point expected = {from[0] + 2.5 * toward[0] / norm,
                            from[1] + 2.5 * toward[1] / norm, 0};
    EXPECT_LT(Euclid(Ends(reply).at(0), expected), 1e-12);
    EXPECT_EQ(reply.Values<double>("length"), std::vector{2.5});
    EXPECT_EQ(reply.Values<uint8_t>("end"), std::vector<uint8_t>{0});
  }
}

// More lines than a job takes.
TEST_F(TraceRpcTest, ManyLinesComeInOrder) {
  constexpr int kLines = 100;
  v1::TraceLinesRequest request = Request();
  for (int i = 0; i < kLines; ++i) {
    request.add_angles(2 * std::numbers::pi * i / kLines);
    request.add_lengths(4.0 * (i + 1) / kLines);
  }
  const Reply reply = Answered(request);
  const std::vector<Point> ends = Ends(reply);
  ASSERT_EQ(ends.size(), kLines);
  const Point& from = soup_.positions[Vertex(5, 5)];
  for (int i = 0; i < kLines; ++i) {
    EXPECT_NEAR(Euclid(from, ends[i]), 4.0 * (i + 1) / kLines, 1e-12);
  }
  // What is read on is the same.
  request.mutable_resumption()->set_answer_id(reply.answer_id());
  request.mutable_resumption()->add_received(300);
  const Reply rest = Answered(request);
  EXPECT_TRUE(
      rest.Bytes(0) ==
      reply.Bytes(0).substr(300 * test::SizeOf(reply.header().arrays(0))));
}

TEST_F(TraceRpcTest, LinesEndAtTheBoundary) {
  v1::TraceLinesRequest request = Request();
  for (const double coordinate : {1.0, 0.3, 0.0}) {
    request.add_vectors(coordinate);
  }
  request.add_lengths(std::numeric_limits<double>::infinity());
  const Reply reply = Answered(request);
  EXPECT_EQ(Ends(reply).at(0)[0], 10);
  EXPECT_EQ(reply.Values<uint8_t>("end"), std::vector<uint8_t>{1});
}

TEST_F(TraceRpcTest, WrongArgumentsAreNamed) {
  v1::TraceLinesRequest request = Request();
  ExpectFaults(
      request,
      {{"lengths: 1", "angles"},
       {"angles: 0", "lengths"},
       {"angles: 0 lengths: 1 tolerance: 0.01", "tolerance"},
       {"angles: 0 lengths: 1 algorithm: ALGORITHM_MMP", "algorithm"},
       {"vectors: 1 lengths: 1", "vectors"},
       {"angles: 0 vectors: [1, 0, 0] lengths: 1", "vectors"},
       {"angles: [0, 1] lengths: [1, 1, 1]", "angles"},
       {"angles: 0 lengths: 1 sources { vertex: 1 }", "vertex_sources"}});
  const auto fault = [&](v1::TraceLinesRequest changed) {
    return test::FieldAtFault(Ask(changed).status);
  };
  request.add_lengths(1);
  request.add_angles(std::nan(""));
  EXPECT_EQ(fault(request), "angles[0]");
  request.set_angles(0, 0);
  request.set_lengths(0, -1);
  EXPECT_EQ(fault(request), "lengths[0]");
  request.set_lengths(0, 1);
  request.set_vertex_sources(0, 1000);
  EXPECT_EQ(fault(request), "sources[0].vertex");
  request.set_vertex_sources(0, 5);
  request.clear_angles();
  request.add_towards()->set_vertex(1000);
  EXPECT_EQ(fault(request), "towards[0].vertex");
}

}  // namespace
}  // namespace geodesic::server
