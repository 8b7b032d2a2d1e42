// Turned edges keep the surface and make the triangles that Delaunay's law
// asks for.

#include "approximate/intrinsic_triangulation.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "tests/support/checkpoints.h"
#include "tests/support/field_check.h"
#include "tests/support/meshes/curved_meshes.h"
#include "tests/support/meshes/mesh_edits.h"
#include "tests/support/meshes/planar_meshes.h"
#include "tests/support/vec.h"

namespace geodesic::test {
namespace {

double AreaOf(const IntrinsicTriangulation& triangulation) {
  double area = 0;
  for (uint32_t f = 0; f < triangulation.face_count(); ++f) {
    const auto face = triangulation.FaceAt(f);
    area += face.length * face.y / 2;
  }
  return area;
}

// By how much `p` lies inside the circle through three points that run
// counterclockwise: positive inside.
Real InCircle(const std::array<Point, 3>& circle, const Point& p) {
  Real m[3][3];
  for (int i = 0; i < 3; ++i) {
    const Real dx = circle[i][0] - p[0], dy = circle[i][1] - p[1];
    m[i][0] = dx;
    m[i][1] = dy;
    m[i][2] = dx * dx + dy * dy;
  }
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
         m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

// On a convex domain of the plane intrinsic Delaunay edges are those of
// Delaunay: no vertex lies in any triangle's circle.
TEST(IntrinsicTriangulation, CirclesAreEmptyInThePlane) {
  for (const TriangleSoup& soup :
       {SplitFaces(MakeGrid({.columns = 9,
       .rows = 7,
       .diagonals = Diagonals::kRandom,
       .jitter = 0.2}),
                   60, 5),
        FlipEdges(MakeGrid({.columns = 12, .rows = 3, .cell_height = 0.2}), 9,
                  2)}) {
    const auto mesh = BuildOrFail({"plane", soup});
    IntrinsicTriangulation triangulation(*mesh);
    const double before = AreaOf(triangulation);
    NoCheckpoint checkpoint;
    ASSERT_TRUE(triangulation.FlipToDelaunay(*mesh, checkpoint).ok());
    EXPECT_GT(triangulation.flips(), 0u);
    EXPECT_EQ(triangulation.face_count(), mesh->face_count());
    EXPECT_NEAR(AreaOf(triangulation), before, 1e-12 * before);
    for (uint32_t f = 0; f < triangulation.face_count(); ++f) {
      const auto face = triangulation.FaceAt(f);
      std::array<Point, 3> circle;
      for (int i = 0; i < 3; ++i) circle[i] = soup.positions[face.corners[i]];
      for (const Point& p : soup.positions) {
        ASSERT_LE(InCircle(circle, p), 1e-7) << "face " << f;
      }
    }
  }
}

TEST(IntrinsicTriangulation, TurningKeepsTheArea) {
  for (const TriangleSoup& soup :
       {Terrain(20, 20, 4, 3), InsertNeedles(Icosphere(2), 60, 1),
        TurnFaces(Torus({.noise = 0.3, .seed = 2}), 3),
        Book(SplitFaces(MakeGrid({.columns = 6, .rows = 5}), 30, 4), 3)}) {
    const auto mesh = BuildOrFail({"surface", soup});
    IntrinsicTriangulation triangulation(*mesh);
    EXPECT_EQ(triangulation.sheets(), mesh->HasIrregularEdges() ? 2u : 1u);
    const double before = AreaOf(triangulation);
    NoCheckpoint checkpoint;
    ASSERT_TRUE(triangulation.FlipToDelaunay(*mesh, checkpoint).ok());
    EXPECT_GT(triangulation.flips(), 0u);
    EXPECT_NEAR(AreaOf(triangulation), before, 1e-9 * before);
  }
}

TEST(IntrinsicTriangulation, FacesWithoutAreaGetSome) {
  for (const TriangleSoup& soup :
       {InsertZeroAreaFaces(Icosphere(1), 20, 2),
        DoubleVertices(Icosphere(1), 8, 3),
        TriangleSoup{{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, {{0, 1, 2}}}}) {
    const auto mesh = BuildOrFail({"bad faces", soup});
    const IntrinsicTriangulation triangulation(*mesh);
    for (uint32_t f = 0; f < triangulation.face_count(); ++f) {
      EXPECT_GT(triangulation.FaceAt(f).length, 0);
      EXPECT_GT(triangulation.FaceAt(f).y, 0);
    }
  }
}

}  // namespace
}  // namespace geodesic::test
