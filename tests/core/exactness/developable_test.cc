// Cones, saddle fans, prisms, folded sheets and convex polyhedra against their
// closed forms.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "absl/strings/str_cat.h"
#include "tests/core/exactness/every_algorithm.h"
#include "tests/support/meshes/developable_meshes.h"
#include "tests/support/meshes/mesh_edits.h"
#include "tests/support/meshes/polyhedra.h"

namespace geodesic::test {
namespace {

constexpr double kPi = std::numbers::pi;

class DevelopableMeshes : public EveryAlgorithm {
 protected:
  template <typename Surface>
  void ExpectClosedForm(const std::string& name, const Surface& surface) const {
    ExpectDistances(
        {name, surface.soup()}, SpreadVertices(surface.soup(), 6),
        [&](uint32_t s, uint32_t v) { return surface.Distance(s, v); });
  }
};

// From sharp cones over the flat disc to deep saddles. At the angles that are
// multiples of pi, shortest paths run exactly through the apex.
TEST_P(DevelopableMeshes, Fans) {
  for (const double angle :
       {0.3, 2.0, kPi, 5.5, 2 * kPi - 1e-7, 2 * kPi, 2 * kPi + 1e-7,
        2 * kPi + 1e-3, 7.0, 3 * kPi, 4 * kPi, 20.0}) {
    for (const bool closed : {true, false}) {
      for (const uint32_t spokes : {8u, 24u}) {
        const Fan fan({.spokes = spokes,
                       .rings = 5,
                       .total_angle = angle,
                       .closed = closed});
        ExpectClosedForm(absl::StrCat(closed ? "closed" : "open", " fan of ",
                                      spokes, " sectors, angle ", angle),
                         fan);
      }
    }
  }
}

// An apex with very many faces, as the tip of a fine cone has.
TEST_P(DevelopableMeshes, FanOfManySpokes) {
  ExpectClosedForm("cone of 600 sectors",
                   Fan({.spokes = 600, .rings = 2, .total_angle = 5}));
  ExpectClosedForm("saddle fan of 600 sectors",
                   Fan({.spokes = 600, .rings = 2, .total_angle = 15}));
}

TEST_P(DevelopableMeshes, Prisms) {
  for (const uint32_t sides : {3u, 4u, 7u, 12u}) {
    ExpectClosedForm(absl::StrCat("prism of ", sides, " sides"),
                     Prism({.sides = sides, .rows = 20}));
    ExpectClosedForm(absl::StrCat("low prism of ", sides, " sides"),
                     Prism({.sides = sides, .rows = 9, .row_height = 0.05}));
  }
}

TEST_P(DevelopableMeshes, FoldedSheets) {
  for (const uint64_t seed : {1, 2, 3}) {
    ExpectClosedForm("folded sheet", FoldedSheet(25, 18, seed));
  }
}

// A strip of an odd number of congruent triangles whose ends are joined: a
// Moebius strip. Vertex i lies on one long side for even i and on the other for
// odd i; beyond the last one the strip goes on turned over. Its vertices may
// lie on a circle: what counts is that the triangles are congruent.
class MoebiusStrip {
 public:
  explicit MoebiusStrip(uint32_t count) : count_(count) {
    for (uint32_t i = 0; i < count; ++i) {
      const double angle = 2 * kPi * i / count;
      soup_.positions.push_back({std::cos(angle), std::sin(angle), 0});
      soup_.triangles.push_back({i, (i + 1) % count, (i + 2) % count});
    }
    step_ = std::sin(2 * kPi / count);
    width_ = 2 * std::pow(std::sin(kPi / count), 2);
  }

  const TriangleSoup& soup() const { return soup_; }

  // Unrolled, straight lines stay in the strip: the shortest of those to the
  // images of w.
  double Distance(uint32_t v, uint32_t w) const {
    double least = std::numeric_limits<double>::infinity();
    for (int turns = -2; turns <= 2; ++turns) {
      const int steps =
          static_cast<int>(w + turns * count_) - static_cast<int>(v);
      least = std::min(least,
                       std::hypot(steps * step_, steps % 2 == 0 ? 0 : width_));
    }
    return least;
  }

 private:
  int count_;
  double step_, width_;
  TriangleSoup soup_;
};

TEST_P(DevelopableMeshes, MoebiusStrips) {
  for (const uint32_t count : {7u, 9u, 31u}) {
    const MoebiusStrip strip(count);
    ExpectClosedForm(absl::StrCat("Moebius strip of ", count), strip);
    // Finer faces, with vertices inside; the old ones come first.
    const TriangleSoup fine =
        SubdivideAtMidpoints(SubdivideAtMidpoints(strip.soup()));
    const auto mesh = BuildOrFail({"fine Moebius strip", fine});
    for (uint32_t s = 0; s < count; s += 3) {
      const std::vector<Source> sources = {{VertexPoint{s}}};
      std::vector<double> expected, got = SolveOn(*mesh, sources);
      for (uint32_t v = 0; v < count; ++v) {
        expected.push_back(strip.Distance(s, v));
      }
      got.resize(count);
      EXPECT_TRUE(FieldsAgree({"fine Moebius strip", sources, GetParam().name},
                              expected, got));
    }
  }
}

GEODESIC_TEST_EVERY_ALGORITHM(DevelopableMeshes);

// Finely divided, against unfolding of their undivided faces.
class ConvexPolyhedra : public EveryAlgorithm {
 protected:
  void ExpectUnfolding(const Polyhedron& polyhedron, const TriangleSoup& soup,
                       uint32_t sources) const {
    ExpectDistances({polyhedron.name, soup}, SpreadVertices(soup, sources),
                    [&](uint32_t s, uint32_t v) {
                      return DistanceOnConvex(polyhedron, soup.positions[s],
                                              soup.positions[v]);
                    });
  }
};

TEST_P(ConvexPolyhedra, RegularSolids) {
  for (const Polyhedron& solid : {Tetrahedron(), Octahedron(), Icosahedron()}) {
    TriangleSoup fine = Triangulate(solid);
    ExpectUnfolding(solid, fine, 4);
    for (int level = 0; level < 3; ++level) fine = SubdivideAtMidpoints(fine);
    ExpectUnfolding(solid, fine, 3);
    ExpectUnfolding(solid, SplitFaces(Triangulate(solid), 60, 1), 4);
  }
}

TEST_P(ConvexPolyhedra, Boxes) {
  ExpectUnfolding(Box(1, 1, 1), BoxGrid(1, 1, 1, 6, 6, 6), 5);
  ExpectUnfolding(Box(3, 1.1, 0.7), BoxGrid(3, 1.1, 0.7, 10, 5, 4), 5);
  ExpectUnfolding(Box(2, 1, 0.01), BoxGrid(2, 1, 0.01, 9, 6, 2), 5);
  ExpectUnfolding(Box(1, 2, 4), SplitFaces(Triangulate(Box(1, 2, 4)), 80, 2),
                  5);
}

GEODESIC_TEST_EVERY_ALGORITHM(ConvexPolyhedra);

}  // namespace
}  // namespace geodesic::test
