// Decimated meshes keep vertices, topology and boundaries.

#include "geodesic/decimate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <set>
#include <utility>
#include <vector>

#include "geodesic/mesh_summary.h"
#include "tests/support/checkpoints.h"
#include "tests/support/curved_meshes.h"
#include "tests/support/mesh_edits.h"
#include "tests/support/planar_meshes.h"
#include "tests/support/polyhedra.h"
#include "tests/support/vec.h"

namespace geodesic {
namespace {

using test::Icosphere;
using test::RecordingCheckpoint;
using test::Terrain;
using test::Torus;

std::shared_ptr<const Mesh> Build(const TriangleSoup& soup) {
  return Mesh::Build(soup).value();
}

std::vector<Triangle> Decimated(const TriangleSoup& soup, uint64_t max_faces) {
  NoCheckpoint checkpoint;
  return Decimate(*Build(soup), max_faces, checkpoint).value();
}

// The mesh of what is left of `soup`.
std::shared_ptr<const Mesh> Coarse(const TriangleSoup& soup,
                                   uint64_t max_faces) {
  return Build({soup.positions, Decimated(soup, max_faces)});
}

TriangleSoup Together(TriangleSoup a, const TriangleSoup& b, double shift) {
  const auto first = static_cast<uint32_t>(a.positions.size());
  for (Point point : b.positions) {
    point[0] += shift;
    a.positions.push_back(point);
  }
  for (Triangle triangle : b.triangles) {
    for (uint32_t& corner : triangle) corner += first;
    a.triangles.push_back(triangle);
  }
  return a;
}

// Two spheres whose vertices of number 0 are one.
TriangleSoup TouchingSpheres() {
  const TriangleSoup one = Icosphere(3);
  TriangleSoup two = Together(one, one, 2);
  const auto twin = static_cast<uint32_t>(one.positions.size());
  two.positions[twin] = two.positions[0];
  for (Triangle& triangle : two.triangles) {
    std::ranges::replace(triangle, twin, 0u);
  }
  return two;
}

// A closed box that is hardly thicker than nothing.
TriangleSoup ThinSphere() {
  TriangleSoup soup = Icosphere(4);
  for (Point& point : soup.positions) point[2] *= 1e-9;
  return soup;
}

std::map<std::pair<uint32_t, uint32_t>, int> FacesOfEdges(
    const std::vector<Triangle>& triangles) {
  std::map<std::pair<uint32_t, uint32_t>, int> edges;
  for (const Triangle& t : triangles) {
    for (int i = 0; i < 3; ++i) {
      ++edges[std::minmax(t[i], t[(i + 1) % 3])];
    }
  }
  return edges;
}

void ExpectSameTopology(const TriangleSoup& soup, uint64_t max_faces) {
  const MeshSummary before = Summarize(*Build(soup));
  const MeshSummary after = Summarize(*Coarse(soup, max_faces));
  EXPECT_LT(after.faces, before.faces);
  EXPECT_EQ(after.components, before.components);
  EXPECT_EQ(after.boundary_loops, before.boundary_loops);
  EXPECT_EQ(after.genus, before.genus);
  EXPECT_EQ(after.non_manifold_edges, before.non_manifold_edges);
  EXPECT_EQ(after.inconsistent_edges, before.inconsistent_edges);
  EXPECT_EQ(after.degenerate_faces, 0);
}

TEST(DecimateTest, CountIsWhatWasAskedFor) {
  const TriangleSoup sphere = Icosphere(5);
  for (const uint64_t max_faces : {20'000, 5'000, 500, 40}) {
    const size_t count = Decimated(sphere, max_faces).size();
    EXPECT_LE(count, max_faces);
    EXPECT_GE(count + 2, max_faces) << "the last collapse took two";
  }
}

TEST(DecimateTest, EnoughFacesAreLeftAsTheyAre) {
  const TriangleSoup sphere = Icosphere(2);
  EXPECT_EQ(Decimated(sphere, 320), sphere.triangles);
  EXPECT_EQ(Decimated(sphere, UINT64_MAX), sphere.triangles);
}

TEST(DecimateTest, TopologyStays) {
  ExpectSameTopology(Icosphere(4), 1);
  ExpectSameTopology(Torus({.around = 60, .across = 30}), 1);
  ExpectSameTopology(Terrain(40, 40, 2, 1), 1);
  ExpectSameTopology(Together(Icosphere(4), Terrain(20, 20, 1, 2), 5), 1);
  ExpectSameTopology(ThinSphere(), 1);
}

TEST(DecimateTest, ShapeStays) {
  const auto coarse = Coarse(Icosphere(5), 1000);
  for (HalfEdge h = 0; h < coarse->half_edge_count(); h += 3) {
    const Triangle& t = coarse->TriangleOf(h);
    Point middle = {};
    for (const uint32_t v : t) {
      for (int i = 0; i < 3; ++i) middle[i] += coarse->positions()[v][i] / 3;
    }
    // An equilateral face would be 0.0048 below the sphere.
    EXPECT_GT(std::hypot(middle[0], middle[1], middle[2]), 0.97);
  }
}

TEST(DecimateTest, OrientationStays) {
  const TriangleSoup sphere = Icosphere(5);
  for (const Triangle& t : Decimated(sphere, 200)) {
    const Point &a = sphere.positions[t[0]], &b = sphere.positions[t[1]],
                &c = sphere.positions[t[2]];
    const double volume = a[0] * (b[1] * c[2] - b[2] * c[1]) +
                          a[1] * (b[2] * c[0] - b[0] * c[2]) +
                          a[2] * (b[0] * c[1] - b[1] * c[0]);
    EXPECT_GT(volume, 0);
  }
}

// Rough inside, so that quadrics alone would prefer the border.
TEST(DecimateTest, BorderOfATerrainStays) {
  constexpr uint32_t kCells = 60;
  TriangleSoup soup = Terrain(kCells, kCells, 2, 7);
  for (Point& p : soup.positions) {
    const bool is_border =
        p[0] == 0 || p[1] == 0 || p[0] == kCells || p[1] == kCells;
    if (is_border) p[2] = 0;
  }
  const auto mesh = Coarse(soup, soup.triangles.size() / 4);
  EXPECT_LE(mesh->face_count(), soup.triangles.size() / 4);
  double area = 0;
  for (uint32_t f = 0; f < mesh->face_count(); ++f) {
    const Triangle& t = mesh->triangle(f);
    const Point &a = soup.positions[t[0]], &b = soup.positions[t[1]],
                &c = soup.positions[t[2]];
    area += ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2;
  }
  EXPECT_NEAR(area, double{kCells} * kCells, 1e-6) << "seen from above";
  EXPECT_LT(Summarize(*mesh).boundary_edges, 4 * kCells) << "it is straight";
}

TEST(DecimateTest, CurvedBorderMovesByLessThanPromised) {
  // A disk: its border has no straight piece.
  constexpr uint32_t kAround = 2000;
  TriangleSoup soup;
  for (const double r : {1.0, 0.95, 0.9}) {
    for (uint32_t i = 0; i < kAround; ++i) {
      const double angle = 2 * M_PI * i / kAround;
      soup.positions.push_back({r * std::cos(angle), r * std::sin(angle), 0});
    }
  }
  for (uint32_t ring = 0; ring < 2; ++ring) {
    for (uint32_t i = 0; i < kAround; ++i) {
      const uint32_t a = ring * kAround + i;
      const uint32_t b = ring * kAround + (i + 1) % kAround;
      soup.triangles.push_back({a, b, a + kAround});
      soup.triangles.push_back({b, b + kAround, a + kAround});
    }
  }
  const std::vector<Triangle> coarse = Decimated(soup, 1);
  EXPECT_LT(coarse.size(), soup.triangles.size() / 4);
  for (const auto& [edge, faces] : FacesOfEdges(coarse)) {
    if (faces != 1 || edge.second >= kAround) continue;
    const Point &a = soup.positions[edge.first],
                &b = soup.positions[edge.second];
    const double sagitta =
        1 - std::hypot(a[0] + b[0], a[1] + b[1], a[2] + b[2]) / 2;
    EXPECT_LT(sagitta, 1e-3 * std::sqrt(8.0));
  }
}

TEST(DecimateTest, IrregularEdgesStay) {
  // Three terrains along one line.
  const TriangleSoup page = Terrain(12, 12, 0.5, 3);
  TriangleSoup book = Together(page, page, 0);
  book = Together(book, page, 0);
  const auto per_page = static_cast<uint32_t>(page.positions.size());
  for (uint32_t v = 0; v < 3 * per_page; ++v) {
    const double angle = 2 * M_PI * (v / per_page) / 3;
    const Point p = book.positions[v];
    if (p[0] == 0) continue;
    book.positions[v] = {p[0] * std::cos(angle) - p[2] * std::sin(angle), p[1],
                         p[0] * std::sin(angle) + p[2] * std::cos(angle)};
  }
  for (Triangle& triangle : book.triangles) {
    for (uint32_t& v : triangle) {
      if (page.positions[v % per_page][0] == 0) v %= per_page;
    }
  }
  ExpectSameTopology(book, 1);
  const std::vector<Triangle> coarse = Decimated(book, 1);
  int spine = 0;
  for (const auto& [edge, faces] : FacesOfEdges(coarse)) spine += faces == 3;
  EXPECT_EQ(spine, 12);
}

TEST(DecimateTest, TouchingSurfacesStayApart) {
  ExpectSameTopology(TouchingSpheres(), 1);
}

TEST(DecimateTest, FacesThatDisagreeStay) {
  TriangleSoup soup = Icosphere(4);
  for (size_t f = 0; f < soup.triangles.size(); f += 97) {
    std::swap(soup.triangles[f][1], soup.triangles[f][2]);
  }
  ExpectSameTopology(soup, 1);
}

TEST(DecimateTest, FacesWithoutAreaDoNoHarm) {
  TriangleSoup soup = Terrain(30, 30, 1, 5);
  for (size_t v = 0; v < soup.positions.size(); v += 3) {
    if (v + 1 < soup.positions.size()) {
      soup.positions[v + 1] = soup.positions[v];
    }
  }
  const MeshSummary before = Summarize(*Build(soup));
  ASSERT_GT(before.degenerate_faces, 0);
  const MeshSummary after = Summarize(*Coarse(soup, 100));
  EXPECT_LT(after.faces, before.faces / 2);
  EXPECT_EQ(after.components, 1);
  TriangleSoup point = Icosphere(3);
  for (Point& p : point.positions) p = {1, 2, 3};
  EXPECT_GE(Decimated(point, 1).size(), 4);
}

TEST(DecimateTest, VerticesOfManyFacesStay) {
  const TriangleSoup sphere = test::UvSphere(3000, 20);
  const std::vector<Triangle> coarse = Decimated(sphere, 20'000);
  const auto poles = std::ranges::count_if(
      coarse, [](const Triangle& t) { return std::ranges::count(t, 0u) == 1; });
  EXPECT_LT(coarse.size(), sphere.triangles.size() / 2);
  EXPECT_GT(poles, 3);
}

TEST(DecimateTest, SizesAndPlacesOfFilesPlayNoPart) {
  const std::vector<Triangle> expected = Decimated(Icosphere(4), 600);
  for (const double scale : {0x1p-1000, 0x1p600}) {
    TriangleSoup soup = Icosphere(4);
    for (Point& p : soup.positions) {
      for (double& x : p) x *= scale;
    }
    EXPECT_EQ(Decimated(soup, 600), expected);
  }
  TriangleSoup away = Icosphere(4);
  for (Point& p : away.positions) p[0] += 0x1p20;
  const auto coarse = Coarse(away, 600);
  EXPECT_EQ(Summarize(*coarse).genus, 0);
  EXPECT_LE(coarse->face_count(), 600);
}

TEST(DecimateTest, TheSameEveryTime) {
  const TriangleSoup soup = Terrain(80, 80, 3, 11);
  EXPECT_EQ(Decimated(soup, 3000), Decimated(soup, 3000));
}

TEST(DecimateTest, StopsAtEveryPoll) {
  const auto mesh = Build(Icosphere(6));
  RecordingCheckpoint all;
  ASSERT_TRUE(Decimate(*mesh, 100, all).ok());
  ASSERT_GT(all.polls().size(), 100);
  for (const size_t at : {size_t{0}, all.polls().size() / 10,
                          all.polls().size() / 2, all.polls().size() - 1}) {
    RecordingCheckpoint stop(at);
    EXPECT_EQ(Decimate(*mesh, 100, stop).status(),
              RecordingCheckpoint::Stopped());
    EXPECT_EQ(stop.polls().size(), at + 1) << "it goes no further";
  }
}

TEST(DecimateTest, NoFacesIsNoLimit) {
  NoCheckpoint checkpoint;
  const absl::Status status =
      Decimate(*Build(Icosphere(1)), 0, checkpoint).status();
  EXPECT_TRUE(absl::IsInvalidArgument(status));
  EXPECT_NE(status.message().find("max_faces"), std::string::npos);
}

}  // namespace
}  // namespace geodesic
