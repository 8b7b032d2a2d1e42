// Vertices that exceed a full turn by next to nothing, alone and in rows: each
// hides a wedge too thin to see, and all of them together hide whole edges.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "absl/strings/str_cat.h"
#include "tests/core/exactness/every_algorithm.h"
#include "tests/support/meshes/curved_meshes.h"
#include "tests/support/oracles/edge_paths.h"
#include "tests/support/oracles/strip_paths.h"

namespace geodesic::test {
namespace {

class GentleSaddles : public EveryAlgorithm {
 protected:
  // From vertices 0, 1 and the last: no nearer than Euclid says and no farther
  // than along edges, which is the same in straight rows; and symmetric.
  void ExpectStraightRows(const NamedMesh& named) const {
    const auto mesh = BuildOrFail(named);
    const std::vector<Point>& p = named.soup.positions;
    const auto last = static_cast<uint32_t>(p.size() - 1);
    const std::vector<uint32_t> sources = {0, 1, last};
    std::vector<std::vector<double>> fields;
    for (const uint32_t s : sources) {
      fields.push_back(SolveOn(*mesh, {{VertexPoint{s}}}));
      const std::vector<double>& field = fields.back();
      const std::vector<Real> edges = EdgeDistances(named.soup, s);
      for (uint32_t v = 0; v < field.size(); ++v) {
        ASSERT_GE(field[v], Distance(p[s], p[v]) * (1 - 1e-13L))
            << named.name << ", " << s << " to " << v;
        ASSERT_LE(field[v], edges[v] * (1 + 1e-13L))
            << named.name << ", " << s << " to " << v;
      }
    }
    for (size_t i = 0; i < sources.size(); ++i) {
      for (size_t j = 0; j < i; ++j) {
        const double there = fields[i][sources[j]];
        EXPECT_NEAR(fields[j][sources[i]], there, 1e-13 * there) << named.name;
      }
    }
  }

  bool IsQuickEnough() const { return GetParam().algorithm != Algorithm::kCh; }
};

// The last are hidden from the solver by kFlatAngle, one by one.
TEST_P(GentleSaddles, HundredsInARow) {
  if (!IsQuickEnough()) GTEST_SKIP() << "too many windows";
  // Windows of mmp are many there.
  const uint32_t count = GetParam().algorithm == Algorithm::kMmp ? 150 : 450;
  for (const double excess : {1e-6, 0.97e-9, 1e-11, 0.9e-13, 1e-15}) {
    ExpectStraightRows(
        {absl::StrCat("row of excess ", excess), SaddleRow(count, excess, 16)});
  }
}

TEST_P(GentleSaddles, HyperbolicGrids) {
  for (const double twist :
       {1e-12, 1e-10, 1e-8, 1e-6, 3e-6, 1e-5, 3e-5, 1e-4, 1e-3, 1e-2}) {
    ExpectStraightRows(
        {absl::StrCat("twist ", twist), HyperbolicGrid(12, 16, twist)});
  }
  if (!IsQuickEnough()) GTEST_SKIP() << "too many windows";
  for (const double twist : {1e-7, 3e-5}) {
    ExpectStraightRows(
        {absl::StrCat("long, twist ", twist), HyperbolicGrid(250, 4, twist)});
  }
}

// Faces that lie whole in the wedge behind one saddle.
TEST_P(GentleSaddles, SmallFacesBehindOne) {
  for (const double excess : {1e-6, 0.97e-9, 1e-11, 0.9e-13, 1e-14, 1e-15}) {
    ExpectBruteForce({absl::StrCat("cluster behind ", excess),
                      SaddleCluster(excess, 10, 10)},
                     {0, 1, 3, 49});
  }
}

// Distances on a plate with heights of no more than `height` are those in the
// plane, but for the slopes.
TEST_P(GentleSaddles, RandomHeights) {
  for (const double height : {1e-12, 1e-10, 1e-9, 1e-8, 1e-7, 1e-6, 1e-5}) {
    for (const uint64_t seed : {1, 2}) {
      const NamedMesh named{absl::StrCat("heights of ", height),
                            Terrain(24, 24, height, seed)};
      const auto mesh = BuildOrFail(named);
      const std::vector<Point>& p = named.soup.positions;
      for (const uint32_t s : SpreadVertices(named.soup, 3)) {
        const std::vector<double> field = SolveOn(*mesh, {{VertexPoint{s}}});
        for (uint32_t v = 0; v < field.size(); ++v) {
          const double plane = std::hypot(p[v][0] - p[s][0], p[v][1] - p[s][1]);
          // Edges are longer than a half, so that slopes are below 4 heights.
          EXPECT_GE(field[v], plane * (1 - 1e-13));
          EXPECT_LE(field[v], plane * std::hypot(1, 4 * height) * (1 + 1e-13))
              << named.name << ", seed " << seed << ", " << s << " to " << v;
        }
      }
    }
  }
}

// One face wide, so that each vertex lies at the boundary. What bends around
// them is as good as straight, and rounding chooses between the paths.
TEST_P(GentleSaddles, StripsOneFaceWide) {
  const uint32_t columns = IsQuickEnough() ? 600 : 60;
  for (const double height : {1e-9, 1e-6, 5e-6, 1e-5, 3e-5, 1e-3, 0.3}) {
    for (const uint64_t seed : {1, 2}) {
      const NamedMesh named{absl::StrCat("strip, heights of ", height),
                            Strip(columns, height, seed)};
      const auto mesh = BuildOrFail(named);
      for (const uint32_t s : {0u, columns / 2, 2 * columns + 1}) {
        ExpectField(named.name, *mesh, {{VertexPoint{s}}},
                    StripDistances(named.soup, s));
      }
    }
  }
}

// Rounding that chooses anew for every piece of a window made hundreds and
// thousands of windows a face in such strips, and more the longer they are.
TEST(WindowsOfStrips, AreNotCutToPieces) {
  for (const Algorithm algorithm : {Algorithm::kFwpList, Algorithm::kFwpMmp,
                                    Algorithm::kMmp, Algorithm::kLcMmp}) {
    for (const double height : {1e-5, 5e-6}) {
      for (uint64_t seed = 1; seed <= 4; ++seed) {
        const auto mesh = BuildOrFail({"strip", Strip(1923, height, seed)});
        const DistanceField field = SolveOrFail(
            *mesh, {.sources = {{VertexPoint{0}}}, .algorithm = algorithm});
        EXPECT_LT(field.statistics.windows_propagated,
                  100 * uint64_t{mesh->face_count()})
            << AlgorithmName(algorithm) << ", " << height << ", " << seed;
      }
    }
  }
}

TEST_P(GentleSaddles, FilesOfOthers) {
  const absl::StatusOr<TriangleSoup> row =
      LoadTestMesh("flat_saddles/row900.off");
  if (absl::IsNotFound(row.status())) GTEST_SKIP() << row.status();
  ASSERT_TRUE(row.ok()) << row.status();
  if (IsQuickEnough()) ExpectStraightRows({"row900.off", *row});

  const absl::StatusOr<TriangleSoup> cluster =
      LoadTestMesh("flat_saddles/cluster.off");
  ASSERT_TRUE(cluster.ok()) << cluster.status();
  ExpectBruteForce({"cluster.off", *cluster}, {0, 1, 2});
}

GEODESIC_TEST_EVERY_ALGORITHM(GentleSaddles);

}  // namespace
}  // namespace geodesic::test
