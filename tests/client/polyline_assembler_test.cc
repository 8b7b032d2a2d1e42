#include "client/src/polyline_assembler.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace geodesic::client {
namespace {

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

}  // namespace
}  // namespace geodesic::client
