// What the client makes of the answers to its questions, and what it refuses.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "geodesic_client/client.h"
#include "tests/client/scripted_service.h"

namespace geodesic::client {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST_F(AnswersTest, FieldsSayWhatTheyAre) {
  Play({FieldHeader().Put(0, 0, D{0, 1.5, kInfinity}).Trailer()});
  const absl::StatusOr<Field> field = client_->ComputeField({});
  ASSERT_TRUE(field.ok()) << field.status();
  EXPECT_THAT(field->distances, ElementsAre(0, 1.5, kInfinity));
  EXPECT_EQ(field->mesh_digest, "abc");
  EXPECT_EQ(field->algorithm, "fwp-mmp");
  EXPECT_EQ(field->origin, FieldOrigin::kCached);
  EXPECT_EQ(field->statistics.iterations, 5);
  EXPECT_EQ(field->relative_tolerance, 1e-10);
  EXPECT_EQ(field->server_version, "1.2.3");
  EXPECT_EQ(field->settled_radius, 2);
}

TEST_F(AnswersTest, ReportsProgress) {
  v1::Answer progress;
  progress.mutable_progress()->set_settled_radius(0.5);
  progress.mutable_progress()->set_vertices_reached(2);
  Play({FieldHeader(), progress, Message().Put(0, 0, D{0, 1, 2}).Trailer()});
  std::vector<SolveProgress> seen;
  ASSERT_TRUE(
      client_
          ->ComputeField({}, {},
                         [&](const SolveProgress& now) { seen.push_back(now); })
          .ok());
  ASSERT_THAT(seen, SizeIs(1));
  EXPECT_EQ(seen[0].settled_radius, 0.5);
  EXPECT_EQ(seen[0].vertices_reached, 2);
  EXPECT_EQ(seen[0].vertex_count, 3);
}

TEST_F(AnswersTest, AnAnswerNeedsItsTrailer) {
  Play({FieldHeader().Put(0, 0, D{0, 1, 2})});
  ExpectDataLoss(client_->ComputeField({}).status(), "without its trailer");
  Play(std::vector<v1::Answer>{});
  ExpectDataLoss(client_->ComputeField({}).status(), "without its trailer");
}

class SettledTest : public AnswersTest {
 protected:
  absl::StatusOr<Field> Stream() {
    return client_->StreamField({}, [this](auto settled) {
      for (const SettledVertex& vertex : settled) {
        seen_.emplace_back(vertex.vertex, vertex.distance);
      }
    });
  }

