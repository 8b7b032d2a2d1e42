// All algorithms agree with each other on real meshes, and their fields obey
// the laws that need no second program.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
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

INSTANTIATE_TEST_SUITE_P(
    Meshes, RealMeshes,
    testing::Values(
        "real/armadillo_86k.obj", "real/boot_40k.obj",
        "real/brain_icbm152_lh_82k.ply", "real/bunny.obj",
        "real/bunny_closed.obj", "real/cgal_anchor_dense.off",
        "real/cgal_blade.off", "real/cgal_blobby_3cc.off",
        "real/cgal_bones.off", "real/cgal_bull.off", "real/cgal_bunny00.off",
        "real/cgal_camel.off", "real/cgal_cheese.off",
        "real/cgal_couplingdown.off", "real/cgal_cube.off",
        "real/cgal_dino.off", "real/cgal_double-torus-example.off",
        "real/cgal_eight.off", "real/cgal_elephant.off",
        "real/cgal_fandisk_large.off", "real/cgal_femur.off",
        "real/cgal_handle.off", "real/cgal_holes.off", "real/cgal_homer.off",
        "real/cgal_icosahedron.off", "real/cgal_joint.off",
        "real/cgal_knot2.off", "real/cgal_lion-head.off", "real/cgal_man.off",
        "real/cgal_mannequin-devil.off", "real/cgal_oblong.off",
        "real/cgal_pinion_small.off", "real/cgal_pipe.off",
        "real/cgal_refined_elephant.off", "real/cgal_rotor_small.off",
        "real/cgal_spool.off", "real/cgal_tetrahedron.off",
        "real/cgal_three_peaks.off", "real/cgal_turbine.off",
        "real/dragon_100k.obj", "real/fandisk.obj", "real/fertility_60k.obj",
        "real/gargoyle_50k.obj", "real/gears_19k.ply", "real/horse_be.ply",
        "real/laurana_50k.ply", "real/lucy_100k.ply", "real/maxplanck_100k.ply",
        "real/mountain_51k.obj", "real/of_flange_6k.ply",
        "real/of_propellertip_33k.obj", "real/rangemap_lato000_87k.ply",
        "real/spot_23k.obj", "real/tray_bottom_4k.ply"));

}  // namespace
}  // namespace geodesic::test
