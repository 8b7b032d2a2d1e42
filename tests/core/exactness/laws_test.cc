// Laws that every distance field obeys, whatever the mesh.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "absl/strings/str_cat.h"
#include "tests/core/exactness/every_algorithm.h"
#include "tests/support/meshes/curved_meshes.h"
#include "tests/support/meshes/mesh_edits.h"
#include "tests/support/meshes/planar_meshes.h"
#include "tests/support/meshes/polyhedra.h"
#include "tests/support/vec.h"

namespace geodesic::test {
namespace {

std::vector<NamedMesh> Surfaces() {
  return {{"icosphere", Icosphere(3)},
          {"sphere by meridians", UvSphere(24, 20)},
          {"anisotropic torus", Torus({.around = 10, .across = 60})},
          {"noisy torus", Torus({.around = 30, .across = 18, .noise = 0.15})},
          {"terrain", Terrain(24, 20, 1.5, 7)},
          {"box", BoxGrid(1, 2, 3, 4, 6, 8)},
          {"L plate", MakePlate(LShape({.columns = 12, .rows = 10}), 0.7)},
          {"grid with a hole",
           MakeGrid(WithHole({.columns = 18, .rows = 18, .jitter = 0.2}))}};
}

class Laws : public EveryAlgorithm {
 protected:
  // The field of one source on a mesh made of `soup`.
  std::vector<double> Field(const NamedMesh& named, uint32_t source) const {
    const std::shared_ptr<const Mesh> mesh = BuildOrFail(named);
    return SolveOn(*mesh, {{VertexPoint{source}}});
  }

