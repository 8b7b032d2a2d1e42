// Surfaces that are no oriented manifolds: faces that disagree, and several
// faces at one edge.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "tests/core/exactness/every_algorithm.h"
#include "tests/support/curved_meshes.h"
#include "tests/support/mesh_edits.h"
#include "tests/support/planar_meshes.h"
#include "tests/support/polyhedra.h"

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
TriangleSoup TwoCubes(const Point& shift, std::vector<uint32_t>* second) {
  TriangleSoup soup = BoxGrid(1, 1, 1, 2, 2, 2);
  const TriangleSoup cube = soup;
  second->clear();
  for (Point p : cube.positions) {
    for (int i = 0; i < 3; ++i) p[i] += shift[i];
    const auto at = std::ranges::find(soup.positions, p);
    second->push_back(static_cast<uint32_t>(at - soup.positions.begin()));
    if (at == soup.positions.end()) soup.positions.push_back(p);
  }
  for (const Triangle& t : cube.triangles) {
    soup.triangles.push_back(
        {(*second)[t[0]], (*second)[t[1]], (*second)[t[2]]});
  }
  return soup;
}

// A way from one cube to the other runs through the vertex; no way within a
// cube gains from the other.
TEST_P(NonManifold, CubesThatShareAVertex) {
  std::vector<uint32_t> second;
  const TriangleSoup soup = TwoCubes({1, 1, 1}, &second);
  const Polyhedron box = Box(1, 1, 1);
  const uint32_t first_count = static_cast<uint32_t>(second.size());
  const auto distance = [&](uint32_t s, uint32_t v) {
    const auto within = [&](Point p, Point q, double shift) {
      for (int i = 0; i < 3; ++i) {
        p[i] -= shift;
        q[i] -= shift;
      }
      return DistanceOnConvex(box, p, q);
    };
    const Point corner = {1, 1, 1};
    const Point &p = soup.positions[s], &q = soup.positions[v];
    const double shift_p = s < first_count ? 0 : 1;
    const double shift_q = v < first_count ? 0 : 1;
    if (shift_p == shift_q) return within(p, q, shift_p);
    return within(p, corner, shift_p) + within(corner, q, shift_q);
  };
  ExpectDistances({"cubes that share a vertex", soup}, SpreadVertices(soup, 5),
                  distance);
}

// Faces of both cubes that lie beside the edge unfold into one plane: four of
// them meet there.
TEST_P(NonManifold, CubesThatShareAnEdge) {
  std::vector<uint32_t> second;
  const TriangleSoup soup = TwoCubes({1, 1, 0}, &second);
  const NamedMesh named{"cubes that share an edge", soup};
  ExpectBruteForce(named, SpreadVertices(soup, 6));
  // From the middle of one face beside the edge to that of one of the other.
  const auto number = [&](const Point& p) {
    return static_cast<uint32_t>(std::ranges::find(soup.positions, p) -
                                 soup.positions.begin());
  };
  const uint32_t from = number({1, 0.5, 0.5}), to = number({1.5, 1, 1});
  ASSERT_LT(from, soup.positions.size());
  ASSERT_LT(to, soup.positions.size());
  const std::vector<double> field =
      SolveOn(*BuildOrFail(named), {{VertexPoint{from}}});
  EXPECT_NEAR(field[to], std::hypot(1, 0.5), 1e-12);
}

GEODESIC_TEST_EVERY_ALGORITHM(NonManifold);

}  // namespace
}  // namespace geodesic::test
