// All algorithms agree with each other on real meshes, and their fields obey
// the laws that need no second program.

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "tests/core/exactness/every_algorithm.h"

namespace geodesic::test {
namespace {

class RealMeshes : public RealMesh {
 protected:
  void ExpectAgreement() const {
    const uint32_t source = named_.soup.triangles[0][0];
    const std::vector<Source> sources = {{VertexPoint{source}}};
    const std::vector<double> field =
        SolveOrFail(*mesh_, kDefaultAlgorithm, sources);
    ExpectFromAll(AlgorithmsTestedOn(mesh_->face_count()), named_.name, *mesh_,
                  {.sources = sources}, field);
    // And back again.
    uint32_t farthest = source;
    for (uint32_t v = 0; v < field.size(); ++v) {
      if (std::isfinite(field[v]) && field[v] > field[farthest]) farthest = v;
    }
    const std::vector<double> back =
        SolveOrFail(*mesh_, kDefaultAlgorithm, {{VertexPoint{farthest}}});
    EXPECT_NEAR(back[source], field[farthest],
                kRelativeTolerance * field[farthest]);
  }
};

TEST_P(RealMeshes, AlgorithmsAgree) { ExpectAgreement(); }

// Half a minute more; run them with --gtest_also_run_disabled_tests.
class LargeRealMeshes : public RealMeshes {};
TEST_P(LargeRealMeshes, DISABLED_AlgorithmsAgree) { ExpectAgreement(); }

INSTANTIATE_TEST_SUITE_P(
    Meshes, RealMeshes,
    testing::Values(
        "boot_40k.obj", "cgal_anchor_dense.off", "cgal_blade.off",
        "cgal_blobby_3cc.off", "cgal_bones.off", "cgal_bull.off",
        "cgal_camel.off", "cgal_cheese.off", "cgal_couplingdown.off",
        "cgal_cube.off", "cgal_dino.off", "cgal_double-torus-example.off",
        "cgal_eight.off", "cgal_elephant.off", "cgal_fandisk_large.off",
        "cgal_femur.off", "cgal_handle.off", "cgal_holes.off", "cgal_homer.off",
        "cgal_icosahedron.off", "cgal_joint.off", "cgal_knot2.off",
        "cgal_lion-head.off", "cgal_man.off", "cgal_mannequin-devil.off",
        "cgal_oblong.off", "cgal_pinion_small.off", "cgal_pipe.off",
        "cgal_rotor_small.off", "cgal_spool.off", "cgal_tetrahedron.off",
        "cgal_three_peaks.off", "cgal_turbine.off", "fandisk.obj",
        "gears_19k.ply", "of_flange_6k.ply", "of_propellertip_33k.obj",
        "rangemap_lato000_87k.ply", "spot_23k.obj", "tray_bottom_4k.ply",
        "armadillo_86k.obj", "bunny.obj", "fertility_60k.obj", "horse_be.ply"),
    MeshTestName);

INSTANTIATE_TEST_SUITE_P(
    Meshes, LargeRealMeshes,
    testing::Values("brain_icbm152_lh_82k.ply", "bunny_closed.obj",
                    "cgal_bunny00.off", "cgal_refined_elephant.off",
                    "dragon_100k.obj", "lucy_100k.ply", "maxplanck_100k.ply",
                    "mountain_51k.obj", "gargoyle_50k.obj", "laurana_50k.ply"),
    MeshTestName);

}  // namespace
}  // namespace geodesic::test
