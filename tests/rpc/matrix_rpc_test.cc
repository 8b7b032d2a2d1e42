// MatrixService: blocks of the distance matrix and nearest members.

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "tests/rpc/questions_fixture.h"
#include "tests/support/curved_meshes.h"

namespace geodesic::server {
namespace {

using test::Euclid;
using test::kInfinity;
using test::Values;

class MatrixRpcTest : public test::QuestionsTest {
 protected:
  struct Row {
    std::vector<uint32_t> columns;
    std::vector<double> values;
  };

  static Row ValuesOf(const v1::MatrixChunk& chunk) {
    return {Values<uint32_t>(chunk.columns()), Values<double>(chunk.values())};
  }
  static Row ValuesOf(const v1::NearestChunk& chunk) {
    return {Values<uint32_t>(chunk.targets()),
            Values<double>(chunk.distances())};
  }

  // The rows of a reply, checked for their order.
  template <typename Response>
  static std::vector<Row> Rows(const std::vector<Response>& messages) {
    std::vector<Row> rows;
    bool open = false;  // the last row is not complete
    for (const Response& message : messages) {
      if (!message.has_chunk()) continue;
      const auto& chunk = message.chunk();
      if (!open) rows.emplace_back();
      EXPECT_EQ(chunk.row(), rows.size() - 1);
      Row& row = rows.back();
      EXPECT_EQ(chunk.offset(), row.values.size());
      const auto [c, v] = ValuesOf(chunk);
      row.columns.insert(row.columns.end(), c.begin(), c.end());
      row.values.insert(row.values.end(), v.begin(), v.end());
      open = row.values.size() < chunk.value_count();
    }
    EXPECT_FALSE(open);
    return rows;
  }

