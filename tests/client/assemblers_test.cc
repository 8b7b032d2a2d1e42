// What is put together from the messages of streams, and what is refused.

#include "client/src/assemblers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "absl/status/status.h"

namespace geodesic::client {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

// Elements as they travel.
template <typename Element>
std::string Bytes(const std::vector<Element>& elements) {
  return {reinterpret_cast<const char*>(elements.data()),
          elements.size() * sizeof(Element)};
}

void ExpectDataLoss(const absl::Status& status, const std::string& words) {
  EXPECT_EQ(status.code(), absl::StatusCode::kDataLoss) << status;
  EXPECT_THAT(std::string(status.message()), HasSubstr(words));
}

// Vertices `first`, first + 1, ... at (number, 0, 0).
v1::PolylinePiece Piece(uint64_t point_count, uint64_t first, uint64_t count) {
  v1::PolylinePiece piece;
  piece.set_point_count(point_count);
  piece.set_first_point(first);
  for (uint64_t i = first; i < first + count; ++i) {
    piece.add_points()->set_vertex(i);
    const Point position = {static_cast<double>(i), 0, 0};
    piece.mutable_positions()->append(
        reinterpret_cast<const char*>(position.data()), sizeof(position));
  }
  return piece;
}

TEST(PolylineAssemblerTest, PutsPiecesTogether) {
  PolylineAssembler assembler;
  Polyline line;
  Polyline empty;
  ASSERT_TRUE(assembler.Consume(Piece(5, 0, 2), &line).ok());
  EXPECT_FALSE(assembler.complete());
  ASSERT_TRUE(assembler.Consume(Piece(5, 2, 3), &line).ok());
  EXPECT_TRUE(assembler.complete());
  ASSERT_EQ(line.points.size(), 5);
  EXPECT_EQ(line.points[4], SurfacePoint(VertexPoint{4}));
  EXPECT_EQ(line.positions[4], (Point{4, 0, 0}));
  // A line without points is one piece.
  EXPECT_TRUE(assembler.Consume(Piece(0, 0, 0), &empty).ok());
  EXPECT_TRUE(assembler.complete());
}

TEST(PolylineAssemblerTest, KnowsAllKindsOfPoints) {
  v1::PolylinePiece piece = Piece(3, 0, 3);
  piece.mutable_points(1)->mutable_edge()->set_from(1);
  piece.mutable_points(1)->mutable_edge()->set_to(2);
  piece.mutable_points(1)->mutable_edge()->set_t(0.5);
  v1::FacePoint* face = piece.mutable_points(2)->mutable_face();
  face->set_face(9);
  for (const double weight : {0.25, 0.25, 0.5}) face->add_weights(weight);
  PolylineAssembler assembler;
  Polyline line;
  ASSERT_TRUE(assembler.Consume(piece, &line).ok());
  EXPECT_EQ(line.points[1], SurfacePoint(EdgePoint{1, 2, 0.5}));
  EXPECT_EQ(line.points[2], SurfacePoint(FacePoint{9, {0.25, 0.25, 0.5}}));
}

TEST(PolylineAssemblerTest, RefusesWhatIsNotDue) {
  const auto refused = [](const std::vector<v1::PolylinePiece>& pieces) {
    PolylineAssembler assembler;
    Polyline line;
    absl::Status status;
    for (const v1::PolylinePiece& piece : pieces) {
      status = assembler.Consume(piece, &line);
    }
    return status.code() == absl::StatusCode::kDataLoss;
  };
  EXPECT_TRUE(refused({Piece(3, 1, 2)}));                  // a gap
  EXPECT_TRUE(refused({Piece(3, 0, 1), Piece(3, 0, 1)}));  // again
  EXPECT_TRUE(refused({Piece(3, 0, 1), Piece(4, 1, 2)}));  // another length
  EXPECT_TRUE(refused({Piece(2, 0, 3)}));                  // too many
  EXPECT_TRUE(refused({Piece(2, 0, 0)}));                  // without end
  v1::PolylinePiece piece = Piece(2, 0, 2);
  piece.mutable_positions()->pop_back();
  EXPECT_TRUE(refused({piece}));
  piece = Piece(1, 0, 1);
  piece.mutable_points(0)->clear_place();
  EXPECT_TRUE(refused({piece}));
}

class RowAssemblerTest : public ::testing::Test {
 protected:
  absl::Status Consume(RowAssembler* assembler, uint64_t row, uint64_t count,
                       uint64_t offset, const std::vector<double>& values,
                       const std::vector<uint32_t>& columns = {}) {
    const std::string numbers = Bytes(columns);
    const std::string bytes = Bytes(values);
    return assembler->Consume({row, count, offset, numbers, bytes}, 3);
  }

