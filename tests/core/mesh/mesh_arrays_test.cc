#include "geodesic/mesh_arrays.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "geodesic/solve.h"

namespace geodesic {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

// Column after column, as Eigen's matrices are unless they are told otherwise.
template <typename Number>
struct Matrix {
  int row_count, column_count;
  std::vector<Number> values;

  int rows() const { return row_count; }
  int cols() const { return column_count; }
  Number operator()(int row, int column) const {
    return values[column * row_count + row];
  }
};

// A triangle with legs 3 and 4.
const Matrix<double> kVertices = {3, 3, {0, 3, 0, 0, 0, 4, 0, 0, 0}};
const Matrix<int> kFaces = {1, 3, {0, 1, 2}};

template <typename Vertices, typename Faces>
std::string RefusalOf(const Vertices& vertices, const Faces& faces) {
  const absl::Status status = BuildMesh(vertices, faces).status();
  EXPECT_EQ(status.code(), absl::StatusCode::kInvalidArgument) << status;
  return std::string(status.message());
}

TEST(MeshArraysTest, MatricesAreReadByRowAndColumn) {
  const auto mesh = BuildMesh(kVertices, kFaces).value();
  EXPECT_THAT(mesh->positions(),
              ElementsAre(Point{0, 0, 0}, Point{3, 0, 0}, Point{0, 4, 0}));
  EXPECT_EQ(mesh->triangle(0), (Triangle{0, 1, 2}));
  const DistanceField field =
      Solve(*mesh, {.sources = {{VertexPoint{1}}}}).value();
  EXPECT_THAT(field.distances, ElementsAre(3, 0, 5));
}

TEST(MeshArraysTest, FlatArraysOfAnyNumbersGiveTheSameMesh) {
  const std::vector<float> coordinates = {0, 0, 0, 3, 0, 0, 0, 4, 0};
  const std::array<int64_t, 3> corners = {0, 1, 2};
  const auto mesh = BuildMesh(std::span(coordinates), corners).value();
  const auto same = BuildMesh(kVertices, kFaces).value();
  EXPECT_THAT(mesh->positions(),
              ::testing::ElementsAreArray(same->positions()));
  EXPECT_EQ(mesh->triangle(0), same->triangle(0));
}

TEST(MeshArraysTest, OtherShapesAreRefused) {
  EXPECT_THAT(RefusalOf(Matrix<double>{2, 2, {0, 0, 1, 1}}, kFaces),
              HasSubstr("the vertices have 2 columns"));
  EXPECT_THAT(RefusalOf(kVertices, Matrix<int>{1, 4, {0, 1, 2, 3}}),
              HasSubstr("the faces have 4 columns"));
  EXPECT_THAT(RefusalOf(std::vector<double>(10), std::vector<int>{0, 1, 2}),
              HasSubstr("the vertices are 10 numbers"));
  EXPECT_THAT(RefusalOf(std::vector<double>(9), std::vector<int>{0, 1}),
              HasSubstr("the faces are 2 numbers"));
}

TEST(MeshArraysTest, NumbersThatNoVertexHasAreNamed) {
  EXPECT_THAT(RefusalOf(kVertices, Matrix<int>{1, 3, {0, 1, -1}}),
              HasSubstr("face 0: corner 2 is -1"));
  EXPECT_THAT(
      RefusalOf(kVertices, Matrix<int64_t>{1, 3, {0, int64_t{1} << 32, 2}}),
      HasSubstr("face 0: corner 1 is 4294967296"));
  EXPECT_THAT(RefusalOf(kVertices, Matrix<int>{1, 3, {0, 1, 3}}),
              HasSubstr("3"));
}

}  // namespace
}  // namespace geodesic
