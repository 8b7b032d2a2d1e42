// Every algorithm against CGAL, on generated and on real meshes.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/core/exactness/cgal_oracle.h"
#include "tests/core/exactness/every_algorithm.h"
#include "tests/support/curved_meshes.h"
#include "tests/support/developable_meshes.h"
#include "tests/support/planar_meshes.h"
#include "tests/support/test_meshes.h"

namespace geodesic::test {
namespace {

// CGAL computes once for all algorithms, which takes longer than they do.
void ExpectCgal(const NamedMesh& named, const std::vector<uint32_t>& sources) {
  const std::shared_ptr<const Mesh> mesh = BuildOrFail(named);
  ASSERT_NE(mesh, nullptr);
  for (const uint32_t s : sources) {
    const std::vector<double> expected = CgalDistances(named.soup, s);
    for (const AlgorithmInfo& info : kAlgorithms) {
      EXPECT_TRUE(
          FieldsAgree({named.name, {{.vertex = s}}, info.name}, expected,
                      SolveOrFail(*mesh, info.algorithm, {{.vertex = s}})));
    }
  }
}

TEST(CgalComparison, GeneratedMeshes) {
  for (const NamedMesh& named : std::vector<NamedMesh>{
           {"icosphere", Icosphere(3)},
           {"sphere by meridians", UvSphere(24, 20)},
           {"anisotropic torus", Torus({.around = 10, .across = 60})},
           {"noisy torus", Torus({.around = 30, .across = 18, .noise = 0.15})},
           {"terrain", Terrain(24, 20, 1.5, 7)},
           {"saddle fan",
            Fan({.spokes = 16, .rings = 6, .total_angle = 9}).soup()},
           {"plate with a hole",
            MakePlate(WithHole({.columns = 12, .rows = 12}), 0.5)},
           {"jittered U",
            MakeGrid(UShape({.columns = 18, .rows = 18, .jitter = 0.2}))}}) {
    ExpectCgal(named, SpreadVertices(named.soup, 3));
  }
}

class CgalOnRealMesh : public testing::TestWithParam<const char*> {};

TEST_P(CgalOnRealMesh, Agrees) {
  const absl::StatusOr<TriangleSoup> soup = LoadTestMesh(GetParam());
  if (absl::IsNotFound(soup.status())) GTEST_SKIP() << soup.status();
  ASSERT_TRUE(soup.ok()) << soup.status();
  ExpectCgal({GetParam(), *soup}, {soup->triangles[0][0]});
}

INSTANTIATE_TEST_SUITE_P(
    Meshes, CgalOnRealMesh,
    testing::Values("real/cgal_elephant.off", "real/cgal_holes.off",
                    "real/cgal_homer.off", "real/of_flange_6k.ply",
                    "real/fandisk.obj", "real/cgal_knot2.off",
                    "real/tray_bottom_4k.ply"));

}  // namespace
}  // namespace geodesic::test
