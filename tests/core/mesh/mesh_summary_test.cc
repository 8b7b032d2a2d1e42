#include "geodesic/mesh_summary.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <numbers>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "gtest/gtest.h"
#include "tests/support/meshes/curved_meshes.h"
#include "tests/support/meshes/planar_meshes.h"
#include "tests/support/meshes/test_meshes.h"

namespace geodesic {
namespace {

MeshSummary SummaryOf(TriangleSoup soup) {
  const auto mesh = Mesh::Build(std::move(soup));
  EXPECT_TRUE(mesh.ok()) << mesh.status();
  return Summarize(**mesh);
}

TEST(MeshSummaryTest, GridWithAHole) {
  const MeshSummary summary = SummaryOf(test::MakeGrid(
      {.columns = 4, .rows = 3, .cell_width = 2, .removed = {{1, 1, 2, 2}}}));
  EXPECT_EQ(summary.vertices, 20u);
  EXPECT_EQ(summary.faces, 22u);
  EXPECT_EQ(summary.edges, 42u);
  EXPECT_EQ(summary.boundary_edges, 18u);
  EXPECT_EQ(summary.boundary_loops, 2u);
  EXPECT_EQ(summary.components, 1u);
  EXPECT_EQ(summary.genus, 0);
  EXPECT_EQ(summary.saddle_vertices, 0u);
  EXPECT_EQ(summary.degenerate_faces, 0u);
  EXPECT_EQ(summary.bounding_box_min, (Point{0, 0, 0}));
  EXPECT_EQ(summary.bounding_box_max, (Point{8, 3, 0}));
  // A right triangle with legs 2 and 1: P H / (2 sqrt(3) S).
  EXPECT_NEAR(summary.anisotropy,
              (3 + std::sqrt(5.0)) / 2 * std::sqrt(5.0) / (2 * std::sqrt(3.0)),
              1e-12);
}

TEST(MeshSummaryTest, PiecesPinchesAndIsolatedVertices) {
  // Two triangles that touch in vertex 0, a third apart, one vertex unused.
  const std::vector<Point> positions = {{0, 0, 0},  {1, 0, 0},  {0, 1, 0},
                                        {-1, 0, 0}, {0, -1, 0}, {5, 0, 0},
                                        {6, 0, 0},  {5, 1, 0},  {9, 9, 9}};
  const MeshSummary summary = SummaryOf(
      {.positions = positions, .triangles = {{0, 1, 2}, {0, 3, 4}, {5, 6, 7}}});
  EXPECT_EQ(summary.components, 2u);
  EXPECT_EQ(summary.isolated_vertices, 1u);
  EXPECT_EQ(summary.boundary_loops, 3u);
  EXPECT_EQ(summary.genus, 0);
}

TEST(MeshSummaryTest, FacesWithoutAreaCount) {
  const MeshSummary summary =
      SummaryOf({.positions = {{0, 0, 0}, {2, 0, 0}, {1, 0, 0}, {1, 1, 0}},
                 .triangles = {{0, 1, 3}, {1, 0, 2}}});
  EXPECT_EQ(summary.degenerate_faces, 1u);
}

// Vertices whose angle exceeds 2 pi by more than the rounding of its sum, but
// by no more than the index of the test meshes calls flat.
uint64_t GentleSaddles(const TriangleSoup& soup) {
  constexpr double kRounding = 1e-13, kFlatInTheIndex = 1e-9;
  std::vector<double> angles(soup.positions.size(), 0);
  const auto along = [&](uint32_t from, uint32_t to) {
    Point way;
    for (int i = 0; i < 3; ++i) {
      way[i] = soup.positions[to][i] - soup.positions[from][i];
    }
    return way;
  };
  for (const Triangle& t : soup.triangles) {
    for (int corner = 0; corner < 3; ++corner) {
      const Point a = along(t[corner], t[(corner + 1) % 3]);
      const Point b = along(t[corner], t[(corner + 2) % 3]);
      const double across =
          std::hypot(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                     a[0] * b[1] - a[1] * b[0]);
      angles[t[corner]] +=
          std::atan2(across, a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
    }
  }
  return std::ranges::count_if(angles, [](double angle) {
    const double excess = angle - 2 * std::numbers::pi;
    return excess > kRounding && excess <= kFlatInTheIndex;
  });
}

// What an independent reader found in meshes that are not part of this project.
TEST(MeshSummaryTest, AgreesWithTheIndexOfTestMeshes) {
  std::ifstream index(test::TestMeshFolder() / "INDEX.tsv");
  if (!index) GTEST_SKIP() << "no test meshes at " << test::TestMeshFolder();
  std::string line;
  std::getline(index, line);  // heads of the columns
  int compared = 0;
  while (std::getline(index, line)) {
    std::istringstream row(line);
    std::string file, genus, g_mean;
    uint64_t vertices, faces, boundary, crowded, components, degenerate,
        isolated, saddles;
    if (!(row >> file >> vertices >> faces >> boundary >> crowded >>
          components >> genus >> degenerate >> isolated >> g_mean >> saddles) ||
        !file.starts_with("real/") || crowded > 0) {
      continue;
    }
    auto soup = test::LoadTestMesh(file);
    ASSERT_TRUE(soup.ok()) << file << ": " << soup.status();
    SCOPED_TRACE(file);
    const uint64_t gentle = GentleSaddles(*soup);
    const MeshSummary summary = SummaryOf(*std::move(soup));
    EXPECT_EQ(summary.vertices, vertices);
    EXPECT_EQ(summary.faces, faces);
    EXPECT_EQ(summary.boundary_edges, boundary);
    EXPECT_EQ(summary.components, components);
    EXPECT_EQ(summary.isolated_vertices, isolated);
    if (genus != "n/a") {
      EXPECT_EQ(summary.genus, std::stoll(genus));
    }
    // The index has that of fans; its polygons are not convex.
    if (file != "real/cgal_double-torus-example.off") {
      EXPECT_NEAR(summary.anisotropy, std::stod(g_mean),
                  1e-3 * summary.anisotropy);
    }
    // Vertices within rounding of flat fall on either side.
    EXPECT_NEAR(static_cast<double>(summary.saddle_vertices),
                static_cast<double>(saddles + gentle),
                2 + 0.01 * static_cast<double>(saddles));
    ++compared;
  }
  EXPECT_GT(compared, 40);
}

TEST(MeshSummaryTest, OrientationDoesNotMatter) {
  TriangleSoup soup = test::Torus({.around = 12, .across = 8});
  const MeshSummary oriented = SummaryOf(soup);
  EXPECT_EQ(oriented.genus, 1);
  for (size_t f = 0; f < soup.triangles.size(); f += 3) {
    std::swap(soup.triangles[f][0], soup.triangles[f][1]);
  }
  const MeshSummary turned = SummaryOf(soup);
  EXPECT_TRUE(turned.is_orientable);
  EXPECT_EQ(turned.genus, 1);
  EXPECT_EQ(turned.edges, oriented.edges);
  EXPECT_EQ(turned.non_manifold_edges, 0u);
  EXPECT_EQ(turned.non_manifold_vertices, 0u);
  EXPECT_GT(turned.inconsistent_edges, 0u);
  EXPECT_EQ(turned.saddle_vertices, oriented.saddle_vertices);
}

TEST(MeshSummaryTest, AMoebiusStripIsNotOrientable) {
  // An odd number of triangles in a row, its ends joined.
  TriangleSoup soup;
  constexpr uint32_t kCount = 9;
  for (uint32_t i = 0; i < kCount; ++i) {
    const double angle = 2 * std::numbers::pi * i / kCount;
    soup.positions.push_back({std::cos(angle), std::sin(angle), 0});
    soup.triangles.push_back({i, (i + 1) % kCount, (i + 2) % kCount});
    if (i % 2 == 1) std::swap(soup.triangles[i][0], soup.triangles[i][1]);
  }
  const MeshSummary summary = SummaryOf(soup);
  EXPECT_FALSE(summary.is_orientable);
  EXPECT_EQ(summary.genus, std::nullopt);
  EXPECT_EQ(summary.boundary_loops, 1u);
  EXPECT_EQ(summary.inconsistent_edges, 1u);
  EXPECT_EQ(summary.non_manifold_vertices, 0u);
}

TEST(MeshSummaryTest, CountsNonManifoldEdgesAndVertices) {
  // Three triangles on one edge.
  const MeshSummary book = SummaryOf(
      {.positions = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {-1, 0, 0}, {0, 0, 1}},
       .triangles = {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}});
  EXPECT_EQ(book.edges, 7u);
  EXPECT_EQ(book.boundary_edges, 6u);
  EXPECT_EQ(book.non_manifold_edges, 1u);
  EXPECT_EQ(book.non_manifold_vertices, 2u);
  EXPECT_EQ(book.components, 1u);
  EXPECT_EQ(book.genus, std::nullopt);
}

}  // namespace
}  // namespace geodesic
