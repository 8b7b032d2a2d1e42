#include "client/src/assemblers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "tests/client/wire_bytes.h"

namespace geodesic::client {
namespace {

using ::testing::ElementsAre;

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
  ASSERT_TRUE(assembler.Consume(Piece(5, 0, 2), &line).ok());
  EXPECT_FALSE(assembler.complete());
  ASSERT_TRUE(assembler.Consume(Piece(5, 2, 3), &line).ok());
  EXPECT_TRUE(assembler.complete());
  ASSERT_EQ(line.points.size(), 5);
  EXPECT_EQ(line.points[4], SurfacePoint(VertexPoint{4}));
  EXPECT_EQ(line.positions[4], (Point{4, 0, 0}));
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

TEST(PolylineAssemblerTest, EmptyLineIsOnePiece) {
  PolylineAssembler assembler;
  Polyline line;
  EXPECT_TRUE(assembler.Consume(Piece(0, 0, 0), &line).ok());
  EXPECT_TRUE(assembler.complete());
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

}  // namespace
}  // namespace geodesic::client
