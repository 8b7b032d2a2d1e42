// All algorithms agree with each other on real meshes, and their fields obey
// the laws that need no second program.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/core/exactness/every_algorithm.h"
#include "tests/support/edge_dijkstra.h"
#include "tests/support/test_meshes.h"

namespace geodesic::test {
namespace {

class RealMeshes : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    absl::StatusOr<TriangleSoup> soup = LoadTestMesh(GetParam());
    if (absl::IsNotFound(soup.status())) GTEST_SKIP() << soup.status();
    ASSERT_TRUE(soup.ok()) << soup.status();
    named_ = {GetParam(), *std::move(soup)};
    mesh_ = BuildOrFail(named_);
    ASSERT_NE(mesh_, nullptr);
  }

  NamedMesh named_;
  std::shared_ptr<const Mesh> mesh_;
};

TEST_P(RealMeshes, AlgorithmsAgree) {
  const uint32_t source = named_.soup.triangles[0][0];
  const std::vector<Source> sources = {{.vertex = source}};
  const std::vector<double> field =
      SolveOrFail(*mesh_, kDefaultAlgorithm, sources);
  ASSERT_EQ(field.size(), mesh_->vertex_count());
  for (const AlgorithmInfo& info : kAlgorithms) {
    EXPECT_TRUE(FieldsAgree({named_.name, sources, info.name}, field,
                            SolveOrFail(*mesh_, info.algorithm, sources)));
  }
  const std::vector<Real> edges = EdgeDistances(named_.soup, source);
  uint32_t farthest = source;
  for (uint32_t v = 0; v < field.size(); ++v) {
    ASSERT_LE(field[v], edges[v] * (1 + kRelativeTolerance)) << v;
    if (std::isfinite(field[v]) && field[v] > field[farthest]) farthest = v;
  }
  // And back again.
  const std::vector<double> back =
      SolveOrFail(*mesh_, kDefaultAlgorithm, {{.vertex = farthest}});
  ASSERT_EQ(back.size(), field.size());
  EXPECT_NEAR(back[source], field[farthest],
              kRelativeTolerance * field[farthest]);
}

INSTANTIATE_TEST_SUITE_P(Meshes, RealMeshes,
                         testing::Values("real/armadillo_86k.obj",
                                         "real/boot_40k.obj",
                                         "real/brain_icbm152_lh_82k.ply",
                                         "real/bunny.obj",
                                         "real/cgal_anchor_dense.off"));

}  // namespace
}  // namespace geodesic::test
