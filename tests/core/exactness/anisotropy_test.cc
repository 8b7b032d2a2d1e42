// Faces a million times as long as high: needles side by side, on flat and on
// curved surfaces, against closed forms and brute force.

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "absl/strings/str_cat.h"
#include "geodesic/mesh_summary.h"
#include "tests/core/exactness/every_algorithm.h"
#include "tests/support/meshes/curved_meshes.h"
#include "tests/support/meshes/developable_meshes.h"
#include "tests/support/meshes/mesh_edits.h"
#include "tests/support/meshes/planar_meshes.h"
#include "tests/support/meshes/polyhedra.h"

namespace geodesic::test {
namespace {

class AnisotropicMeshes : public EveryAlgorithm {
 protected:
  static void ExpectAnisotropy(const NamedMesh& named) {
    const std::shared_ptr<const Mesh> mesh = BuildOrFail(named);
    EXPECT_GE(Summarize(*mesh).anisotropy, 1e5) << named.name;
  }
};

TriangleSoup Stretch(TriangleSoup soup, double factor) {
  for (Point& p : soup.positions) p[0] *= factor;
  return soup;
}

TEST_P(AnisotropicMeshes, Prisms) {
  for (const double row_height : {1e-6, 1e6}) {
    const Prism prism({.sides = 7, .rows = 20, .row_height = row_height});
    const NamedMesh named{absl::StrCat("prism with rows of ", row_height),
                          prism.soup()};
    ExpectAnisotropy(named);
    ExpectDistances(
        named, SpreadVertices(named.soup, 5),
        [&](uint32_t s, uint32_t v) { return prism.Distance(s, v); });
  }
}

TEST_P(AnisotropicMeshes, ThinBox) {
  const Polyhedron box = Box(1, 1e-5, 1);
  const NamedMesh named{"thin box", BoxGrid(1, 1e-5, 1, 1, 10, 1)};
  ExpectAnisotropy(named);
  ExpectDistances(named, SpreadVertices(named.soup, 5),
                  [&](uint32_t s, uint32_t v) {
                    return DistanceOnConvex(box, named.soup.positions[s],
                                            named.soup.positions[v]);
                  });
}

// High faces and wide ones; in the regular grid rays tie along every row and
// column.
TEST_P(AnisotropicMeshes, Grids) {
  for (const GridOptions& options : {GridOptions{.columns = 40,
                                    .rows = 10,
                                    .cell_width = 1e-6,
                                    .diagonals = Diagonals::kAlternating},
                                     {.columns = 20,
                                     .rows = 6,
                                     .cell_width = 0x1p-20,
                                     .diagonals = Diagonals::kRandom},
                                     {.columns = 12,
                                     .rows = 30,
                                     .cell_height = 1e-6,
                                     .diagonals = Diagonals::kAlternating,
                                     .jitter = 0.2}}) {
    const NamedMesh named{"grid of needles", MakeGrid(options)};
    ExpectAnisotropy(named);
    ExpectEuclid(named, SpreadVertices(named.soup, 7));
  }
}

TEST_P(AnisotropicMeshes, StretchedTerrain) {
  for (const uint64_t seed : {1, 2, 3, 4}) {
    const NamedMesh named{"stretched terrain",
                          Stretch(Terrain(5, 5, 1, seed), 1e6)};
    ExpectAnisotropy(named);
    ExpectBruteForce(named, SpreadVertices(named.soup, 4));
  }
}

// Not a million here: straight lines that wind round a tube as often as that
// are what rules of the Chen and Han family are slow to prune (and brute force
// never ends on). The rules, which prune by different arguments, have to agree.
TEST_P(AnisotropicMeshes, StretchedTorus) {
  for (const double noise : {0.0, 0.2}) {
    const NamedMesh named{
        "stretched torus",
        Stretch(Torus({.around = 12, .across = 6, .noise = noise}), 1000)};
    const std::shared_ptr<const Mesh> mesh = BuildOrFail(named);
    for (const uint32_t s : SpreadVertices(named.soup, 4)) {
      const std::vector<Source> sources = {{VertexPoint{s}}};
      for (const Algorithm other : {Algorithm::kMmp, Algorithm::kIch}) {
        ExpectField(named.name, *mesh, sources,
                    SolveOrFail(*mesh, other, sources));
      }
    }
  }
}

GEODESIC_TEST_EVERY_ALGORITHM(AnisotropicMeshes);

}  // namespace
}  // namespace geodesic::test
