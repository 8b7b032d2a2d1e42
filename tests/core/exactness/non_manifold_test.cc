// Surfaces that are no oriented manifolds: faces that disagree, and several
// faces at one edge.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "tests/core/exactness/every_algorithm.h"
#include "tests/support/meshes/curved_meshes.h"
#include "tests/support/meshes/mesh_edits.h"
#include "tests/support/meshes/planar_meshes.h"
#include "tests/support/meshes/polyhedra.h"
#include "tests/support/vec.h"

namespace geodesic::test {
namespace {

class NonManifold : public EveryAlgorithm {};

TEST_P(NonManifold, OrientationDoesNotMatter) {
  const std::vector<NamedMesh> meshes = {
      {"torus", Torus({.around = 14, .across = 9, .noise = 0.1})},
      {"terrain", Terrain(12, 10, 1.5, 3)},
      {"grid", MakeGrid({.columns = 9, .rows = 8})},
      {"box", BoxGrid(1, 2, 1.5, 3, 4, 3)}};
  for (const NamedMesh& named : meshes) {
    NamedMesh turned{named.name + " with faces turned",
                     TurnFaces(named.soup, 7)};
    const auto mesh = BuildOrFail(named), other = BuildOrFail(turned);
    for (const uint32_t s : SpreadVertices(named.soup, 4)) {
      ExpectField(turned.name, *other, {{VertexPoint{s}}},
                  SolveOn(*mesh, {{VertexPoint{s}}}));
    }
  }
}

// Two pages unfold into one plane.
TEST_P(NonManifold, PagesOfABookUnfoldIntoThePlane) {
  const TriangleSoup page =
      MakeGrid({.columns = 6, .rows = 6, .diagonals = Diagonals::kRandom});
  constexpr uint32_t kOfFirstPage = 7 * 7, kOfOtherPages = 6 * 7;
  for (const uint32_t pages : {3u, 5u}) {
    const TriangleSoup book = Book(page, pages);
    const auto page_of = [](uint32_t v) {
      return v < kOfFirstPage ? 0 : 1 + (v - kOfFirstPage) / kOfOtherPages;
    };
    const auto distance = [&](uint32_t s, uint32_t v) {
      const Point &p = book.positions[s], &q = book.positions[v];
      const double x = std::hypot(p[0], p[2]), y = std::hypot(q[0], q[2]);
      return std::hypot(page_of(s) == page_of(v) ? x - y : x + y, p[1] - q[1]);
    };
    ExpectDistances({"book", book}, SpreadVertices(book, 6), distance);
    ExpectDistances({"book with faces turned", TurnFaces(book, 3)},
                    SpreadVertices(book, 3), distance);
  }
}

// Two unit cubes, the second moved by `shift`, with the vertices at one place
// made one.
TriangleSoup TwoCubes(const Point& shift) {
  TriangleSoup soup = BoxGrid(1, 1, 1, 2, 2, 2);
  const TriangleSoup cube = soup;
  std::vector<uint32_t> second;
  for (Point p : cube.positions) {
    for (int i = 0; i < 3; ++i) p[i] += shift[i];
    const auto at = std::ranges::find(soup.positions, p);
    second.push_back(static_cast<uint32_t>(at - soup.positions.begin()));
    if (at == soup.positions.end()) soup.positions.push_back(p);
  }
  for (const auto& [a, b, c] : cube.triangles) {
    soup.triangles.push_back({second[a], second[b], second[c]});
  }
  return soup;
}

TEST_P(NonManifold, CubesThatTouch) {
  struct Case {
    Point shift, from, to;
    double distance;
  };
  for (const auto& [shift, from, to, distance] :
       {// A way from one cube to the other runs through the vertex that they
        // share; no way within a cube gains from the other.
        Case{{1, 1, 1}, {0, 0, 0}, {2, 2, 2}, 2 * std::sqrt(5)},
        // Faces of both cubes that lie beside the edge that they share unfold
        // into one plane: four of them meet there. From the middle of one to
        // that of one of the other cube.
        Case{{1, 1, 0}, {1, 0.5, 0.5}, {1.5, 1, 1}, std::hypot(1, 0.5)}}) {
    const NamedMesh named{"cubes that touch", TwoCubes(shift)};
    ExpectBruteForce(named, SpreadVertices(named.soup, 6));
    const std::vector<Point>& positions = named.soup.positions;
    const auto s = std::ranges::find(positions, from) - positions.begin();
    const auto v = std::ranges::find(positions, to) - positions.begin();
    const std::vector<double> field =
        SolveOn(*BuildOrFail(named), {{VertexPoint{static_cast<uint32_t>(s)}}});
    EXPECT_NEAR(field.at(v), distance, 1e-12);
  }
}

// Paths through either sheet meet again where it ends, at times along one ray.
TEST_P(NonManifold, SheetsThatMeetAgain) {
  for (uint32_t seed = 1; seed <= 12; ++seed) {
    const TriangleSoup below =
        seed % 2 == 0 ? Terrain(5, 4, 1, seed)
                      : MakeGrid({.columns = 4, .rows = 4, .seed = seed});
    const NamedMesh named{
        "a layer on faces, seed " + std::to_string(seed),
        AddLayer(below, 6 + seed, seed % 3 == 0 ? 0 : 0.4, seed)};
    ExpectBruteForce(named, SpreadVertices(named.soup, 3));
  }
}

// Through faces that are given again no path is shorter, and they take few
// windows.
TEST_P(NonManifold, BacksOfFacesLeadNowhereElse) {
  const std::vector<NamedMesh> meshes = {
      {"torus", Torus({.around = 14, .across = 9, .noise = 0.1})},
      {"saddles", HyperbolicGrid(16, 16, 0.2)},
      {"grid", MakeGrid({.columns = 16, .rows = 16})}};
  for (const NamedMesh& named : meshes) {
    const NamedMesh backed{named.name + " with backs",
                           AddBackFaces(AddBackFaces(named.soup))};
    const auto mesh = BuildOrFail(named), both = BuildOrFail(backed);
    for (const uint32_t s : SpreadVertices(named.soup, 4)) {
      const Query query = Ask({.sources = {{VertexPoint{s}}}});
      const DistanceField field = SolveOrFail(*mesh, query);
      const DistanceField same = SolveOrFail(*both, query);
      EXPECT_TRUE(FieldsAgree({backed.name, query.sources, GetParam().name},
                              field.distances, same.distances));
      EXPECT_LE(same.statistics.windows_propagated,
                3 * field.statistics.windows_propagated);
    }
  }
}

// The source lies all but on an edge of three faces, in a needle that is there
// twice. A target in its copy has windows cross that, and come to the edge a
// little farther than the straight way.
TEST_P(NonManifold, CopiesDoNotHideTheStraightWay) {
  const Point at_b = {1, 0, 0}, at_c = {1.1, 2.7e-4, 0}, v = {-0.3, -0.7, 0};
  const auto mesh = BuildOrFail(
      {"a needle and its copy",
       {{{0, 0, 0}, at_b, at_c, v}, {{3, 1, 0}, {1, 2, 0}, {1, 0, 2}}}});
  for (const double b : {3e-7, 1e-9, 1e-4}) {
    for (const double c : {3e-7, 1e-8, 1e-10}) {
      const DistanceField field = SolveOrFail(
          *mesh, Ask({.sources = {{FacePoint{1, {b, c, 1 - b - c}}}},
                      .targets = {FacePoint{2, {0.3, 0.3, 0.4}}}}));
      const Vec3 source = Real{b} * ToVec3(at_b) + Real{c} * ToVec3(at_c);
      EXPECT_NEAR(field.distances[3],
                  static_cast<double>(Norm(source - ToVec3(v))), 1e-15)
          << b << " " << c;
    }
  }
}

// A path crosses needles along their edges, comes to a corner of them that
// hides what lies behind, and goes on to the page at the last one's edge.
TEST_P(NonManifold, NeedlesLeadToPages) {
  constexpr double kHeight = 1e-8;
  const std::vector<Point> positions = {
      {0, 0, 0}, {1, 0, 0},   {0.8, kHeight, 0}, {0.4, 0.4 * kHeight, 0},
      {2, 0, 0}, {0.8, 0, 1}, {0.5, 0, -1}};
  const TriangleSoup soup = {
      positions, {{1, 0, 2}, {3, 1, 2}, {1, 3, 4}, {0, 1, 5}, {1, 0, 6}}};
  const auto mesh = BuildOrFail({"needles between pages", soup});
  const SurfacePoint source = FacePoint{2, {0.03, 0.95, 0.02}};  // at x = 0.45
  const DistanceField field = SolveOrFail(*mesh, Ask({.sources = {{source}}}));
  EXPECT_NEAR(field.distances[5], 0.35 + kHeight + 1, 1e-14);
}

GEODESIC_TEST_EVERY_ALGORITHM(NonManifold);

}  // namespace
}  // namespace geodesic::test
