// A client that gives up while its question is computed: the call ends as
// cancelled and the work stops. (Fields, isolines and matrices have tests of
// their own beside their answers.)

#include <gtest/gtest.h>

#include <chrono>

#include "tests/rpc/questions_fixture.h"
#include "tests/support/curved_meshes.h"

namespace geodesic::server {
namespace {

class CancellationTest : public test::QuestionsTest {
 protected:
  void SetUp() override { StartWithGrid(/*held=*/true); }

  // `start` begins the call. Nothing of the answer can have come when it is
  // cancelled, since the solver waits.
  template <typename Response, typename StartCall>
  void ExpectCancelled(StartCall start) {
    grpc::ClientContext context;
    const auto reader = start(&context);
    solver_.WaitForStarts(1);
    context.TryCancel();
    const test::StreamReply<Response> reply = ReadAll(*reader);
    EXPECT_EQ(reply.status.error_code(), grpc::StatusCode::CANCELLED);
    for (const Response& message : reply.messages) {
      EXPECT_FALSE(message.has_trailer());
    }
    // The solver is still held: only what cancels it lets it end.
    EXPECT_TRUE(server_->engine().WaitIdle(std::chrono::seconds(120)));
  }
};

TEST_F(CancellationTest, StopsPaths) {
  v1::ComputePathsRequest request;
  request.set_mesh_digest(digest_);
  request.add_sources()->set_vertex(0);
  request.add_targets()->set_vertex(Vertex(kSide, kSide));
  ExpectCancelled<v1::ComputePathsResponse>([&](grpc::ClientContext* context) {
    return paths_->ComputePaths(context, request);
  });
}

TEST_F(CancellationTest, StopsALogMap) {
  v1::ComputeLogMapRequest request;
  request.set_mesh_digest(digest_);
  request.mutable_source()->set_vertex(Vertex(kSide / 2, kSide / 2));
  ExpectCancelled<v1::ComputeLogMapResponse>([&](grpc::ClientContext* context) {
    return fields_->ComputeLogMap(context, request);
  });
}

TEST_F(CancellationTest, StopsTheNearest) {
  v1::FindNearestRequest request;
  request.set_mesh_digest(digest_);
  request.add_sources()->set_vertex(0);
  for (uint32_t i = 1; i <= kSide; ++i) {
    request.add_targets()->set_vertex(Vertex(i, i));
  }
  request.set_count(3);
  ExpectCancelled<v1::FindNearestResponse>([&](grpc::ClientContext* context) {
    return matrices_->FindNearest(context, request);
  });
}

// Samples come while the next one is sought, so the mesh is large enough for
// that to take long.
class SampleCancellationTest : public test::QuestionsTest {};

TEST_F(SampleCancellationTest, StopsSamples) {
  digest_ = Upload(geodesic::test::Icosphere(7));
  v1::SampleFarthestPointsRequest request;
  request.set_mesh_digest(digest_);
  request.add_sources()->set_vertex(0);
  request.set_count(20);
  grpc::ClientContext context;
  const auto reader = fields_->SampleFarthestPoints(&context, request);
  v1::SampleFarthestPointsResponse message;
  do {
    ASSERT_TRUE(reader->Read(&message));
  } while (!message.has_progress());
  context.TryCancel();
  EXPECT_EQ(ReadAll(*reader).status.error_code(), grpc::StatusCode::CANCELLED);
  EXPECT_TRUE(server_->engine().WaitIdle(std::chrono::seconds(120)));
}

}  // namespace
}  // namespace geodesic::server
