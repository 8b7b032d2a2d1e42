// The questions beside ComputeField: what their answers say of themselves, and
// how wrong requests are refused. Whether answers are right is seen by clients:
// tests/integration.

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "absl/strings/str_cat.h"
#include "tests/rpc/questions_fixture.h"
#include "tests/support/meshes/curved_meshes.h"

namespace geodesic::server {
namespace {

using test::Reply;

class QuestionsRpcTest : public test::QuestionsTest {
 protected:
  v1::ComputePathsRequest Paths() const {
    auto request = From<v1::ComputePathsRequest>(Vertex(0, 0));
    request.add_targets()->set_vertex(Vertex(5, 0));
    return request;
  }
  v1::ComputeIsolinesRequest Isolines() const {
    auto request = From<v1::ComputeIsolinesRequest>(Vertex(5, 5));
    request.add_levels(2);
    return request;
  }
  v1::ComputeLogMapRequest LogMap() const {
    return From<v1::ComputeLogMapRequest>(Vertex(4, 5));
  }
  v1::SampleFarthestPointsRequest Samples() const {
    auto request = From<v1::SampleFarthestPointsRequest>(Vertex(0, 0));
    request.set_count(1);
    return request;
  }
  v1::ComputeMatrixRequest Matrix() const {
    auto request = From<v1::ComputeMatrixRequest>(Vertex(9, 9));
    request.add_sources()->set_vertex(Vertex(0, 4));
    return request;
  }
  v1::FindNearestRequest Nearest() const {
    auto request = From<v1::FindNearestRequest>(Vertex(0, 0));
    request.add_targets()->set_vertex(Vertex(1, 0));
    request.set_count(1);
    return request;
  }

  // What every question has: a header, a trailer, priorities, and as errors an
  // algorithm that nobody knows, a digest that is none, and a mesh that is not
  // there.
  template <typename Request>
  void ExpectUsual(Request request) {
    SCOPED_TRACE(request.GetTypeName());
    ExpectFaults(request, {{"priority: 99", "priority"},
                           {"algorithm: 99", "algorithm"}});
    request.set_priority(v1::PRIORITY_BATCH);
    const Reply reply = Answered(request);
    EXPECT_EQ(reply.header().mesh_digest(), digest_);
    EXPECT_EQ(reply.header().vertex_count(), soup_.positions.size());
    EXPECT_EQ(reply.header().algorithm(), v1::ALGORITHM_FWP_LIST);
    EXPECT_EQ(reply.header().server_version(), ServerVersion());
    EXPECT_EQ(reply.header().origin(), v1::ANSWER_ORIGIN_COMPUTED);
    EXPECT_EQ(reply.trailer().relative_tolerance(), 1e-10);
    EXPECT_GT(reply.trailer().windows_propagated(), 0);
    EXPECT_NE(reply.answer_id(), "");
    request.set_mesh_digest("horse");
    EXPECT_EQ(Fault(request), "mesh_digest");
    request.set_mesh_digest(std::string(64, 'a'));
    EXPECT_EQ(CodeOf(request), grpc::StatusCode::NOT_FOUND);
  }

