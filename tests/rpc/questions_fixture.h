// A server that holds a flat grid, and calls of its streaming RPCs.

#ifndef GEODESIC_TESTS_RPC_QUESTIONS_FIXTURE_H_
#define GEODESIC_TESTS_RPC_QUESTIONS_FIXTURE_H_

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include "geodesic/v1/matrix_service.grpc.pb.h"
#include "geodesic/v1/path_service.grpc.pb.h"
#include "tests/rpc/rpc_fixture.h"
#include "tests/support/planar_meshes.h"

namespace geodesic::server::test {

inline double Euclid(const Point& a, const Point& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

template <typename T>
std::vector<T> Values(const std::string& bytes) {
  std::vector<T> values(bytes.size() / sizeof(T));
  std::memcpy(values.data(), bytes.data(), values.size() * sizeof(T));
  return values;
}

template <typename Response>
struct StreamReply {
  grpc::Status status;
  std::vector<Response> messages;
};

// On the grid geodesics are straight, so every distance is Euclid's.
class QuestionsTest : public RpcTest {
 protected:
  static constexpr uint32_t kSide = 10;  // cells

  void SetUp() override { StartWithGrid(/*held=*/false); }

  void StartWithGrid(bool held) {
    Start(SmallServer(), held);
    paths_ = v1::PathService::NewStub(channel_);
    matrices_ = v1::MatrixService::NewStub(channel_);
    soup_ = geodesic::test::MakeGrid({.columns = kSide, .rows = kSide});
    digest_ = Upload(soup_);
  }

  // Reads a stream to its end.
  template <typename Response>
  static StreamReply<Response> ReadAll(grpc::ClientReader<Response>& reader) {
    StreamReply<Response> reply;
    Response message;
    while (reader.Read(&message)) reply.messages.push_back(message);
    reply.status = reader.Finish();
    return reply;
  }

  StreamReply<v1::ComputePathsResponse> Ask(
      const v1::ComputePathsRequest& request) {
    grpc::ClientContext context;
    return ReadAll(*paths_->ComputePaths(&context, request));
  }
  StreamReply<v1::ComputeIsolinesResponse> Ask(
      const v1::ComputeIsolinesRequest& request) {
    grpc::ClientContext context;
    return ReadAll(*paths_->ComputeIsolines(&context, request));
  }
  StreamReply<v1::ComputeLogMapResponse> Ask(
      const v1::ComputeLogMapRequest& request) {
    grpc::ClientContext context;
    return ReadAll(*fields_->ComputeLogMap(&context, request));
  }
  StreamReply<v1::SampleFarthestPointsResponse> Ask(
      const v1::SampleFarthestPointsRequest& request) {
    grpc::ClientContext context;
    return ReadAll(*fields_->SampleFarthestPoints(&context, request));
  }
  StreamReply<v1::ComputeMatrixResponse> Ask(
      const v1::ComputeMatrixRequest& request) {
    grpc::ClientContext context;
    return ReadAll(*matrices_->ComputeMatrix(&context, request));
  }
  StreamReply<v1::FindNearestResponse> Ask(
      const v1::FindNearestRequest& request) {
    grpc::ClientContext context;
    return ReadAll(*matrices_->FindNearest(&context, request));
  }

  // The field at fault of a request that is refused before anything is sent.
  template <typename Request>
  std::string Fault(const Request& request) {
    const auto reply = Ask(request);
    EXPECT_TRUE(reply.messages.empty());
    EXPECT_EQ(reply.status.error_code(), grpc::StatusCode::INVALID_ARGUMENT)
        << reply.status.error_message();
    return FieldAtFault(reply.status);
  }

  // What every question refuses: a mesh that is not there, a digest that is
  // none, an algorithm that nobody knows.
  template <typename Request>
  void ExpectUsualErrors(Request request) {
    request.set_algorithm(static_cast<v1::Algorithm>(99));
    EXPECT_EQ(Fault(request), "algorithm");
    request.clear_algorithm();
    request.set_mesh_digest("horse");
    EXPECT_EQ(Fault(request), "mesh_digest");
    request.set_mesh_digest(std::string(64, 'a'));
    EXPECT_EQ(Ask(request).status.error_code(), grpc::StatusCode::NOT_FOUND);
  }

  uint64_t Vertex(uint32_t x, uint32_t y) const { return y * (kSide + 1) + x; }

  void ExpectHeader(const v1::AnswerHeader& header) const {
    EXPECT_EQ(header.mesh_digest(), digest_);
    EXPECT_EQ(header.vertex_count(), soup_.positions.size());
    EXPECT_EQ(header.algorithm(), v1::ALGORITHM_FWP_LIST);
    EXPECT_EQ(header.relative_tolerance(), 1e-10);
    EXPECT_EQ(header.server_version(), ServerVersion());
  }

  TriangleSoup soup_;
  std::string digest_;
  std::unique_ptr<v1::PathService::Stub> paths_;
  std::unique_ptr<v1::MatrixService::Stub> matrices_;
};

}  // namespace geodesic::server::test

#endif  // GEODESIC_TESTS_RPC_QUESTIONS_FIXTURE_H_