  const Message header_ =
      Message().Words("settled_vertex", {-1}).Doubles("settled_distance", {-1});
  std::vector<std::pair<uint32_t, double>> seen_;
};

TEST_F(SettledTest, VerticesAreHandedOut) {
  Play({header_, Message().Put(0, 0, W{2, 0}).Put(1, 0, D{0}),
        Message().Put(1, 1, D{1, 1.5}).Put(0, 2, W{1}).Trailer()});
  const absl::StatusOr<Field> field = Stream();
  ASSERT_TRUE(field.ok()) << field.status();
  EXPECT_EQ(field->vertex_count, 3);
  EXPECT_THAT(field->distances, IsEmpty());
  EXPECT_THAT(seen_, ElementsAre(std::pair(2U, 0.0), std::pair(0U, 1.0),
                                 std::pair(1U, 1.5)));
}

TEST_F(SettledTest, RefusesWhatIsNotDue) {
  Play({header_, Message().Put(0, 0, W{2, 0}).Put(1, 0, D{0}).Trailer()});
  ExpectDataLoss(Stream().status(), "settled_distance");
  Play({header_,
        Message().Put(0, 0, W{2, 0, 1, 2}).Put(1, 0, D{0, 1, 2, 3}).Trailer()});
  ExpectDataLoss(Stream().status(), "settled");
}

Message LineHeader(int64_t lines) {
  return Message()
      .Longs("line_end", {lines})
      .Doubles("position", {-1, 3})
      .Bytes("point_kind", {-1})
      .Words("point_numbers", {-1, 2})
      .Doubles("point_weights", {-1, 3});
}

// As many points as `kinds`, each at (its number, 0, 0).
Message& PutPoints(Message& message, uint64_t first, const B& kinds) {
  D positions;
  W numbers;
  D weights;
  for (uint64_t i = first; i < first + kinds.size(); ++i) {
    const auto number = static_cast<uint32_t>(i);
    positions.insert(positions.end(), {static_cast<double>(i), 0, 0});
    numbers.insert(numbers.end(), {number, number + 1});
    weights.insert(weights.end(), {0.25, 0.25, 0.5});
  }
  return message.Put(1, 3 * first, positions)
      .Put(2, first, kinds)
      .Put(3, 2 * first, numbers)
      .Put(4, 3 * first, weights);
}
Message Points(uint64_t first, const B& kinds) {
  Message message;
  return PutPoints(message, first, kinds);
}

class PathsTest : public AnswersTest {
 protected:
  const PathQuery query_ = {.targets = {VertexPoint{0}, VertexPoint{1}}};
  const Message header_ = LineHeader(2)
                              .Words("source", {2})
                              .Doubles("distance", {2})
                              .Doubles("length", {2});
  const Message ends_ = Message()
                            .Put(5, 0, W{4, kNoSource})
                            .Put(6, 0, D{3, kInfinity})
                            .Put(7, 0, D{2, kInfinity})
                            .Trailer();
};

TEST_F(PathsTest, HaveAllKindsOfPoints) {
  Play({header_, Points(0, {0, 1}), Points(2, {2}).Put(0, 0, L{3, 3}), ends_});
  const absl::StatusOr<PathAnswer> answer = client_->ComputePaths(query_);
  ASSERT_TRUE(answer.ok()) << answer.status();
  ASSERT_THAT(answer->paths, SizeIs(2));
  const GeodesicPath& path = answer->paths[0];
  EXPECT_EQ(path.source, 4);
  EXPECT_EQ(path.distance, 3);
  EXPECT_EQ(path.length, 2);
  EXPECT_THAT(path.line.points,
              ElementsAre(VertexPoint{0}, EdgePoint{1, 2, 0.25},
                          FacePoint{2, {0.25, 0.25, 0.5}}));
  EXPECT_THAT(path.line.positions,
              ElementsAre(Point{0, 0, 0}, Point{1, 0, 0}, Point{2, 0, 0}));
  EXPECT_EQ(answer->paths[1].source, std::nullopt);
  EXPECT_THAT(answer->paths[1].line.points, IsEmpty());
  EXPECT_EQ(answer->info.compute_seconds, 7);
}

TEST_F(PathsTest, RefusesLinesThatAreNone) {
  const std::vector<std::pair<Message, std::string>> table = {
      {Points(0, {0, 3}).Put(0, 0, L{1, 2}), "kind 3"},
      {Points(0, {0, 0}).Put(0, 0, L{2, 1}), "within line or row 1"},
      {Points(0, {0, 0}).Put(0, 0, L{1, 3}), "within line or row 1"},
      {Points(0, {0, 0}).Put(0, 0, L{1, 1}), "within line or row 2"},
      {Points(0, {0, 0}).Put(0, 0, L{2}), "1 of 2 numbers of line_end"},
      {Points(0, {0, 0}).Put(1, 6, D{0, 0, 0}).Put(0, 0, L{1, 2}),
       "of point_kind"}};
  for (const auto& [lines, words] : table) {
    Play({header_, lines, ends_});
    ExpectDataLoss(client_->ComputePaths(query_).status(), words);
  }
}

TEST_F(AnswersTest, IsolinesAreAsManyAsCome) {
  Message header = LineHeader(-1);
  header.Doubles("level", {-1}).Bytes("is_closed", {-1});
  Play({header, Points(0, {0, 0, 0})
                    .Put(0, 0, L{1, 3})
                    .Put(5, 0, D{0.5, 1})
                    .Put(6, 0, B{1, 0})
                    .Trailer()});
  const absl::StatusOr<IsolineAnswer> answer = client_->ComputeIsolines({});
  ASSERT_TRUE(answer.ok()) << answer.status();
  ASSERT_THAT(answer->isolines, SizeIs(2));
  EXPECT_EQ(answer->isolines[0].level, 0.5);
  EXPECT_TRUE(answer->isolines[0].is_closed);
  EXPECT_FALSE(answer->isolines[1].is_closed);
  EXPECT_THAT(answer->isolines[1].line.points, SizeIs(2));
  Play({header, Points(0, {0, 0})
                    .Put(0, 0, L{1, 2})
                    .Put(5, 0, D{0.5})
                    .Put(6, 0, B{1, 0})
                    .Trailer()});
  ExpectDataLoss(client_->ComputeIsolines({}).status(),
                 "1 of 2 numbers of level");
}

class MatrixTest : public AnswersTest {
 protected:
  absl::Status Ask(bool sparse) {
    query_.sparse = sparse;
    matrix_ = {.status = matrix_.status};
    return client_->ComputeMatrix(query_, matrix_.Receiver()).status();
  }