  RowAssembler dense_{ValueType::kFloat64, false};
  RowAssembler sparse_{ValueType::kFloat64, true};
};

TEST_F(RowAssemblerTest, DenseRowsComeInPieces) {
  ASSERT_TRUE(Consume(&dense_, 0, 3, 0, {1, 2}).ok());
  EXPECT_FALSE(dense_.complete());
  EXPECT_EQ(dense_.row_count(), 0);
  ASSERT_TRUE(Consume(&dense_, 0, 3, 2, {3}).ok());
  EXPECT_TRUE(dense_.complete());
  EXPECT_THAT(dense_.values(), ElementsAre(1, 2, 3));
  ASSERT_TRUE(Consume(&dense_, 1, 3, 0, {4, 5, 6}).ok());
  EXPECT_EQ(dense_.row(), 1);
  EXPECT_EQ(dense_.row_count(), 2);
  EXPECT_THAT(dense_.values(), ElementsAre(4, 5, 6));
}

TEST_F(RowAssemblerTest, SparseRowsHaveColumnsAndMayBeEmpty) {
  ASSERT_TRUE(Consume(&sparse_, 0, 0, 0, {}).ok());
  EXPECT_TRUE(sparse_.complete());
  ASSERT_TRUE(Consume(&sparse_, 1, 2, 0, {1, 2}, {0, 2}).ok());
  EXPECT_THAT(sparse_.numbers(), ElementsAre(0, 2));
  EXPECT_EQ(sparse_.row_count(), 2);
}

TEST_F(RowAssemblerTest, FloatsBecomeDoubles) {
  RowAssembler assembler(ValueType::kFloat32, false);
  const std::string bytes = Bytes(std::vector<float>{0.5F, 0.1F});
  ASSERT_TRUE(assembler.Consume({0, 2, 0, "", bytes}, 2).ok());
  EXPECT_THAT(assembler.values(), ElementsAre(0.5, double{0.1F}));
}

TEST_F(RowAssemblerTest, RefusesWhatIsNotDue) {
  const auto refused = [this](RowAssembler assembler, uint64_t row,
                              uint64_t count, uint64_t offset,
                              const std::vector<double>& values,
                              const std::vector<uint32_t>& columns = {}) {
    return Consume(&assembler, row, count, offset, values, columns).code() ==
           absl::StatusCode::kDataLoss;
  };
  EXPECT_TRUE(refused(dense_, 1, 3, 0, {1, 2, 3}));     // another row
  EXPECT_TRUE(refused(dense_, 0, 3, 1, {1, 2}));        // a gap
  EXPECT_TRUE(refused(dense_, 0, 2, 0, {1, 2}));        // too short
  EXPECT_TRUE(refused(dense_, 0, 3, 0, {1, 2, 3, 4}));  // too long
  EXPECT_TRUE(refused(dense_, 0, 3, 0, {}));            // without end
  EXPECT_TRUE(refused(dense_, 0, 3, 0, {1, 2, 3}, {0, 1, 2}));
  EXPECT_TRUE(refused(sparse_, 0, 2, 0, {1, 2}, {0}));
  EXPECT_TRUE(refused(sparse_, 0, 1, 0, {1}, {3}));  // no such column
  EXPECT_TRUE(refused(sparse_, 0, 4, 0, {1}, {0}));
  EXPECT_EQ(dense_.Consume({0, 3, 0, "", "123"}, 3).code(),
            absl::StatusCode::kDataLoss);
}

v1::ReadMeshResponse Header(uint64_t vertices, uint64_t faces) {
  v1::ReadMeshResponse message;
  message.mutable_header()->set_vertex_count(vertices);
  message.mutable_header()->set_face_count(faces);
  return message;
}

v1::ReadMeshResponse Vertices(uint64_t first,
                              const std::vector<Point>& points) {
  v1::ReadMeshResponse message;
  message.mutable_vertices()->set_first_vertex(first);
  message.mutable_vertices()->set_positions(Bytes(points));
  return message;
}

v1::ReadMeshResponse Faces(uint64_t first,
                           const std::vector<Triangle>& triangles) {
  v1::ReadMeshResponse message;
  message.mutable_faces()->set_first_face(first);
  message.mutable_faces()->set_indices(Bytes(triangles));
  return message;
}

// The first status that is not OK, Finish's included.
absl::Status Assemble(const std::vector<v1::ReadMeshResponse>& messages,
                      MeshArrays* mesh = nullptr) {
  MeshAssembler assembler;
  for (const v1::ReadMeshResponse& message : messages) {
    absl::Status status = assembler.Consume(message);
    if (!status.ok()) return status;
  }
  absl::StatusOr<MeshArrays> finished = std::move(assembler).Finish();
  if (finished.ok() && mesh != nullptr) *mesh = *std::move(finished);
  return finished.status();
}

const Point kA = {0, 0, 0};
const Point kB = {1, 0, 0.1};
const Point kC = {0, 1, 1e300};

TEST(MeshAssemblerTest, PutsChunksTogether) {
  MeshArrays mesh;
  ASSERT_TRUE(Assemble({Header(3, 2), Vertices(0, {kA, kB}), Vertices(2, {kC}),
                        Faces(0, {{0, 1, 2}}), Faces(1, {{2, 1, 0}})},
                       &mesh)
                  .ok());
  EXPECT_THAT(mesh.positions, ElementsAre(kA, kB, kC));
  EXPECT_THAT(mesh.triangles,
              ElementsAre(Triangle{0, 1, 2}, Triangle{2, 1, 0}));
}

TEST(MeshAssemblerTest, RefusesWhatIsNotDue) {
  v1::ReadMeshResponse part;
  part.mutable_vertices()->set_positions("0123456789");
  // Counts that are no reason to take memory.
  constexpr uint64_t kHuge = std::numeric_limits<uint64_t>::max();
  const std::vector<std::pair<std::vector<v1::ReadMeshResponse>, std::string>>
      table = {
          {{Vertices(0, {kA})}, "without its header"},
          {{Header(1, 0), Header(1, 0)}, "twice"},
          {{Header(3, 0), Vertices(1, {kB})}, "from number 1"},
          {{Header(1, 0), Vertices(0, {kA, kB})}, "of 1"},
          {{Header(3, 0), part}, "10 bytes of vertices"},
          {{Header(2, 1), Vertices(0, {kA})}, "1 of 2"},
          {{Header(3, 1), Vertices(0, {kA, kB, kC}), Faces(0, {{0, 1, 3}})},
           "face 0 with vertex 3 of 3"},
          {{Header(kHuge, kHuge), Vertices(0, {kA})}, "1 of"}};
  for (const auto& [messages, words] : table) {
    ExpectDataLoss(Assemble(messages), words);
  }
}

using v1::ComputeFieldResponse;
using Messages = std::vector<ComputeFieldResponse>;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

ComputeFieldResponse Accepted(uint64_t vertex_count) {
  ComputeFieldResponse message;
  message.mutable_header()->set_vertex_count(vertex_count);
  message.mutable_header()->set_mesh_digest("abc");
  message.mutable_header()->set_algorithm(v1::ALGORITHM_FWP_MMP);
  return message;
}

ComputeFieldResponse Chunk(uint64_t offset, const std::vector<double>& values,
                           const std::string& field_id = "") {
  ComputeFieldResponse message;
  message.mutable_chunk()->set_offset(offset);
  message.mutable_chunk()->set_distances(Bytes(values));
  message.mutable_chunk()->set_field_id(field_id);
  return message;
}

ComputeFieldResponse Settled(uint64_t offset,
                             const std::vector<uint32_t>& vertices,
                             const std::vector<double>& distances) {
  ComputeFieldResponse message;
  message.mutable_settled()->set_offset(offset);
  message.mutable_settled()->set_vertices(Bytes(vertices));
  message.mutable_settled()->set_distances(Bytes(distances));
  return message;
}

ComputeFieldResponse Trailer() {
  ComputeFieldResponse message;
  message.mutable_trailer()->set_origin(v1::FIELD_ORIGIN_CACHED);
  message.mutable_trailer()->mutable_statistics()->set_iterations(7);
  message.mutable_trailer()->set_relative_tolerance(1e-10);
  message.mutable_trailer()->set_server_version("1.2.3");
  return message;
}

// Takes the messages; the first status that is not OK.
absl::Status Consume(const Messages& messages, FieldAssembler* assembler) {
  absl::Status status;
  for (const ComputeFieldResponse& message : messages) {
    status.Update(assembler->Consume(message));
  }
  return status;
}

// The field that these messages make, or why there is none.
absl::StatusOr<Field> Assembled(const Messages& messages,
                                const FieldQuery& query = {},
                                const SettledCallback& on_settled = nullptr) {
  FieldAssembler assembler(query, on_settled, nullptr);
  absl::Status status = Consume(messages, &assembler);
  if (!status.ok()) return status;
  return std::move(assembler).Finish();
}

TEST(FieldAssemblerTest, PutsChunksTogether) {
  const absl::StatusOr<Field> field =
      Assembled({Accepted(4), Chunk(0, {0, 1.5}), Chunk(2, {kInfinity, 2.25}),
                 Trailer()});
  ASSERT_TRUE(field.ok()) << field.status();
  EXPECT_THAT(field->distances, ElementsAre(0, 1.5, kInfinity, 2.25));
  EXPECT_EQ(field->mesh_digest, "abc");
  EXPECT_EQ(field->algorithm, "fwp-mmp");
  EXPECT_EQ(field->origin, FieldOrigin::kCached);
  EXPECT_EQ(field->statistics.iterations, 7);
  EXPECT_EQ(field->relative_tolerance, 1e-10);
  EXPECT_EQ(field->server_version, "1.2.3");
}

class BrokenStreamTest : public ::testing::Test {
 protected:
  const FieldQuery query_ = {};
  FieldAssembler assembler_{query_, nullptr, nullptr};
};

TEST_F(BrokenStreamTest, IsReadOn) {
  ASSERT_TRUE(
      Consume({Accepted(4), Chunk(0, {0, 1.5}, "the field"), Chunk(2, {2})},
              &assembler_)
          .ok());
  const FieldAssembler::Position position = assembler_.Resume();
  EXPECT_EQ(position.field_id, "the field");
  EXPECT_EQ(position.first_vertex, 3);
  EXPECT_FALSE(assembler_.has_header());
  ASSERT_TRUE(
      Consume({Accepted(4), Chunk(3, {7}, "the field"), Trailer()}, &assembler_)
          .ok());
  const absl::StatusOr<Field> field = std::move(assembler_).Finish();
  ASSERT_TRUE(field.ok()) << field.status();
  EXPECT_THAT(field->distances, ElementsAre(0, 1.5, 2, 7));
}

TEST_F(BrokenStreamTest, WhatHasNoNameIsReadFromTheStart) {
  ASSERT_TRUE(Consume({Accepted(4), Chunk(0, {0, 1.5})}, &assembler_).ok());
  EXPECT_EQ(assembler_.Resume().field_id, "");
  EXPECT_EQ(assembler_.received(), 0);
  ExpectDataLoss(Consume({Accepted(4), Chunk(2, {2})}, &assembler_),
                 "from vertex 0 were due");
}

TEST_F(BrokenStreamTest, IsNotReadOnWithAnotherField) {
  ASSERT_TRUE(
      Consume({Accepted(4), Chunk(0, {0, 1.5}, "the field")}, &assembler_)
          .ok());
  assembler_.Resume();
  ExpectDataLoss(Consume({Accepted(1)}, &assembler_), "another field");
}

TEST(FieldAssemblerTest, ReportsProgress) {
  ComputeFieldResponse message;
  message.mutable_progress()->set_settled_radius(0.5);
  message.mutable_progress()->set_vertices_reached(4);
  std::vector<SolveProgress> seen;
  const FieldQuery query;
  FieldAssembler assembler(query, nullptr, [&](const SolveProgress& progress) {
    seen.push_back(progress);
  });
  ASSERT_TRUE(Consume({Accepted(10), message}, &assembler).ok());
  ASSERT_EQ(seen.size(), 1);
  EXPECT_EQ(seen[0].settled_radius, 0.5);
  EXPECT_EQ(seen[0].vertices_reached, 4);
  EXPECT_EQ(seen[0].vertex_count, 10);
}

TEST(FieldAssemblerTest, TakesQuantitiesAndTargets) {
  ComputeFieldResponse chunk = Chunk(0, {1, 2});
  chunk.mutable_chunk()->set_nearest_sources(Bytes<uint32_t>({3, kNoSource}));
  chunk.mutable_chunk()->set_gradients(Bytes<double>({1, 0, 0, 0, 0.5, 0}));
  ComputeFieldResponse targets;
  targets.mutable_targets()->set_distances(Bytes<double>({0.25}));
  ComputeFieldResponse trailer = Trailer();
  trailer.mutable_trailer()->set_settled_radius(2);
  const FieldQuery query = {
      .targets = {VertexPoint{0}}, .nearest_sources = true, .gradients = true};
  const absl::StatusOr<Field> field =
      Assembled({Accepted(2), chunk, targets, trailer}, query);
  ASSERT_TRUE(field.ok()) << field.status();
  EXPECT_THAT(field->nearest_sources, ElementsAre(3, kNoSource));
  EXPECT_EQ(field->gradients[1], (std::array<double, 3>{0, 0.5, 0}));
  EXPECT_THAT(field->target_distances, ElementsAre(0.25));
  EXPECT_EQ(field->settled_radius, 2);
  // What was asked for and is missing, and what was not.
  ExpectDataLoss(
      Assembled({Accepted(2), Chunk(0, {1, 2}), targets, trailer}, query)
          .status(),
      "0 of 2 nearest sources");
  ExpectDataLoss(Assembled({Accepted(2), chunk, trailer}, query).status(),
                 "0 of 1 target");
  ExpectDataLoss(Assembled({Accepted(2), chunk, trailer}).status(),
                 "nearest sources");
}

TEST(FieldAssemblerTest, WidensFloats) {
  ComputeFieldResponse chunk;
  chunk.mutable_chunk()->set_distances(Bytes<float>({0.5F, 0.1F}));
  chunk.mutable_chunk()->set_gradients(Bytes<float>({1, 0, 0, 0, 0.1F, 0}));
  const absl::StatusOr<Field> field =
      Assembled({Accepted(2), chunk, Trailer()},
                {.gradients = true, .value_type = ValueType::kFloat32});
  ASSERT_TRUE(field.ok()) << field.status();
  EXPECT_THAT(field->distances, ElementsAre(0.5, double{0.1F}));
  EXPECT_EQ(field->gradients[1], (std::array<double, 3>{0, 0.1F, 0}));
}

TEST(FieldAssemblerTest, HandsOutSettledVertices) {
  std::vector<std::pair<uint32_t, double>> seen;
  const auto on_settled = [&](std::span<const SettledVertex> settled) {
    for (const SettledVertex& vertex : settled) {
      seen.emplace_back(vertex.vertex, vertex.distance);
    }
  };
  const absl::StatusOr<Field> field =
      Assembled({Accepted(4), Settled(0, {2, 0}, {0, 1}),
                 Settled(2, {3}, {1.5}), Trailer()},
                {}, on_settled);
  ASSERT_TRUE(field.ok()) << field.status();
  EXPECT_EQ(field->vertex_count, 4);
  EXPECT_TRUE(field->distances.empty());
  EXPECT_THAT(seen, ElementsAre(std::pair(2U, 0.0), std::pair(0U, 1.0),
                                std::pair(3U, 1.5)));
  for (const ComputeFieldResponse& wrong :
       {Settled(1, {2}, {0}), Settled(0, {2, 3}, {0})}) {
    ExpectDataLoss(Assembled({Accepted(4), wrong}, {}, on_settled).status(),
                   "settled");
  }
  ExpectDataLoss(Assembled({Accepted(4), Settled(0, {2}, {0})}).status(),
                 "settled");
}

TEST(FieldAssemblerTest, RefusesWhatIsNotDue) {
  ComputeFieldResponse half;
  half.mutable_chunk()->set_distances("0123456789");
  ComputeFieldResponse two_thirds = Chunk(0, {1});
  two_thirds.mutable_chunk()->set_gradients(Bytes<double>({1, 0}));
  // A count that is no reason to take memory.
  constexpr uint64_t kHuge = std::numeric_limits<uint64_t>::max();
  const std::vector<std::pair<Messages, std::string>> table = {
      {{Chunk(0, {1})}, "without accepting"},
      {{Accepted(1), Trailer(), Chunk(0, {1})}, "outside"},
      {{Accepted(4), Chunk(0, {1}), Chunk(2, {1})}, "from vertex 2 where"},
      {{Accepted(2), Chunk(0, {1, 2, 3})}, "more than the 2"},
      {{Accepted(2), half}, "part of a number"},
      {{Accepted(2), two_thirds}, "part of a number"},
      {{Accepted(2), Chunk(0, {1}), Trailer()}, "1 of 2"},
      {{Accepted(1), Chunk(0, {1})}, "trailer"},
      {{Accepted(kHuge), Chunk(0, {1}), Trailer()},
       "1 of 18446744073709551615"}};
  for (const auto& [messages, words] : table) {
    ExpectDataLoss(Assembled(messages).status(), words);
  }
}

}  // namespace
}  // namespace geodesic::client