  // Rows in no order, a point in a face and a curve among them.
  v1::ComputeMatrixRequest Request() const {
    v1::ComputeMatrixRequest request;
    request.set_mesh_digest(digest_);
    request.add_sources()->set_vertex(Vertex(9, 9));
    request.add_sources()->mutable_curve()->add_points()->set_vertex(
        Vertex(3, 0));
    SetEdge(Vertex(5, 5), Vertex(6, 5), 0.5, *request.add_sources());
    request.add_sources()->set_vertex(Vertex(0, 4));
    return request;
  }
  const std::vector<Point> row_points_ = {
      {9, 9, 0}, {3, 0, 0}, {5.5, 5, 0}, {0, 4, 0}};
};

TEST_F(MatrixRpcTest, EveryVertexIsAColumn) {
  const auto messages = Messages(Request());
  const v1::MatrixHeader& header = messages.front().header();
  ExpectHeader(header.answer());
  EXPECT_EQ(header.row_count(), 4);
  EXPECT_EQ(header.column_count(), soup_.positions.size());
  EXPECT_EQ(header.value_type(), v1::VALUE_TYPE_FLOAT64);
  EXPECT_EQ(header.layout(), v1::MATRIX_LAYOUT_DENSE);
  const std::vector<Row> rows = Rows(messages);
  ASSERT_EQ(rows.size(), 4);
  for (size_t r = 0; r < rows.size(); ++r) {
    ASSERT_EQ(rows[r].values.size(), soup_.positions.size());
    EXPECT_TRUE(rows[r].columns.empty());
    for (size_t v = 0; v < soup_.positions.size(); ++v) {
      EXPECT_NEAR(rows[r].values[v], Euclid(row_points_[r], soup_.positions[v]),
                  1e-10);
    }
  }
  const v1::AnswerTrailer& trailer = messages.back().trailer();
  EXPECT_EQ(trailer.item_count(), 4);
  EXPECT_GT(trailer.windows_propagated(), 0);
}

TEST_F(MatrixRpcTest, TargetsAreColumns) {
  v1::ComputeMatrixRequest request = Request();
  request.add_targets()->set_vertex(Vertex(8, 1));
  SetEdge(Vertex(2, 2), Vertex(2, 3), 0.75, *request.add_targets());
  const std::vector<Point> columns = {{8, 1, 0}, {2, 2.75, 0}};
  const auto messages = Messages(request);
  const std::vector<Row> rows = Rows(messages);
  ASSERT_EQ(rows.size(), 4);
  for (size_t r = 0; r < 4; ++r) {
    ASSERT_EQ(rows[r].values.size(), 2);
    for (size_t c = 0; c < 2; ++c) {
      EXPECT_NEAR(rows[r].values[c], Euclid(row_points_[r], columns[c]), 1e-10);
    }
  }
}

TEST_F(MatrixRpcTest, SparseRowsHoldWhatIsWithinTheRadius) {
  v1::ComputeMatrixRequest request = Request();
  request.set_layout(v1::MATRIX_LAYOUT_SPARSE);
  request.set_radius(2.5);
  const auto messages = Messages(request);
  EXPECT_EQ(messages.front().header().layout(), v1::MATRIX_LAYOUT_SPARSE);
  const std::vector<Row> rows = Rows(messages);
  ASSERT_EQ(rows.size(), 4);
  for (size_t r = 0; r < 4; ++r) {
    size_t at = 0;
    for (uint32_t v = 0; v < soup_.positions.size(); ++v) {
      const double expected = Euclid(row_points_[r], soup_.positions[v]);
      if (expected > 2.5) continue;
      ASSERT_LT(at, rows[r].columns.size());
      EXPECT_EQ(rows[r].columns[at], v);
      EXPECT_NEAR(rows[r].values[at], expected, 1e-10);
      ++at;
    }
    EXPECT_EQ(at, rows[r].columns.size());
  }
}

TEST_F(MatrixRpcTest, TheWholeMatrixOfASurfaceIsSymmetric) {
  soup_ = geodesic::test::Icosphere(2);
  digest_ = Upload(soup_);
  v1::ComputeMatrixRequest request;
  request.set_mesh_digest(digest_);
  const size_t n = soup_.positions.size();
  for (size_t v = 0; v < n; ++v) request.add_sources()->set_vertex(v);
  const auto messages = Messages(request);
  const std::vector<Row> rows = Rows(messages);
  ASSERT_EQ(rows.size(), n);
  for (size_t i = 0; i < n; ++i) {
    EXPECT_EQ(rows[i].values[i], 0);
    for (size_t j = 0; j < i; ++j) {
      EXPECT_NEAR(rows[i].values[j], rows[j].values[i], 1e-10);
      EXPECT_GE(rows[i].values[j] * (1 + 1e-12),
                Euclid(soup_.positions[i], soup_.positions[j]));
    }
  }
}

TEST_F(MatrixRpcTest, SinglePrecisionHalvesTheBytes) {
  v1::ComputeMatrixRequest request = Request();
  request.set_value_type(v1::VALUE_TYPE_FLOAT32);
  const auto messages = Messages(request);
  for (const auto& message : messages) {
    if (!message.has_chunk()) continue;
    const auto values = Values<float>(message.chunk().values());
    ASSERT_EQ(values.size(), soup_.positions.size());
    EXPECT_FLOAT_EQ(values[0], Euclid(row_points_[message.chunk().row()],
                                      soup_.positions[0]));
  }
}

TEST_F(MatrixRpcTest, TheNearestAreFoundInOrder) {
  v1::FindNearestRequest request;
  request.set_mesh_digest(digest_);
  *request.mutable_sources() = Request().sources();
  std::vector<Point> targets;
  for (const auto& [x, y] : {std::pair<uint32_t, uint32_t>{1, 1},
                             {8, 8},
                             {5, 6},
                             {3, 1},
                             {0, 9},
                             {7, 2}}) {
    request.add_targets()->set_vertex(Vertex(x, y));
    targets.push_back({double(x), double(y), 0});
  }
  request.set_count(3);
  const auto messages = Messages(request);
  const std::vector<Row> rows = Rows(messages);
  ASSERT_EQ(rows.size(), 4);
  for (size_t r = 0; r < 4; ++r) {
    std::vector<double> expected;
    for (const Point& target : targets) {
      expected.push_back(Euclid(row_points_[r], target));
    }
    ASSERT_EQ(rows[r].values.size(), 3);
    for (size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(rows[r].values[i], expected[rows[r].columns[i]], 1e-10);
    }
    std::ranges::sort(expected);
    for (size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(rows[r].values[i], expected[i], 1e-10);
    }
  }
  // Fewer, where the radius allows no more.
  request.set_radius(1.5);
  const std::vector<Row> near = Rows(Messages(request));
  ASSERT_EQ(near.size(), 4);
  EXPECT_EQ(near[0].columns, std::vector<uint32_t>{1});
  EXPECT_EQ(near[1].columns, std::vector<uint32_t>{3});
  EXPECT_EQ(near[2].columns, std::vector<uint32_t>{2});
  EXPECT_TRUE(near[3].columns.empty());
}

TEST_F(MatrixRpcTest, WrongArgumentsAreNamed) {
  v1::ComputeMatrixRequest request = Request();
  ExpectFaults(request,
               {{"layout: 9", "layout"},
                {"value_type: 9", "value_type"},
                {"radius: -2", "radius"},
                {"sources { vertex: 0 offset: -1 }", "sources[4].offset"},
                {"sources { vertex: 1000 }", "sources[4].vertex"}});
  ExpectUsual(request);
  request.clear_sources();
  EXPECT_EQ(Fault(request), "sources");

  v1::FindNearestRequest nearest;
  nearest.set_mesh_digest(digest_);
  nearest.add_sources()->set_vertex(0);
  ExpectFaults(nearest,
               {{"count: 1", "targets"}, {"targets { vertex: 1 }", "count"}});
  nearest.set_count(1);
  nearest.add_targets()->set_vertex(1);
  ExpectUsual(nearest);
}

TEST_F(MatrixRpcTest, SizesHaveLimits) {
  v1::ComputeMatrixRequest request;
  request.set_mesh_digest(digest_);
  for (int i = 0; i < 201; ++i) request.add_sources()->set_vertex(0);
  EXPECT_EQ(CodeOf(request), grpc::StatusCode::RESOURCE_EXHAUSTED);
  // 200 rows of 10,201 values are more than the million.
  request.mutable_sources()->RemoveLast();
  soup_ = geodesic::test::MakeGrid({.columns = 100, .rows = 100});
  request.set_mesh_digest(Upload(soup_));
  EXPECT_EQ(CodeOf(request), grpc::StatusCode::RESOURCE_EXHAUSTED);
}

class HeldMatrixTest : public MatrixRpcTest {
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
  const auto slow = v1::MatrixService::NewStub(SlowChannel(server_->port()));
  grpc::ClientContext context;
  const auto reader = slow->ComputeMatrix(&context, request);
  v1::ComputeMatrixResponse message;
  ASSERT_TRUE(reader->Read(&message));
  // The jobs end by themselves: no more are submitted.
  EXPECT_TRUE(
      server_->engine().scheduler().WaitIdle(std::chrono::seconds(120)));
  // Questions of others are answered.
  EXPECT_TRUE(ComputeField(digest_, 0).status.ok());
  EXPECT_LT(solver_.starts(), 40);
  // Then it goes on to the end.
  const auto rest = ReadAll(*reader);
  EXPECT_TRUE(rest.status.ok()) << rest.status.error_message();
  EXPECT_EQ(rest.messages.back().trailer().item_count(), 40);
}

}  // namespace
}  // namespace geodesic::server