  MatrixQuery query_ = {.sources = {{VertexPoint{0}}, {VertexPoint{1}}}};
  const Message dense_ = Message().Doubles("distance", {2, 3});
  const Message sparse_ = Message()
                              .Longs("row_end", {2})
                              .Words("column", {-1})
                              .Doubles("distance", {-1});
  Matrix matrix_;
};

TEST_F(MatrixTest, SparseRowsHaveColumnsAndMayBeEmpty) {
  Play({sparse_, Message().Put(1, 0, W{0, 2}).Put(2, 0, D{1}),
        Message().Put(0, 0, L{2}).Put(2, 1, D{2}),
        Message().Put(0, 1, L{2}).Trailer()});
  ASSERT_TRUE(Ask(true).ok());
  EXPECT_THAT(matrix_.shape, ElementsAre(2, 3));
  EXPECT_THAT(matrix_.rows,
              ElementsAre(std::pair(W{0, 2}, D{1, 2}), std::pair(W{}, D{})));
}

TEST_F(MatrixTest, RefusesRowsThatAreNone) {
  const std::vector<std::pair<Message, std::string>> table = {
      {Message().Put(0, 0, L{1, 2}).Put(1, 0, W{0, 3}).Put(2, 0, D{1, 2}),
       "column 3 of 3 in row 1"},
      {Message().Put(0, 0, L{2, 1}).Put(1, 0, W{0, 1}).Put(2, 0, D{1, 2}),
       "within line or row 1"},
      {Message().Put(0, 0, L{1, 3}).Put(1, 0, W{0, 1}).Put(2, 0, D{1, 2}),
       "within line or row 1"},
      {Message().Put(0, 0, L{1, 1}).Put(1, 0, W{0, 1}).Put(2, 0, D{1, 2}),
       "within line or row 2"},
      {Message().Put(0, 0, L{1, 2}).Put(1, 0, W{0, 1}).Put(2, 0, D{1}),
       "1 of 2 numbers of distance"},
      {Message().Put(0, 0, L{2}).Put(1, 0, W{0, 1}).Put(2, 0, D{1, 2}),
       "1 of 2 numbers of row_end"}};
  for (auto [rows, words] : table) {
    Play({sparse_, rows.Trailer()});
    ExpectDataLoss(Ask(true), words);
  }
  Play({dense_, Message().Put(0, 0, D{1, 2, 3, 4, 5}).Trailer()});
  ExpectDataLoss(Ask(false), "5 of 6");
  Play({Message().Doubles("distance", {3, 3})});
  ExpectDataLoss(Ask(false), "numbers of distance");
}

TEST_F(AnswersTest, NearestTargetsComeBySource) {
  const NearestQuery query = {
      .sources = {{VertexPoint{0}}, {VertexPoint{1}}},
      .targets = {VertexPoint{0}, VertexPoint{1}, VertexPoint{2}}};
  const Message header = Message()
                             .Longs("row_end", {2})
                             .Words("target", {-1})
                             .Doubles("distance", {-1});
  Play({header, Message()
                    .Put(0, 0, L{0, 2})
                    .Put(1, 0, W{2, 0})
                    .Put(2, 0, D{1, 2})
                    .Trailer()});
  const absl::StatusOr<NearestAnswer> answer = client_->FindNearest(query);
  ASSERT_TRUE(answer.ok()) << answer.status();
  EXPECT_THAT(answer->found,
              ElementsAre(IsEmpty(), ElementsAre(NearestTarget{2, 1},
                                                 NearestTarget{0, 2})));
  Play(
      {header,
       Message().Put(0, 0, L{0, 1}).Put(1, 0, W{3}).Put(2, 0, D{1}).Trailer()});
  ExpectDataLoss(client_->FindNearest(query).status(), "column 3 of 3");
}

TEST_F(AnswersTest, ALogMapIsItsArrays) {
  Play({Message()
            .Doubles("zero_direction", {3})
            .Doubles("coordinates", {3, 2})
            .Put(0, 0, D{0, 1, 0})
            .Put(1, 0, D{0, 0, 1, 2, 3, 4})
            .Trailer()});
  const absl::StatusOr<LogMap> map = client_->ComputeLogMap({});
  ASSERT_TRUE(map.ok()) << map.status();
  EXPECT_EQ(map->zero_direction, (Point{0, 1, 0}));
  EXPECT_THAT(map->coordinates,
              ElementsAre(std::array{0.0, 0.0}, std::array{1.0, 2.0},
                          std::array{3.0, 4.0}));
}

// A pair's path is handed out after its distance, whichever comes first.
// Also in the second of two calls.
TEST_F(AnswersTest, PathsOfPairsFollowTheirDistances) {
  Message header = LineHeader(1);
  header.Doubles("distance", {1});
  const auto call = [&](double distance) {
    return Stream{{header, Points(0, {0, 0}).Put(0, 0, L{2}),
                   Message().Put(5, 0, D{distance}).Trailer()}};
  };
  Play({call(3), call(4)});
  std::string order;
  const absl::StatusOr<PairSummary> summary = client_->ComputePairs(
      {.pairs = {{VertexPoint{0}, VertexPoint{1}},
                 {VertexPoint{0}, VertexPoint{2}}},
       .paths = true},
      {.on_distances =
           [&](uint64_t first, std::span<const double> distances) {
             absl::StrAppend(&order, "distance ", distances[0], " of ", first,
                             "; ");
             return absl::OkStatus();
           },
       .on_path =
           [&](uint64_t pair, const Polyline& path) {
             absl::StrAppend(&order, path.points.size(), " points of ", pair,
                             "; ");
             return absl::OkStatus();
           }});
  ASSERT_TRUE(summary.ok()) << summary.status();
  EXPECT_EQ(order,
            "distance 3 of 0; 2 points of 0; "
            "distance 4 of 1; 2 points of 1; ");
}

}  // namespace
}  // namespace geodesic::client
