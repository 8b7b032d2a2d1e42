// A server that holds a flat grid, and questions about it.

#ifndef GEODESIC_TESTS_RPC_QUESTIONS_FIXTURE_H_
#define GEODESIC_TESTS_RPC_QUESTIONS_FIXTURE_H_

#include <google/protobuf/text_format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "tests/rpc/rpc_fixture.h"
#include "tests/support/meshes/planar_meshes.h"

namespace geodesic::server::test {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

inline double Euclid(const Point& a, const Point& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

// On the grid geodesics are straight, so every distance is Euclid's.
class QuestionsTest : public RpcTest {
 protected:
  static constexpr uint32_t kSide = 10;  // cells

  void SetUp() override { StartWithGrid(/*held=*/false); }

  void StartWithGrid(bool held, const ServerOptions& options = SmallServer()) {
    Start(options, held);
    soup_ = geodesic::test::MakeGrid({.columns = kSide, .rows = kSide});
    digest_ = Upload(soup_);
  }

  // A whole answer. Throws, which fails the test, if it is refused.
  template <typename Request>
  Reply Answered(const Request& request) {
    Reply reply = Ask(request);
    if (!reply.status.ok()) {
      throw std::runtime_error(reply.status.error_message());
    }
    return reply;
  }

  template <typename Request>
  grpc::StatusCode CodeOf(const Request& request) {
    return Ask(request).status.error_code();
  }

  // The field at fault of a request that is refused before anything is sent.
  template <typename Request>
  std::string Fault(const Request& request) {
    const Reply reply = Ask(request);
    EXPECT_TRUE(reply.messages.empty());
    EXPECT_EQ(reply.status.error_code(), grpc::StatusCode::INVALID_ARGUMENT)
        << reply.status.error_message();
    return FieldAtFault(reply.status);
  }

  // Tries each of these changes to a request that is right.
  struct Change {
    const char*
        text;  // what is added to the request, in protobuf's text format
    const char* fault;  // the field at fault
  };
  template <typename Request>
  void ExpectFaults(const Request& request,
                    std::initializer_list<Change> changes) {
    for (const Change& change : changes) {
      SCOPED_TRACE(change.text);
      Request changed = request;
      google::protobuf::TextFormat::Parser parser;
      ASSERT_TRUE(parser.MergeFromString(change.text, &changed));
      EXPECT_EQ(Fault(changed), change.fault);
    }
  }

  // A question about the grid, from this vertex.
  template <typename Request>
  Request From(uint64_t vertex) const {
    Request request;
    request.set_mesh_digest(digest_);
    if constexpr (requires { request.add_sources(); }) {
      request.add_sources()->set_vertex(vertex);
    } else {
      request.mutable_source()->set_vertex(vertex);
    }
    return request;
  }

  // Puts the place on the edge between two vertices.
  template <typename Place>
  static void SetEdge(uint64_t from, uint64_t to, double t, Place& place) {
    v1::EdgePoint& edge = *place.mutable_edge();
    edge.set_from(from);
    edge.set_to(to);
    edge.set_t(t);
  }

  uint64_t Vertex(uint32_t x, uint32_t y) const { return y * (kSide + 1) + x; }

  TriangleSoup soup_;
  std::string digest_;
};

}  // namespace geodesic::server::test

#endif  // GEODESIC_TESTS_RPC_QUESTIONS_FIXTURE_H_