  template <typename Request>
  void ExpectExhausted(const Request& request) {
    EXPECT_EQ(CodeOf(request), grpc::StatusCode::RESOURCE_EXHAUSTED)
        << request.GetTypeName();
  }
};

TEST_F(QuestionsRpcTest, AllHaveWhatIsUsual) {
  ExpectUsual(Paths());
  ExpectUsual(Isolines());
  ExpectUsual(LogMap());
  ExpectUsual(Samples());
  ExpectUsual(Matrix());
  ExpectUsual(Nearest());
}

TEST_F(QuestionsRpcTest, WrongArgumentsAreNamed) {
  ExpectFaults(From<v1::ComputePathsRequest>(0), {{"", "targets"}});
  ExpectFaults(Paths(), {{"targets { vertex: 1000 }", "targets[1].vertex"},
                         {"radius: nan", "radius"}});
  ExpectFaults(From<v1::ComputeIsolinesRequest>(0), {{"", "levels"}});
  ExpectFaults(Isolines(), {{"levels: -1", "levels[1]"},
                            {"chord_error: nan", "chord_error"}});
  ExpectFaults(LogMap(), {{"source { vertex: 1000 }", "source.vertex"},
                          {"radius: -1", "radius"},
                          {"value_type: 7", "value_type"}});
  ExpectFaults(From<v1::SampleFarthestPointsRequest>(0), {{"", "count"}});
  ExpectFaults(Matrix(),
               {{"layout: 9", "layout"},
                {"value_type: 9", "value_type"},
                {"radius: -2", "radius"},
                {"sources { vertex: 0 offset: -1 }", "sources[2].offset"},
                {"sources { vertex: 1000 }", "sources[2].vertex"}});
  ExpectFaults(From<v1::FindNearestRequest>(0),
               {{"count: 1", "targets"}, {"targets { vertex: 1 }", "count"}});
}

TEST_F(QuestionsRpcTest, VerticesMayComeInTheShortForm) {
  const auto expect_equal = [&](auto request) {
    SCOPED_TRACE(request.GetTypeName());
    request.clear_targets();
    auto packed = request;
    for (const uint64_t vertex : {Vertex(3, 7), Vertex(0, 0), Vertex(9, 2)}) {
      request.add_targets()->set_vertex(vertex);
      packed.add_vertex_targets(static_cast<uint32_t>(vertex));
    }
    if constexpr (requires { packed.vertex_sources(); }) {
      packed.clear_sources();
      for (const auto& source : request.sources()) {
        packed.add_vertex_sources(static_cast<uint32_t>(source.vertex()));
      }
    }
    const Reply reply = Answered(request);
    const Reply again = Answered(packed);
    for (int i = 0; i < reply.header().arrays_size(); ++i) {
      EXPECT_FALSE(reply.Bytes(i).empty());
      EXPECT_TRUE(again.Bytes(i) == reply.Bytes(i));
    }
    ExpectFaults(packed, {{"targets { vertex: 1 }", "vertex_targets"},
                          {"vertex_targets: 1000", "targets[3].vertex"}});
    if constexpr (requires { packed.vertex_sources(); }) {
      const std::string next =
          absl::StrCat("sources[", packed.vertex_sources_size(), "].vertex");
      ExpectFaults(packed, {{"sources { vertex: 1 }", "vertex_sources"},
                            {"vertex_sources: 1000", next.c_str()}});
    }
  };
  expect_equal(FieldRequest(digest_, Vertex(4, 4)));
  expect_equal(Paths());
  expect_equal(Matrix());
  expect_equal(Nearest());
}

TEST_F(QuestionsRpcTest, ShortFormsCount) {
  v1::ComputeFieldRequest field = FieldRequest(digest_, 0);
  for (int i = 0; i < 101; ++i) field.add_vertex_targets(0);
  ExpectExhausted(field);
  v1::ComputeMatrixRequest matrix = Matrix();
  matrix.clear_sources();
  for (int i = 0; i < 201; ++i) matrix.add_vertex_sources(0);
  ExpectExhausted(matrix);
}

TEST_F(QuestionsRpcTest, NoneIsAboutNothing) {
  const auto expect_sources = [&](auto request) {
    request.clear_sources();
    EXPECT_EQ(Fault(request), "sources") << request.GetTypeName();
  };
  expect_sources(Paths());
  expect_sources(Isolines());
  expect_sources(Samples());
  expect_sources(Matrix());
  expect_sources(Nearest());
  v1::ComputeLogMapRequest map = LogMap();
  map.clear_source();
  EXPECT_EQ(Fault(map), "source");
}

TEST_F(QuestionsRpcTest, SizesHaveLimits) {
  v1::ComputePathsRequest paths = Paths();
  for (int i = 0; i < 100; ++i) paths.add_targets()->set_vertex(0);
  ExpectExhausted(paths);
  v1::ComputeIsolinesRequest isolines = Isolines();
  for (int i = 0; i < 5; ++i) isolines.add_levels(1 + i);
  ExpectExhausted(isolines);
  v1::SampleFarthestPointsRequest samples = Samples();
  samples.set_count(21);
  ExpectExhausted(samples);
  v1::ComputeMatrixRequest matrix = Matrix();
  while (matrix.sources_size() < 201) matrix.add_sources()->set_vertex(0);
  ExpectExhausted(matrix);
  // 200 rows of 10,201 values are more than the million.
  matrix.mutable_sources()->RemoveLast();
  matrix.set_mesh_digest(
      Upload(geodesic::test::MakeGrid({.columns = 100, .rows = 100})));
  ExpectExhausted(matrix);
}

class LittleMemoryTest : public QuestionsRpcTest {
 protected:
  void SetUp() override {
    ServerOptions options = SmallServer();
    options.limits.solver_memory_bytes = 1 << 20;
    options.limits.max_levels = 1000;
    StartWithGrid(/*held=*/false, options);
  }
};

TEST_F(LittleMemoryTest, LinesBeyondItAreRefused) {
  v1::ComputeIsolinesRequest request = Isolines();
  EXPECT_TRUE(Ask(request).status.ok());
  for (int i = 1; i < 1000; ++i) request.add_levels(0.004 * i);
  ExpectExhausted(request);
}

TEST_F(QuestionsRpcTest, PathsNumberSourcesAsTheRequestDoes) {
  v1::ComputePathsRequest request;
  request.set_mesh_digest(digest_);
  // Not in the order of the mesh, a curve in between.
  v1::Source& far = *request.add_sources();
  far.set_vertex(Vertex(10, 10));
  far.set_offset(0.5);
  request.add_sources()->mutable_curve()->add_points()->set_vertex(
      Vertex(10, 0));
  request.add_sources()->set_vertex(Vertex(0, 0));
  request.add_targets()->set_vertex(Vertex(9, 9));
  request.add_targets()->set_vertex(Vertex(9, 1));
  request.add_targets()->set_vertex(Vertex(1, 1));
  const Reply reply = Answered(request);
  EXPECT_EQ(reply.Values<uint32_t>("source"), (std::vector<uint32_t>{0, 1, 2}));
  const auto lengths = reply.Values<double>("length");
  const auto distances = reply.Values<double>("distance");
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(lengths[i], std::sqrt(2), 1e-10);
    EXPECT_NEAR(distances[i], std::sqrt(2) + (i == 0 ? 0.5 : 0), 1e-10);
  }
}

class HeldMatrixTest : public QuestionsRpcTest {
 protected:
  void SetUp() override { StartWithGrid(/*held=*/true); }
};

// A reader that stalls holds up its own matrix alone, after a few rows.
TEST_F(HeldMatrixTest, AStalledReaderHoldsAFewRows) {
  solver_.LetGo();  // it counts the rows
  soup_ = geodesic::test::Icosphere(5);
  digest_ = Upload(soup_);
  v1::ComputeMatrixRequest request;
  request.set_mesh_digest(digest_);
  for (int i = 0; i < 40; ++i) request.add_sources()->set_vertex(i);
  // The client must not read ahead.
  questions_ = v1::QuestionService::NewStub(SlowChannel(server_->port()));
  const auto call = Open(request);
  ASSERT_TRUE(call->Read());
  questions_ = v1::QuestionService::NewStub(channel_);
  // The jobs end by themselves: no more are submitted.
  EXPECT_TRUE(
      server_->engine().scheduler().WaitIdle(std::chrono::seconds(120)));
  // Questions of others are answered.
  EXPECT_TRUE(Ask(digest_, 0).status.ok());
  EXPECT_LT(solver_.starts(), 40);
  // Then it goes on to the end.
  Reply reply = test::ReadAll(*call->reader);
  EXPECT_TRUE(reply.status.ok()) << reply.status.error_message();
  reply.messages.insert(reply.messages.begin(), call->message);
  test::ExpectRules(reply, {});
}

}  // namespace
}  // namespace geodesic::server
