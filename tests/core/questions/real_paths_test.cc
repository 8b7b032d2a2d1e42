// Paths on real meshes: scans, CAD parts, terrain.

#include <gtest/gtest.h>

#include "tests/core/exactness/every_algorithm.h"
#include "tests/core/questions/path_check.h"

namespace geodesic::test {
namespace {

class RealPaths : public RealMesh {};

TEST_P(RealPaths, AreAsLongAsDistances) {
  const double slack = 64 * CoordinateRounding(named_.soup.positions);
  const uint32_t vertex = named_.soup.triangles[0][0];
  const uint32_t face = mesh_->face_count() / 2;
  constexpr uint32_t kMostPaths = 1000;
  const uint32_t stride = 1 + mesh_->vertex_count() / kMostPaths;
  for (const Algorithm algorithm :
       {Algorithm::kFwpList, Algorithm::kFwpCh, Algorithm::kFwpMmp}) {
    CheckAllPaths(named_.name, *mesh_,
                  {.sources = {{VertexPoint{vertex}},
                               {FacePoint{face, {0.5, 0.25, 0.25}}}},
                   .targets = {FacePoint{face / 2, {0.1, 0.8, 0.1}}},
                   .algorithm = algorithm},
                  {.slack = slack}, stride);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Meshes, RealPaths,
    testing::Values("cgal_anchor_dense.off", "cgal_cheese.off",
                    "cgal_elephant.off", "cgal_fandisk_large.off",
                    "cgal_holes.off", "cgal_rotor_small.off",
                    "cgal_three_peaks.off", "of_flange_6k.ply", "fandisk.obj",
                    "spot_23k.obj", "tray_bottom_4k.ply", "bunny.obj",
                    "horse_be.ply"),
    MeshTestName);

}  // namespace
}  // namespace geodesic::test
