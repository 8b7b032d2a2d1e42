// Around a vertex whose faces have hardly any angle a straight line goes round
// and round. Its windows come to the same edges in every turn, and are to end
// all the same, in fields, within a tolerance, and in searches, though a turn
// there may be less than a rounding.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <numbers>
#include <variant>
#include <vector>

#include "geodesic/mesh.h"
#include "geodesic/solve.h"
#include "geodesic/target_search.h"
#include "geodesic/triangle_soup.h"
#include "geodesic/valid_query.h"
#include "tests/support/checkpoints.h"
#include "tests/support/field_check.h"
#include "tests/support/meshes/mesh_edits.h"
#include "tests/support/meshes/planar_meshes.h"
#include "tests/support/queries.h"
#include "tests/support/random.h"
#include "tests/support/surface_points.h"
#include "tests/support/vec.h"

namespace geodesic {
namespace {

constexpr uint32_t kFans = 12;
constexpr uint32_t kFaces = 6;   // of each
constexpr double kAngle = 1e-6;  // of each of these at the tip

double Radius(uint32_t k) { return 1 + 0.1 * k; }

// Faces around vertex 0, folded onto each other.
TriangleSoup FoldedFan() {
  TriangleSoup fan{.positions = {{0, 0, 0}}};
  for (uint32_t k = 0; k < kFaces; ++k) {
    const double angle = k % 2 == 0 ? 0 : kAngle;
    fan.positions.push_back(
        {Radius(k) * std::cos(angle), Radius(k) * std::sin(angle), 0});
    fan.triangles.push_back({0, k + 1, (k + 1) % kFaces + 1});
  }
  return fan;
}

// Fans, then a grid so large that what passes is kept at few half-edges.
std::shared_ptr<const Mesh> FansAndGrid() {
  TriangleSoup soup = FoldedFan();
  for (uint32_t i = 1; i < kFans; ++i) soup = test::Join(soup, FoldedFan());
  return test::BuildOrFail(
      {"fans", test::Join(soup, test::MakeGrid({.columns = 70, .rows = 70}))});
}

// Far above what any question here takes.
constexpr uint64_t kMostWindows = 100'000;

// In a fan's first face, `away` from the tip, three tenths from its first side.
FacePoint NearTip(uint32_t fan, double away) {
  return {.face = kFaces * fan, .weights = {1 - away, 0.7 * away, 0.3 * away}};
}

// By the law of cosines, whichever way around the tip is shorter.
double FromTip(double away, uint32_t k) {
  const double x = 0.7 * away * Radius(0) + 0.3 * away * Radius(1);
  const double from_first = 0.3 * Radius(1) * away * kAngle / x;
  const double forward = std::abs(k * kAngle - from_first);
  const double angle = std::min(forward, kFaces * kAngle - forward);
  const double r = Radius(k);
  const double across = 2 * std::sin(angle / 2);
  return std::sqrt((r - x) * (r - x) + r * x * across * across);
}

class WindingWindows : public testing::TestWithParam<double> {};

TEST_P(WindingWindows, EndInFields) {
  const auto mesh = FansAndGrid();
  for (const double tolerance : {0.0, 1e-5, 1e-2}) {
    for (uint32_t fan = 0; fan < kFans; ++fan) {
      SCOPED_TRACE(testing::Message() << fan << " within " << tolerance);
      test::WindowLimit limit(kMostWindows);
      const auto field = Solve(*mesh,
                               Query{.sources = {{NearTip(fan, GetParam())}},
                                     .tolerance = tolerance},
                               {}, limit);
      ASSERT_TRUE(field.ok()) << field.status();
      for (uint32_t k = 0; k < kFaces; ++k) {
        const double expected = FromTip(GetParam(), k);
        EXPECT_NEAR(field->distances[(kFaces + 1) * fan + 1 + k], expected,
                    std::max(tolerance, 1e-12) * expected)
            << k;
      }
    }
  }
}

TEST_P(WindingWindows, EndInSearches) {
  const auto mesh = FansAndGrid();
  TargetSearch search(*mesh);
  // Twice: a search leaves nothing behind for the next one.
  for (const uint32_t round : {1, 2}) {
    for (uint32_t k = 0; k < kFaces; ++k) {
      SCOPED_TRACE(testing::Message() << round << ", " << k);
      test::WindowLimit limit(kMostWindows);
      const auto found = search.Run(
          test::Valid(
              *mesh, Query{.sources = {{NearTip(3, GetParam())}},
                           .targets = {VertexPoint{(kFaces + 1) * 3 + 1 + k}}}),
          nullptr, limit);
      ASSERT_TRUE(found.ok()) << found.status();
      const double expected = FromTip(GetParam(), k);
      EXPECT_NEAR(found->distances[0], expected, 1e-12 * expected);
    }
  }
}

// A flat tube of needles, along the x axis.
TriangleSoup ThinTube(test::Random& random) {
  constexpr uint32_t kRings = 72;
  const double width = std::pow(10, random.Uniform(-8, -5));
  const double noise = std::pow(10, random.Uniform(-8, -3));
  const double height = random.Below(2) * width * random.Uniform(0, 0.1);
  TriangleSoup tube;
  for (uint32_t i = 0; i < kRings; ++i) {
    const auto x = static_cast<double>(i);
    const double beside = random.Uniform(-noise, noise);
    tube.positions.push_back({x, 0, 0});
    tube.positions.push_back(
        {x, width * (1 + beside), random.Below(2) * width * beside});
    tube.positions.push_back({x, width / 2, height});
    if (i == 0) continue;
    for (uint32_t side = 0; side < 3; ++side) {
      const uint32_t a = 3 * i - 3 + side, b = 3 * i - 3 + (side + 1) % 3;
      tube.triangles.push_back({a, a + 3, b + 3});
      tube.triangles.push_back({a, b + 3, b});
    }
  }
  return tube;
}

// Merged windows have no line to follow: where they wind, as on the last three
// of these tubes, the answer is exact.
TEST(ThinTubes, EndWithinTolerances) {
  int exact = 0;
  for (const uint64_t seed : {0, 1, 2, 63, 325, 1981}) {
    test::Random random(seed);
    const auto mesh = test::BuildOrFail({"tube", ThinTube(random)});
    const Query query{.sources = {{VertexPoint{0}}}};
    const DistanceField expected = test::SolveOrFail(*mesh, query);
    Query merged = query;
    merged.tolerance = 1e-3;
    test::WindowLimit limit(1'000'000);
    const auto field = Solve(*mesh, merged, {}, limit);
    ASSERT_TRUE(field.ok()) << field.status() << ", seed " << seed;
    exact += field->certified_error == 0;
    for (uint32_t v = 0; v < mesh->vertex_count(); ++v) {
      EXPECT_NEAR(field->distances[v], expected.distances[v],
                  1e-3 * expected.distances[v])
          << seed << ", vertex " << v;
    }
  }
  EXPECT_GT(exact, 0);
}

// Needles that are there twice, glued at their long sides: around their tip
// there is no angle at all. Lines that go round there cross edges that no
// orientation fits, or edges of three faces, where a window does not tell which
// way it came.
TEST(DoubledNeedles, EndWindingWindows) {
  // The last face is one too many: no distance depends on it.
  const std::vector<Triangle> others = {{3, 2, 1}, {1, 3, 0}, {2, 1, 4},
                                        {3, 0, 4}, {3, 2, 4}, {0, 4, 1},
                                        {3, 2, 1}};
  const test::NamedMesh meshes[] = {
      {"turned over",
       {{{-1.7194217783051078, -3.8157623211173126, 0.6953751915559806},
         {-1.0028802921077675, -1.721816939244911, 1.0146827665767766},
         {-1.7194217800301821, -3.815762320441797, 0.6953751909972552},
         {-0.14340122962592378, -0.82202539314452661, -0.55109921100230186}},
        {{0, 1, 2}, {3, 0, 2}, {2, 0, 1}}}},
      {"among others",
       {{{-2.7269862378811895, 1.2452284596431513, 0.11380747647382454},
         {-1.1171903691747098, 2.25358000894279, 1.2935466061633369},
         {-0.55859518465861246, 1.1267900042924819, 0.64677330333182337},
         {-1.1171903690321947, 2.2535800093006166, 1.2935466055630274},
         {-1.0941775091554562, 2.253625125425518, 1.3001341708691825}},
        others}}};
  for (const test::NamedMesh& named : meshes) {
    const auto doubled = test::BuildOrFail(named);
    test::NamedMesh single = named;
    single.soup.triangles.pop_back();
    const auto mesh = test::BuildOrFail(single);
    for (uint32_t source = 0; source < mesh->vertex_count(); ++source) {
      Query query{.sources = {{VertexPoint{source}}}};
      const DistanceField expected = test::SolveOrFail(*mesh, query);
      for (const Algorithm algorithm :
           {Algorithm::kFwpList, Algorithm::kFwpMmp, Algorithm::kLcMmp}) {
        for (const double tolerance : {0.0, 1e-3}) {
          SCOPED_TRACE(testing::Message()
                       << named.name << " from " << source << " by "
                       << AlgorithmName(algorithm) << " within " << tolerance);
          query.algorithm = algorithm;
          query.tolerance = tolerance;
          test::WindowLimit limit(kMostWindows);
          const auto field = Solve(*doubled, query, {}, limit);
          ASSERT_TRUE(field.ok()) << field.status();
          for (uint32_t v = 0; v < mesh->vertex_count(); ++v) {
            EXPECT_NEAR(field->distances[v], expected.distances[v],
                        std::max(tolerance, 1e-10) * expected.distances[v])
                << v;
          }
        }
      }
    }
  }
}

// Where half-edges are crossed often since sources are many, nothing winds.
TEST(ManySources, KeepTheirWindows) {
  constexpr int kSources = 6000;
  const TriangleSoup soup = test::MakeGrid({.columns = 2, .rows = 1});
  const auto mesh = test::BuildOrFail({"strip", soup});
  Query query;
  for (int i = 0; i < kSources; ++i) {
    const double t = (i + 0.5) / kSources;
    query.sources.push_back(
        {FacePoint{.face = 0, .weights = {0.1, 0.9 * t, 0.9 * (1 - t)}}});
  }
  for (const Algorithm algorithm : {Algorithm::kFwpList, Algorithm::kFwpMmp,
                                    Algorithm::kMmp, Algorithm::kLcMmp}) {
    query.algorithm = algorithm;
    const DistanceField field = test::SolveOrFail(*mesh, query);
    for (uint32_t v = 0; v < mesh->vertex_count(); ++v) {
      test::Real expected = std::numeric_limits<double>::infinity();
      for (const Source& source : query.sources) {
        expected = std::min(
            expected,
            Norm(test::ToVec3(soup.positions[v]) -
                 test::PositionIn(soup, std::get<SurfacePoint>(source.place))));
      }
      EXPECT_NEAR(field.distances[v], expected, 1e-12)
          << AlgorithmName(algorithm) << ", vertex " << v;
    }
  }
}

// From the rim of a cone so slender that a straight line past its tip goes
// round a million times.
TEST(SlenderCones, EndWindingWindows) {
  for (const uint32_t sides : {5u, 16u, 40u}) {
    for (const double slope : {1e3, 1e5, 3e6, 1e7, 3e7, 1e9, 1e11}) {
      TriangleSoup cone{.positions = {{0, 0, 0}}};
      for (uint32_t k = 0; k < sides; ++k) {
        const double angle = 2 * std::numbers::pi * k / sides;
        cone.positions.push_back({std::cos(angle), std::sin(angle), slope});
        cone.triangles.push_back({0, k + 1, (k + 1) % sides + 1});
      }
      const auto mesh = test::BuildOrFail({"cone", cone});
      for (const double tolerance : {0.0, 1e-3}) {
        SCOPED_TRACE(testing::Message() << sides << " sides, slope " << slope
                                        << ", within " << tolerance);
        test::WindowLimit limit(kMostWindows);
        const auto field = Solve(
            *mesh, Query{.sources = {{VertexPoint{2}}}, .tolerance = tolerance},
            {}, limit);
        ASSERT_TRUE(field.ok()) << field.status();
        // Laid into the plane, the rim lies on a circle around the tip.
        const double radius = std::hypot(1, slope);
        const double chord = 2 * std::sin(std::numbers::pi / sides);
        const double face = 2 * std::asin(chord / 2 / radius);
        for (uint32_t k = 0; k < sides; ++k) {
          const uint32_t away = k > 1 ? k - 1 : 1 - k;
          const double angle = face * std::min(away, sides - away);
          const double expected = 2 * radius * std::sin(angle / 2);
          EXPECT_NEAR(field->distances[k + 1], expected,
                      std::max(tolerance, 1e-10) * expected)
              << k;
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(AwayFromTheTip, WindingWindows,
                         testing::Values(1e-16, 1e-15, 1e-14, 1e-13, 1e-12,
                                         1e-11, 1e-10, 1e-8, 1e-6, 1e-4, 0.01,
                                         0.3));

}  // namespace
}  // namespace geodesic