  // Expects these distances of the first vertices of another mesh.
  void ExpectSame(const NamedMesh& other, uint32_t source,
                  const std::vector<double>& expected) const {
    std::vector<double> field = Field(other, source);
    field.resize(expected.size());
    EXPECT_TRUE(
        FieldsAgree({other.name, {{VertexPoint{source}}}, GetParam().name},
                    expected, field));
  }
};

// And distances along edges are no less, which SolveOrFail sees to.
TEST_P(Laws, DistancesAreAMetricAboveEuclids) {
  for (const NamedMesh& named : Surfaces()) {
    SCOPED_TRACE(named.name);
    const std::vector<Point>& positions = named.soup.positions;
    const std::vector<uint32_t> vertices = SpreadVertices(named.soup, 6);
    std::vector<std::vector<double>> from;
    for (const uint32_t s : vertices) from.push_back(Field(named, s));
    for (size_t i = 0; i < vertices.size(); ++i) {
      const uint32_t s = vertices[i];
      EXPECT_EQ(from[i][s], 0) << s;
      for (size_t v = 0; v < from[i].size(); ++v) {
        ASSERT_GE(from[i][v], Distance(positions[s], positions[v]) *
                                  (1 - kRelativeTolerance))
            << "from " << s << " to " << v;
      }
      for (size_t j = 0; j < vertices.size(); ++j) {
        const double there = from[i][vertices[j]];
        EXPECT_NEAR(from[j][s], there, kRelativeTolerance * there)
            << "vertices " << s << " and " << vertices[j];
        for (size_t v = 0; v < from[i].size(); ++v) {
          ASSERT_LE(from[i][v], (there + from[j][v]) * (1 + kRelativeTolerance))
              << "from " << s << " to " << v << " by way of " << vertices[j];
        }
      }
    }
  }
}

TEST_P(Laws, RigidMotionChangesNothing) {
  for (const NamedMesh& named : Surfaces()) {
    const NamedMesh moved{named.name + ", moved",
                          RotateAndShift(named.soup, 11)};
    for (const uint32_t s : SpreadVertices(named.soup, 3)) {
      ExpectSame(moved, s, Field(named, s));
    }
  }
}

// Up to where squares of coordinates overflow or vanish.
TEST_P(Laws, ScalingScalesDistances) {
  for (const NamedMesh& named : Surfaces()) {
    const uint32_t s = static_cast<uint32_t>(named.soup.positions.size() / 3);
    const std::vector<double> field = Field(named, s);
    for (const double factor :
         {3.7, 0x1p40, 0x1p-500, 0x1p500, 1e-150, 1e150, 1e-290, 1e300}) {
      std::vector<double> expected = field;
      for (double& d : expected) d *= factor;
      const NamedMesh scaled{absl::StrCat(named.name, " times ", factor),
                             Scale(named.soup, factor)};
      ExpectSame(scaled, s, expected);
    }
  }
}

TEST_P(Laws, RelabellingRelabelsDistances) {
  for (const NamedMesh& named : Surfaces()) {
    const Relabelled relabelled = Relabel(named.soup, 5);
    const NamedMesh shuffled{named.name + ", relabelled", relabelled.soup};
    for (const uint32_t s : SpreadVertices(named.soup, 3)) {
      const std::vector<double> field = Field(named, s);
      std::vector<double> expected(field.size());
      for (size_t v = 0; v < field.size(); ++v) {
        expected[relabelled.new_number[v]] = field[v];
      }
      ExpectSame(shuffled, relabelled.new_number[s], expected);
    }
  }
}

// Faces cut up in their own plane are the same surface.
TEST_P(Laws, SubdivisionInPlaneKeepsDistances) {
  for (const NamedMesh& named : Surfaces()) {
    const uint32_t faces = static_cast<uint32_t>(named.soup.triangles.size());
    const std::vector<NamedMesh> finer = {
        {named.name + ", cut at midpoints", SubdivideAtMidpoints(named.soup)},
        {named.name + ", faces split", SplitFaces(named.soup, faces / 2, 3)},
        {named.name + ", with needles", InsertNeedles(named.soup, 40, 3)},
        {named.name + ", with zero-area faces",
         InsertZeroAreaFaces(named.soup, 20, 3)}};
    for (const uint32_t s : SpreadVertices(named.soup, 3)) {
      const std::vector<double> expected = Field(named, s);
      // The old vertices come first.
      for (const NamedMesh& fine : finer) ExpectSame(fine, s, expected);
    }
  }
}

TEST_P(Laws, ManySourcesGiveTheLeastOfTheSingleFields) {
  for (const NamedMesh& named : Surfaces()) {
    const std::shared_ptr<const Mesh> mesh = BuildOrFail(named);
    std::vector<Source> sources;
    std::vector<double> expected(mesh->vertex_count(),
                                 std::numeric_limits<double>::infinity());
    for (const uint32_t v : SpreadVertices(named.soup, 6)) {
      const Source source{VertexPoint{v}, 0.1 * sources.size()};
      sources.push_back(source);
      const std::vector<double> single = SolveOn(*mesh, {{VertexPoint{v}}});
      for (size_t i = 0; i < single.size(); ++i) {
        expected[i] = std::min(expected[i], single[i] + source.offset);
      }
    }
    ExpectField(named.name, *mesh, sources, expected);
    // All vertices at once.
    std::vector<Source> everywhere;
    for (uint32_t v = 0; v < mesh->vertex_count(); ++v) {
      everywhere.push_back({VertexPoint{v}});
    }
    ExpectField(named.name, *mesh, everywhere,
                std::vector<double>(mesh->vertex_count(), 0));
  }
}

// A source whose offset exceeds its distance from the others adds nothing, not
// even at its own vertex; one given twice counts with its least offset.
TEST_P(Laws, DominatedSourcesAddNothing) {
  for (const NamedMesh& named : Surfaces()) {
    const std::shared_ptr<const Mesh> mesh = BuildOrFail(named);
    const std::vector<uint32_t> v = SpreadVertices(named.soup, 4);
    const std::vector<double> expected = SolveOn(*mesh, {{VertexPoint{v[1]}}});
    ExpectField(named.name, *mesh,
                {{VertexPoint{v[0]}, expected[v[0]] * (1 + 1e-6)},
                 {VertexPoint{v[1]}, 0},
                 {VertexPoint{v[2]}, expected[v[2]] + 1},
                 {VertexPoint{v[1]}, 3},
                 {VertexPoint{v[3]}, 1e5}},
                expected);
    // Exactly as far as the other: a tie.
    ExpectField(named.name, *mesh,
                {{VertexPoint{v[1]}, 0}, {VertexPoint{v[2]}, expected[v[2]]}},
                expected);
  }
}

GEODESIC_TEST_EVERY_ALGORITHM(Laws);

}  // namespace
}  // namespace geodesic::test
