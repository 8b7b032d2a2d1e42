#include "client/picture/corner_normals.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace geodesic::client {
namespace {

// Two triangles that share the edge 0-1 and make this angle with a plane.
MeshArrays Fold(double degrees) {
  const double angle = degrees * std::numbers::pi / 180;
  return {{{0, 0, 0},
           {0, 1, 0},
           {1, 0, 0},
           {-std::cos(angle), 0, -std::sin(angle)}},
          {{0, 2, 1}, {0, 1, 3}}};
}

TEST(CornerNormalsTest, FlatIsFlat) {
  for (const auto& corners : CornerNormals(Fold(0))) {
    for (const Normal& normal : corners) {
      EXPECT_NEAR(normal[2], 1, 1e-6);
    }
  }
}

TEST(CornerNormalsTest, GentleFoldsAreSmoothed) {
  const auto normals = CornerNormals(Fold(30));
  // Both triangles see the same normal, half way, at their common corner.
  EXPECT_NEAR(normals[0][0][2], std::cos(15 * std::numbers::pi / 180), 1e-6);
  EXPECT_NEAR(normals[1][0][2], normals[0][0][2], 1e-6);
}

TEST(CornerNormalsTest, SharpFoldsStaySharp) {
  const auto normals = CornerNormals(Fold(60));
  EXPECT_NEAR(normals[0][0][2], 1, 1e-6);
  EXPECT_NEAR(normals[1][0][2], 0.5, 1e-6);
}

TEST(CornerNormalsTest, OppositeWindingMakesNoDifference) {
  MeshArrays mesh = Fold(30);
  std::swap(mesh.triangles[1][0], mesh.triangles[1][1]);
  const auto normals = CornerNormals(mesh);
  EXPECT_NEAR(normals[0][0][2], std::cos(15 * std::numbers::pi / 180), 1e-6);
}

TEST(CornerNormalsTest, HugeAndDegenerateAreFinite) {
  const MeshArrays mesh = {
      {{1e300, 0, 0}, {0, 1e300, 0}, {0, 0, 1e300}, {0, 0, 0}},
      {{0, 1, 2}, {3, 3, 3}}};
  const auto normals = CornerNormals(mesh);
  EXPECT_NEAR(normals[0][0][0], 1 / std::numbers::sqrt3, 1e-6);
  EXPECT_EQ(normals[1][0], (Normal{0, 0, 0}));
}

TEST(CornerNormalsTest, VerticesOfManyTrianglesAreAveraged) {
  // A cone of 100,000 triangles: quadratic time would show.
  constexpr int kCount = 100000;
  MeshArrays mesh;
  mesh.positions.push_back({0, 0, 1});
  for (uint32_t i = 0; i < kCount; ++i) {
    const double angle = 2 * std::numbers::pi * i / kCount;
    mesh.positions.push_back({std::cos(angle), std::sin(angle), 0});
    mesh.triangles.push_back({0, 1 + i, 1 + (i + 1) % kCount});
  }
  EXPECT_NEAR(CornerNormals(mesh)[0][0][2], 1, 1e-6);
}

}  // namespace
}  // namespace geodesic::client
