// Surfaces that are no oriented manifolds: faces that disagree, and several
// faces at one edge.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "tests/core/exactness/every_algorithm.h"
#include "tests/support/curved_meshes.h"
#include "tests/support/mesh_edits.h"
#include "tests/support/oracles/brute_force.h"
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
    ASSERT_NE(mesh, nullptr);
    ASSERT_NE(other, nullptr);
    for (const uint32_t s : SpreadVertices(named.soup, 4)) {
      ExpectField(turned.name, *other, {{VertexPoint{s}}},
                  SolveOn(*mesh, {{VertexPoint{s}}}));
    }
  }
}

// Square pages on one spine.
struct Book {
  static constexpr uint32_t kCells = 6;

  explicit Book(uint32_t pages) {
    for (uint32_t page = 0; page < pages; ++page) {
      const TriangleSoup grid = MakeGrid({.columns = kCells,
                                          .rows = kCells,
                                          .diagonals = Diagonals::kRandom,
                                          .seed = page + 1});
      const double angle = 2 * std::acos(-1.0) * page / pages;
      std::vector<uint32_t> number;
      for (const Point& p : grid.positions) {
        // The vertices of the spine, x = 0, are those of the first page.
        if (page > 0 && p[0] == 0) {
          for (uint32_t v = 0; v < flat.size(); ++v) {
            if (flat[v].x == 0 && flat[v].y == p[1]) number.push_back(v);
          }
          continue;
        }
        number.push_back(static_cast<uint32_t>(soup.positions.size()));
        soup.positions.push_back(
            {p[0] * std::cos(angle), p[1], p[0] * std::sin(angle)});
        flat.push_back({page, p[0], p[1]});
      }
      for (const Triangle& t : grid.triangles) {
        soup.triangles.push_back({number[t[0]], number[t[1]], number[t[2]]});
      }
    }
  }

  double Distance(uint32_t a, uint32_t b) const {
    const Place &p = flat[a], &q = flat[b];
    // Two pages unfold into one plane.
    const double dx = p.page == q.page ? p.x - q.x : p.x + q.x;
    return std::hypot(dx, p.y - q.y);
  }

  struct Place {
    uint32_t page;
    double x, y;
  };
  TriangleSoup soup;
  std::vector<Place> flat;
};

TEST_P(NonManifold, PagesOfABookUnfoldIntoThePlane) {
  for (const uint32_t pages : {3u, 5u}) {
    const Book book(pages);
    ExpectDistances(
        {"book", book.soup}, SpreadVertices(book.soup, 6),
        [&](uint32_t s, uint32_t v) { return book.Distance(s, v); });
    ExpectDistances({"book with faces turned", TurnFaces(book.soup, 3)},
                    SpreadVertices(book.soup, 3), [&](uint32_t s, uint32_t v) {
                      return book.Distance(s, v);
                    });
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
  const std::shared_ptr<const Mesh> mesh =
      BuildOrFail({"cubes that share an edge", soup});
  ASSERT_NE(mesh, nullptr);
  const BruteForce brute_force(soup);
  for (const uint32_t s : SpreadVertices(soup, 6)) {
    ExpectField("cubes that share an edge", *mesh, {{VertexPoint{s}}},
                brute_force.Distances(s));
  }
  // From the middle of one face beside the edge to that of one of the other.
  const auto number = [&](const Point& p) {
    return static_cast<uint32_t>(std::ranges::find(soup.positions, p) -
                                 soup.positions.begin());
  };
  const uint32_t from = number({1, 0.5, 0.5}), to = number({1.5, 1, 1});
  ASSERT_LT(from, soup.positions.size());
  ASSERT_LT(to, soup.positions.size());
  const std::vector<double> field = SolveOn(*mesh, {{VertexPoint{from}}});
  EXPECT_NEAR(field[to], std::hypot(1, 0.5), 1e-12);
}

GEODESIC_TEST_EVERY_ALGORITHM(NonManifold);

}  // namespace
}  // namespace geodesic::test
