// The Voronoi label of a vertex names a source whose own field is least there.

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <vector>

#include "absl/status/status.h"
#include "geodesic/field_quantities.h"
#include "tests/core/exactness/every_algorithm.h"
#include "tests/core/questions/path_check.h"
#include "tests/support/curved_meshes.h"
#include "tests/support/mesh_edits.h"
#include "tests/support/planar_curves.h"
#include "tests/support/planar_meshes.h"
#include "tests/support/vec.h"

namespace geodesic::test {
namespace {

class NearestSourcesTest : public EveryAlgorithm {
 protected:
  void ExpectLeastFields(const NamedMesh& named,
                         const std::vector<Source>& sources) const {
    const std::shared_ptr<const Mesh> mesh = BuildOrFail(named);
    ASSERT_NE(mesh, nullptr);
    const Query query{
        .sources = sources, .algorithm = GetParam().algorithm, .trace = true};
    const absl::StatusOr<std::vector<uint32_t>> labels =
        NearestSources(*mesh, Valid(*mesh, query), SolveTraced(*mesh, query));
    ASSERT_TRUE(labels.ok()) << labels.status();
    std::vector<std::vector<double>> fields;
    for (const Source& source : sources) {
      fields.push_back(SolveOn(*mesh, {source}));
    }
    for (uint32_t v = 0; v < mesh->vertex_count(); ++v) {
      double least = std::numeric_limits<double>::infinity();
      for (const std::vector<double>& field : fields) {
        least = std::min(least, field[v]);
      }
      const uint32_t label = (*labels)[v];
      if (std::isinf(least)) {
        EXPECT_EQ(label, kNoSource) << named.name << " " << v;
        continue;
      }
      ASSERT_LT(label, sources.size()) << named.name << " " << v;
      EXPECT_LE(fields[label][v], least * (1 + kRelativeTolerance))
          << named.name << " " << v;
    }
  }
};

TEST_P(NearestSourcesTest, AreThoseOfTheLeastField) {
  ExpectLeastFields({"grid", MakeGrid({.columns = 12, .rows = 12})},
                    {{VertexPoint{0}},
                     {VertexPoint{168}, 0.5},
                     {FacePoint{100, {0.25, 0.25, 0.5}}, 1},
                     {VertexPoint{12}}});
  ExpectLeastFields({"U", MakeGrid(UShape({.columns = 9, .rows = 9}))},
                    {{VertexPoint{3}}, {VertexPoint{40}}});
  const TriangleSoup torus = Torus({.around = 20, .across = 14, .noise = 0.15});
  const Triangle& face = torus.triangles[200];
  ExpectLeastFields({"torus", torus}, {{VertexPoint{5}},
                                       {EdgePoint{face[1], face[0], 0.3}, 0.1},
                                       {FacePoint{77, {0.2, 0.7, 0.1}}, 0.2},
                                       {VertexPoint{5}, 0.25}});
}

// A source whose offset is more than the way from another is nowhere nearest.
TEST_P(NearestSourcesTest, LeaveOutDominatedSources) {
  const std::shared_ptr<const Mesh> mesh =
      BuildOrFail({"icosphere", Icosphere(1)});
  ASSERT_NE(mesh, nullptr);
  const Query query{.sources = {{VertexPoint{7}, 100}, {VertexPoint{30}}},
                    .algorithm = GetParam().algorithm,
                    .trace = true};
  const absl::StatusOr<std::vector<uint32_t>> labels =
      NearestSources(*mesh, Valid(*mesh, query), SolveTraced(*mesh, query));
  ASSERT_TRUE(labels.ok()) << labels.status();
  EXPECT_EQ(*labels, std::vector<uint32_t>(mesh->vertex_count(), 1));
}

// On a plane, where each curve's distance is Euclid's: a point between two of
// them.
TEST_P(NearestSourcesTest, AreNumberedAsTheyAreListed) {
  const TriangleSoup grid =
      MakeGrid({.columns = 12, .rows = 12, .jitter = 0.2, .seed = 3});
  const std::shared_ptr<const Mesh> mesh = BuildOrFail({"grid", grid});
  ASSERT_NE(mesh, nullptr);
  const PlanarCurve low{{{1.3, 1.1}, {10.2, 1.9}}, 0.25};
  const PlanarCurve high{{{2.4, 9.7}, {6.1, 10.4}, {9.8, 8.2}}, 0};
  const Query query{.sources = {OnMesh(grid, low),
                                {VertexPoint{6 * 13 + 12}, 0.5},
                                OnMesh(grid, high)},
                    .algorithm = GetParam().algorithm,
                    .trace = true};
  const absl::StatusOr<std::vector<uint32_t>> labels =
      NearestSources(*mesh, Valid(*mesh, query), SolveTraced(*mesh, query));
  ASSERT_TRUE(labels.ok()) << labels.status();
  std::vector<uint32_t> count(3);
  for (uint32_t v = 0; v < mesh->vertex_count(); ++v) {
    const Point& p = grid.positions[v];
    const std::vector<double> distances = {
        DistanceTo(low, p),
        0.5 + static_cast<double>(Distance(p, grid.positions[6 * 13 + 12])),
        DistanceTo(high, p)};
    const uint32_t label = (*labels)[v];
    ASSERT_LT(label, 3u) << v;
    EXPECT_LE(distances[label],
              *std::ranges::min_element(distances) * (1 + kRelativeTolerance))
        << v;
    ++count[label];
  }
  for (const uint32_t vertices : count) EXPECT_GT(vertices, 0u);
}

TEST_P(NearestSourcesTest, AreNoneInOtherPieces) {
  const TriangleSoup sphere = Icosphere(1);
  ExpectLeastFields({"two spheres and a lone vertex",
                     AddIsolatedVertices(Join(sphere, sphere), 1)},
                    {{VertexPoint{3}}, {VertexPoint{11}}});
}

GEODESIC_TEST_EVERY_ALGORITHM(NearestSourcesTest);

TEST(NearestSources, SaysSoWhenTheTraceIsMissingOrBroken) {
  const std::shared_ptr<const Mesh> mesh =
      BuildOrFail({"icosphere", Icosphere(1)});
  ASSERT_NE(mesh, nullptr);
  const Query query{.sources = {{VertexPoint{0}}}, .trace = true};
  DistanceField field = SolveTraced(*mesh, query);
  field.arrivals[1] = {.pseudo_source = 2};
  field.arrivals[2] = {.pseudo_source = 1};
  EXPECT_TRUE(absl::IsInternal(
      NearestSources(*mesh, Valid(*mesh, query), field).status()));
  field.arrivals.clear();
  EXPECT_TRUE(absl::IsInvalidArgument(
      NearestSources(*mesh, Valid(*mesh, query), field).status()));
}

}  // namespace
}  // namespace geodesic::test
