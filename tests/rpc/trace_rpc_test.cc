// TraceLines: lines on a flat grid are straight.

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include "codec/value_type.h"
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
  const size_t size = codec::SizeOf(reply.header().arrays(0).type());
  EXPECT_TRUE(Answered(request).Bytes(0) == reply.Bytes(0).substr(300 * size));
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
