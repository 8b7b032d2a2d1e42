#include "geodesic/mesh.h"

#include <OpenMesh/Tools/Subdivider/Uniform/LoopT.hh>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <memory>
#include <numeric>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "geodesic/open_mesh.h"
#include "gmock/gmock.h"
#include "gtest/gtest.h"
#include "tests/support/checkpoints.h"
#include "tests/support/meshes/curved_meshes.h"
#include "tests/support/meshes/planar_meshes.h"

namespace geodesic {
namespace {

using ::testing::HasSubstr;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TriangleSoup Square() {
  return {.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
          .triangles = {{0, 1, 2}, {0, 2, 3}}};
}

std::string RefusalOf(TriangleSoup soup) {
  const auto mesh = Mesh::Build(std::move(soup));
  EXPECT_EQ(mesh.status().code(), absl::StatusCode::kInvalidArgument)
      << mesh.status();
  return std::string(mesh.status().message());
}

TEST(MeshTest, KeepsTheCallersNumbersAndBits) {
  TriangleSoup soup = Square();
  soup.positions.push_back({0.1, 1e-300, -0.0});  // isolated
  const auto mesh = Mesh::Build(soup).value();
  ASSERT_EQ(mesh->vertex_count(), 5u);
  for (uint32_t v = 0; v < 5; ++v) {
    EXPECT_EQ(mesh->positions()[v], soup.positions[v]);
  }
  for (uint32_t f = 0; f < 2; ++f) {
    EXPECT_EQ(mesh->triangle(f), soup.triangles[f]);
  }
  EXPECT_TRUE(std::signbit(mesh->positions()[4][2]));
}

// Whoever cancels is heard at every poll, those while faces are laid out among
// them.
TEST(MeshTest, CancelAtAnyPoll) {
  const TriangleSoup grid = test::MakeGrid({.columns = 400, .rows = 400});
  test::RecordingCheckpoint never;
  ASSERT_TRUE(Mesh::Build(grid, never).ok());
  EXPECT_GE(never.polls().size(), 4 + grid.triangles.size() / 50'000);
  for (uint64_t poll = 0; poll < never.polls().size(); ++poll) {
    test::RecordingCheckpoint checkpoint(poll);
    EXPECT_EQ(Mesh::Build(grid, checkpoint).status(),
              test::RecordingCheckpoint::Stopped());
    EXPECT_EQ(checkpoint.polls().size(), poll + 1);
  }
}

TEST(MeshTest, FacesLieInMemoryAsTheyDoInSpace) {
  const TriangleSoup grid = test::MakeGrid({.columns = 16, .rows = 16});
  TriangleSoup shuffled = grid;
  std::ranges::shuffle(shuffled.triangles, std::mt19937(1));
  const auto mesh = *Mesh::Build(grid), other = *Mesh::Build(shuffled);
  uint64_t near = 0;
  for (HalfEdge h = 0; h < mesh->half_edge_count(); ++h) {
    const HalfEdge first = mesh->FirstSide(mesh->FaceOf(h));
    EXPECT_TRUE(first <= h && h < first + 3) << h;
    EXPECT_EQ(mesh->From(h), mesh->triangle(mesh->FaceOf(h))[h - first]) << h;
    // The same place in memory, whatever the number of the face.
    EXPECT_EQ(mesh->TriangleOf(h), other->TriangleOf(h)) << h;
    EXPECT_EQ(shuffled.triangles[other->FaceOf(h)], mesh->TriangleOf(h)) << h;
    const HalfEdge twin = other->Twin(h);
    near += twin == kNoHalfEdge || std::max(h, twin) - std::min(h, twin) < 48;
  }
  EXPECT_GT(near, mesh->half_edge_count() * 3 / 4);
}

// The order in memory of small triangles at these places along the x axis, in a
// box of side 1.
std::vector<uint32_t> OrderOf(const std::vector<double>& places) {
  TriangleSoup soup{{{0, 0, 0}, {1, 1, 1}, {1, 0, 1}}, {}};
  for (const double x : places) {
    const auto first = static_cast<uint32_t>(soup.positions.size());
    for (const double y : {0.0, 1e-9, 2e-9})
      soup.positions.push_back({x, y, 0});
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  const auto mesh = *Mesh::Build(soup);
  std::vector<uint32_t> order;
  for (HalfEdge h = 0; h < mesh->half_edge_count(); h += 3) {
    order.push_back(mesh->FaceOf(h));
  }
  return order;
}

TEST(MeshTest, FacesFollowTheCurveHoweverNearEachOther) {
  // A cell of the grid is 1 / 65536. Backwards, in steps from two cells to a
  // quarter of the box.
  for (const double step : {1.0 / 32768, 1.0 / 4096, 1.0 / 256, 0.25}) {
    std::vector<double> places;
    for (double x = 0.25 * step; x < 1 && places.size() < 100; x += step) {
      places.push_back(x);
    }
    std::ranges::reverse(places);
    std::vector<uint32_t> backwards(places.size());
    std::iota(backwards.rbegin(), backwards.rend(), 0u);
    EXPECT_EQ(OrderOf(places), backwards) << step;
  }
  // In one cell they keep their order. More than the few that sorting leaves in
  // order by chance.
  std::vector<uint32_t> in_order(1000);
  std::iota(in_order.begin(), in_order.end(), 0u);
  EXPECT_EQ(OrderOf(std::vector<double>(1000, 0.3)), in_order);
}

TEST(MeshTest, AMeshWithoutExtentIsNoException) {
  const auto mesh =
      *Mesh::Build({{{2, 2, 2}, {2, 2, 2}, {2, 2, 2}}, {{0, 1, 2}, {2, 1, 0}}});
  EXPECT_EQ(mesh->FaceOf(0), 0u);
  EXPECT_EQ(mesh->FaceOf(3), 1u);
}

TEST(MeshTest, FrameLaysTheFaceIntoThePlane) {
  TriangleSoup soup{.positions = {{1, 1, 5}, {5, 1, 5}, {2, 3, 5}},
                    .triangles = {{0, 1, 2}}};
  const auto mesh = Mesh::Build(soup).value();
  const HalfEdgeFrame& frame = mesh->frame(0);
  const double unit = std::ldexp(1.0, mesh->scale_exponent());
  EXPECT_DOUBLE_EQ(frame.length * unit, 4);
  EXPECT_DOUBLE_EQ(frame.apex_x * unit, 1);
  EXPECT_DOUBLE_EQ(frame.apex_y * unit, 2);
  EXPECT_DOUBLE_EQ(frame.left_x, 1 / std::sqrt(5.0));
  EXPECT_DOUBLE_EQ(frame.left_y, 2 / std::sqrt(5.0));
  EXPECT_DOUBLE_EQ(frame.right_x, -3 / std::sqrt(13.0));
  EXPECT_DOUBLE_EQ(frame.right_y, 2 / std::sqrt(13.0));
}

TEST(MeshTest, ShortSidesKeepTheirDirection) {
  // |BC| is a millionth of |AB|; its direction must not come from a difference
  // of long lengths.
  TriangleSoup soup{.positions = {{0, 0, 0}, {1, 0, 0}, {1 + 3e-7, 4e-7, 0}},
                    .triangles = {{0, 1, 2}}};
  const double x = soup.positions[2][0] - 1, y = soup.positions[2][1];
  const auto mesh = Mesh::Build(soup).value();
  EXPECT_NEAR(mesh->frame(0).right_x, x / std::hypot(x, y), 1e-15);
  EXPECT_NEAR(mesh->frame(0).right_y, y / std::hypot(x, y), 1e-15);
}

TEST(MeshTest, ExtremeScalesStayFinite) {
  for (double scale : {1e-300, 1e-150, 1e150, 1e300}) {
    TriangleSoup soup = Square();
    for (Point& p : soup.positions) {
      for (double& x : p) x *= scale;
    }
    const auto mesh = Mesh::Build(soup).value();
    EXPECT_NEAR(
        std::ldexp(mesh->frame(0).length, mesh->scale_exponent()) / scale, 1,
        1e-15);
  }
}

TEST(MeshTest, PathsMayBendAtReflexCornersAndSaddlesOnly) {
  // A flat grid with a hole of one cell: the hole's four corners.
  const auto grid = Mesh::Build(
      test::MakeGrid({.columns = 5, .rows = 5, .removed = {{2, 2, 3, 3}}}));
  ASSERT_TRUE(grid.ok());
  std::vector<Point> bends;
  for (uint32_t v = 0; v < (*grid)->vertex_count(); ++v) {
    if ((*grid)->IsPseudoSource(v)) bends.push_back((*grid)->positions()[v]);
    EXPECT_FALSE((*grid)->IsSaddle(v)) << v;
  }
  EXPECT_THAT(bends,
              ::testing::UnorderedElementsAre(Point{2, 2, 0}, Point{3, 2, 0},
                                              Point{2, 3, 0}, Point{3, 3, 0}));

  // Eight right angles around vertex 0: a saddle once the fan is closed.
  TriangleSoup fan{.positions = {{0, 0, 0}}};
  for (uint32_t i = 0; i < 8; ++i) {
    const double angle = i * std::acos(0.0);
    fan.positions.push_back(
        {std::cos(angle), std::sin(angle), i % 2 == 0 ? 0.5 : -0.5});
    fan.triangles.push_back({0, i + 1, (i + 1) % 8 + 1});
  }
  auto saddle = Mesh::Build(fan);
  ASSERT_TRUE(saddle.ok()) << saddle.status();
  EXPECT_TRUE((*saddle)->IsSaddle(0));
  EXPECT_TRUE((*saddle)->IsPseudoSource(0));
}

TEST(MeshTest, RefusalsNameTheOffender) {
  TriangleSoup no_faces = Square(), infinite = Square(), absent = Square();
  no_faces.triangles.clear();
  infinite.positions[2][1] = kInfinity;
  absent.triangles[1][2] = 4;
  EXPECT_THAT(RefusalOf(no_faces), HasSubstr("no faces"));
  EXPECT_THAT(RefusalOf(infinite), HasSubstr("vertex 2"));
  EXPECT_THAT(RefusalOf(absent), HasSubstr("face 1 names vertex 4"));
}

// Three faces at one edge let paths bend at its ends; faces that disagree in
// orientation do not. connectivity_test looks at their half-edges.
TEST(MeshTest, PathsMayBendWhereThreeFacesMeet) {
  TriangleSoup soup = Square();
  std::swap(soup.triangles[1][0], soup.triangles[1][1]);
  const auto turned = *Mesh::Build(soup);
  for (uint32_t v = 0; v < 4; ++v) EXPECT_FALSE(turned->IsPseudoSource(v)) << v;
  soup.positions.push_back({0, 0, 1});
  soup.triangles.push_back({2, 0, 4});
  const auto mesh = *Mesh::Build(soup);
  for (const uint32_t v : {0u, 2u}) EXPECT_TRUE(mesh->IsPseudoSource(v)) << v;
}

TEST(MeshTest, AFanOfManyFacesTakesLinearTime) {
  // Quadratic behaviour in the valence would take minutes here.
  constexpr uint32_t kSpokes = 300'000;
  TriangleSoup soup{.positions = {{0, 0, 0}}};
  for (uint32_t i = 0; i < kSpokes; ++i) {
    const double angle = 6.0 * i / kSpokes;
    soup.positions.push_back({std::cos(angle), std::sin(angle), 0});
  }
  // Every other face first, so that no neighbour is at hand.
  for (uint32_t start : {1u, 2u}) {
    for (uint32_t i = start; i < kSpokes; i += 2) {
      soup.triangles.push_back({0, i, i + 1});
    }
  }
  const auto mesh = Mesh::Build(std::move(soup)).value();
  EXPECT_EQ(mesh->Outgoing(0).size(), kSpokes - 1);
}

TEST(MeshTest, EstimatesCoverWhatIsHeld) {
  const TriangleSoup grid = test::MakeGrid({.columns = 40, .rows = 30});
  // All edges of it are irregular.
  TriangleSoup both_sides = grid;
  for (const auto& [a, b, c] : grid.triangles) {
    both_sides.triangles.push_back({b, a, c});
  }
  for (const TriangleSoup& soup : {grid, both_sides}) {
    const auto mesh = Mesh::Build(soup).value();
    const uint64_t vertices = mesh->vertex_count();
    const uint64_t faces = mesh->face_count();
    EXPECT_GE(Mesh::EstimateResidentBytes(vertices, faces),
              mesh->resident_bytes());
    EXPECT_GE(Mesh::EstimateBuildBytes(vertices, faces),
              Mesh::EstimateResidentBytes(vertices, faces));
  }
}

TEST(MeshTest, GoesToOpenMeshAndBack) {
  for (const TriangleSoup& soup :
       {test::MakeGrid(
            test::WithHole({.columns = 6, .rows = 6, .jitter = 0.2})),
        test::Icosphere(2)}) {
    const auto mesh = Mesh::Build(soup).value();
    const OpenMesh::TriMesh kernel = ToOpenMesh(*mesh);
    ASSERT_EQ(kernel.n_vertices(), mesh->vertex_count());
    for (const auto v : kernel.vertices()) {
      EXPECT_EQ(kernel.is_boundary(v), mesh->IsBoundary(v.idx()));
      const auto faces = kernel.vf_range(v);
      EXPECT_EQ(std::distance(faces.begin(), faces.end()),
                static_cast<int64_t>(mesh->Outgoing(v.idx()).size()));
    }
    const TriangleSoup back = FromOpenMesh(kernel);
    EXPECT_EQ(back.positions, soup.positions);
    EXPECT_EQ(back.triangles, soup.triangles);
  }
}

TEST(MeshTest, OpenMeshSubdividesIt) {
  const auto mesh = Mesh::Build(test::Icosphere(1)).value();
  OpenMesh::TriMesh smooth = ToOpenMesh(*mesh);
  OpenMesh::Subdivider::Uniform::LoopT<OpenMesh::TriMesh> loop;
  loop.attach(smooth);
  loop(2);
  loop.detach();
  const auto finer = Mesh::Build(FromOpenMesh(smooth)).value();
  EXPECT_EQ(finer->face_count(), 16 * mesh->face_count());
  // As many as Euler says for a sphere.
  EXPECT_EQ(finer->vertex_count(), finer->face_count() / 2 + 2);
  // Loop's rule averages: the surface stays within the sphere.
  for (const Point& p : finer->positions()) {
    EXPECT_LE(std::hypot(p[0], p[1], p[2]), 1);
    EXPECT_GE(std::hypot(p[0], p[1], p[2]), 0.8);
  }
}

}  // namespace
}  // namespace geodesic
