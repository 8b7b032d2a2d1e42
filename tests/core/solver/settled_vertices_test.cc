// The certified frontier: every vertex once, in order, final when given out.

#include "geodesic/settled_vertices.h"

#include <gtest/gtest.h>

#include <limits>
#include <memory>
#include <vector>

#include "geodesic/computation.h"
#include "tests/support/curved_meshes.h"
#include "tests/support/mesh_edits.h"

namespace geodesic {
namespace {

class CollectingCheckpoint final : public Checkpoint {
 public:
  absl::Status Poll(const Progress& progress) override {
    const size_t before = settled.size();
    for (const SettledVertex& vertex : vertices_.Collect(progress)) {
      settled.push_back(vertex);
    }
    early += progress.settled_radius < std::numeric_limits<double>::infinity()
                 ? settled.size() - before
                 : 0;
    return absl::OkStatus();
  }

  std::vector<SettledVertex> settled;
  size_t early = 0;  // given out while the wavefront still moved

 private:
  SettledVertices vertices_;
};

class SettledVerticesTest : public ::testing::TestWithParam<AlgorithmInfo> {};

TEST_P(SettledVerticesTest, GivesOutEveryReachedVertexOnceInOrder) {
  const auto mesh =
      *Mesh::Build(test::AddIsolatedVertices(test::Terrain(30, 30, 1.0, 5), 2));
  const auto query = *ValidQuery::Make(
      {.sources = {{VertexPoint{17}}}, .algorithm = GetParam().algorithm},
      *mesh);
  auto computation = *StartComputation(*mesh, query, {});
  CollectingCheckpoint checkpoint;
  ASSERT_TRUE(computation->Advance({}, checkpoint).ok());
  const DistanceField field = computation->Field();
  ASSERT_EQ(checkpoint.settled.size(), mesh->vertex_count() - 2);
  EXPECT_GT(checkpoint.early, 0u);
  EXPECT_EQ(checkpoint.settled[0].vertex, 17u);
  std::vector<bool> seen(mesh->vertex_count());
  for (size_t i = 0; i < checkpoint.settled.size(); ++i) {
    const auto& [vertex, distance] = checkpoint.settled[i];
    EXPECT_FALSE(seen[vertex]) << vertex;
    seen[vertex] = true;
    EXPECT_EQ(distance, field.distances[vertex]);
    if (i > 0) {
      EXPECT_GE(distance, checkpoint.settled[i - 1].distance);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Algorithms, SettledVerticesTest,
                         ::testing::ValuesIn(kAlgorithms),
                         [](const auto& test_info) {
                           std::string name(test_info.param.name);
                           for (char& c : name) c = c == '-' ? '_' : c;
                           return name;
                         });

}  // namespace
}  // namespace geodesic
