// Fields with a tolerance: the truth, which the exact solver knows, lies within
// what is certified at every vertex and target.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "geodesic/computation.h"
#include "geodesic/solve.h"
#include "geodesic/valid_query.h"
#include "tests/support/field_check.h"
#include "tests/support/meshes/curved_meshes.h"
#include "tests/support/meshes/mesh_edits.h"
#include "tests/support/meshes/planar_meshes.h"
#include "tests/support/meshes/test_meshes.h"
#include "tests/support/surface_points.h"
#include "tests/support/vec.h"

namespace geodesic::test {
namespace {

constexpr double kTolerances[] = {1e-5, 1e-4, 1e-3, 1e-2, 0.1};

// A few thousand vertices each: smooth, rough, flat, closed and bounded,
// needles.
std::vector<NamedMesh> Scenes() {
  return {
      {"terrain", Terrain(50, 50, 0.6, 3)},
      {"rough terrain", Terrain(40, 40, 3, 4)},
      {"icosphere", Icosphere(4)},
      {"sphere", UvSphere(60, 40)},
      {"torus", Torus({.around = 80, .across = 40})},
      {"noisy torus", Torus({.around = 60, .across = 40, .noise = 0.05})},
      {"long faces", Torus({.around = 200, .across = 12})},
      {"grid", MakeGrid({.columns = 50, .rows = 50})},
      {"jittered bay",
       MakeGrid(UShape({.columns = 40, .rows = 40, .jitter = 0.2}))},
      {"plate", MakePlate(WithHole({.columns = 30, .rows = 30}), 0.3)},
      {"saddle", HyperbolicGrid(40, 40, 0.01)},
      {"needles", InsertNeedles(Terrain(40, 40, 1, 5), 300, 5)},
      {"turned edges", FlipEdges(Torus({.around = 50, .across = 30}), 500, 2)}};
}

Query Question(const TriangleSoup& soup, Random& random) {
  Query query;
  switch (random.Below(3)) {
    case 0:
      query.sources = {{RandomVertexPoint(soup, random)}};
      break;
    case 1:
      query.sources = {{RandomFacePoint(soup, random), 0.5}};
      break;
    default:
      query.sources = {{RandomVertexPoint(soup, random)},
                       {RandomVertexPoint(soup, random), 0.3}};
  }
  query.targets = {RandomVertexPoint(soup, random)};
  for (int i = 0; i < 20; ++i) {
    query.targets.push_back(RandomFacePoint(soup, random));
    query.targets.push_back(RandomEdgePoint(soup, random));
  }
  return query;
}

// Up to the settled radius; beyond it nothing may be there.
void ExpectCertified(const DistanceField& field, double tolerance,
                     const DistanceField& exact) {
  EXPECT_LE(field.certified_error, tolerance);
  std::vector<float> errors = field.certified_errors;
  errors.insert(errors.end(), field.target_certified_errors.begin(),
                field.target_certified_errors.end());
  const std::vector<double> got = AllDistances(field);
  const std::vector<double> truth = AllDistances(exact);
  ASSERT_EQ(got.size(), truth.size());
  // An exact rule runs where faces have no area.
  if (field.algorithm != Algorithm::kFwpList) errors.resize(got.size(), 0);
  ASSERT_EQ(got.size(), errors.size());
  double largest = 0;
  for (size_t i = 0; i < got.size(); ++i) {
    if (std::isinf(got[i])) {
      ASSERT_GE(truth[i] * (1 + tolerance + kRelativeTolerance),
                field.settled_radius)
          << i;
      continue;
    }
    const double error = errors[i];
    ASSERT_LE(std::abs(got[i] - truth[i]),
              std::max(error, kRelativeTolerance) * truth[i])
        << i;
    largest = std::max(largest, error);
  }
  EXPECT_EQ(field.certified_error, largest);
}

void ExpectWithinTheBound(const Mesh& mesh, Query query) {
  const DistanceField exact = SolveOrFail(mesh, query);
  EXPECT_EQ(exact.certified_error, 0);
  EXPECT_TRUE(exact.certified_errors.empty());
  NoCheckpoint checkpoint;
  for (const double tolerance : kTolerances) {
    SCOPED_TRACE(tolerance);
    query.tolerance = tolerance;
    ExpectCertified(Solve(mesh, query, {}, checkpoint).value(), tolerance,
                    exact);
  }
}

TEST(ToleranceTest, TheTruthIsWithinTheBound) {
  Random random(11);
  for (const NamedMesh& scene : Scenes()) {
    SCOPED_TRACE(scene.name);
    ExpectWithinTheBound(*BuildOrFail(scene), Question(scene.soup, random));
  }
}

// What users see is far better than what is certified. (On larger meshes it is
// a tenth, algorithm.md.)
TEST(ToleranceTest, AnswersAreMuchNearerThanTheBound) {
  for (const NamedMesh& scene : Scenes()) {
    SCOPED_TRACE(scene.name);
    const auto mesh = BuildOrFail(scene);
    Query query{.sources = {{VertexPoint{7}}}};
    const std::vector<double> truth = SolveOrFail(*mesh, query).distances;
    for (const double tolerance : {1e-5, 1e-3, 1e-2}) {
      SCOPED_TRACE(tolerance);
      query.tolerance = tolerance;
      NoCheckpoint checkpoint;
      const auto field = Solve(*mesh, query, {}, checkpoint).value();
      double sum = 0;
      size_t count = 0;
      for (size_t v = 0; v < truth.size(); ++v) {
        if (std::isinf(truth[v]) || truth[v] == 0) continue;
        sum += std::abs(field.distances[v] - truth[v]) / truth[v];
        ++count;
      }
      EXPECT_LE(sum / static_cast<double>(count), tolerance / 5);
    }
  }
}

TEST(ToleranceTest, TheTruthIsWithinTheBoundOnRealMeshes) {
  int tried = 0;
  for (const char* name :
       {"real/cgal_elephant.off", "real/cgal_fandisk_large.off",
        "real/cgal_turbine.off", "real/of_propellertip_33k.obj",
        "real/fandisk.obj", "hostile/cgal_elephant-with-holes.off"}) {
    SCOPED_TRACE(name);
    const auto soup = LoadTestMesh(name);
    if (!soup.ok()) continue;
    ++tried;
    ExpectWithinTheBound(*BuildOrFail({name, *soup}),
                         {.sources = {{VertexPoint{1}}}});
  }
  if (tried == 0) GTEST_SKIP() << "no test meshes";
}

TEST(ToleranceTest, WindowsBecomeFewer) {
  const auto mesh =
      BuildOrFail({"torus", Torus({.around = 120, .across = 80})});
  Query query{.sources = {{VertexPoint{0}}}};
  NoCheckpoint checkpoint;
  const uint64_t exact = SolveOrFail(*mesh, query).statistics.windows_created;
  uint64_t last = exact;
  for (const double tolerance : {1e-5, 1e-4, 1e-3}) {
    query.tolerance = tolerance;
    const auto field = Solve(*mesh, query, {}, checkpoint).value();
    EXPECT_LT(field.statistics.windows_created, last);
    last = field.statistics.windows_created;
  }
  EXPECT_LT(last, exact / 3);
}

// From a pole, and from one that is drawn out to a needle, late windows follow
// the wavefront unless those that have passed are known.
TEST(ToleranceTest, WindowsAreNoMoreAroundPoles) {
  NoCheckpoint checkpoint;
  for (const auto& [meridians, bands, length] :
       {std::tuple{20u, 500u, 1.0}, {100u, 10u, 1.0}, {400u, 8u, 1e5}}) {
    SCOPED_TRACE(testing::Message() << meridians << " x " << bands);
    TriangleSoup sphere = UvSphere(meridians, bands);
    for (auto& position : sphere.positions) position[2] *= length;
    const auto mesh = BuildOrFail({"sphere", sphere});
    Query query{.sources = {{VertexPoint{0}}}};
    const uint64_t exact =
        SolveOrFail(*mesh, query).statistics.windows_propagated;
    for (const double tolerance : {1e-5, 1e-3}) {
      query.tolerance = tolerance;
      const auto field = Solve(*mesh, query, {}, checkpoint).value();
      EXPECT_LT(field.statistics.windows_propagated, exact + exact / 10);
    }
  }
}

// Accounts are single numbers, of which none is below 1e-45.
TEST(ToleranceTest, TinyPartsOfAMeshAreWithinTheBound) {
  TriangleSoup soup = MakeGrid({.columns = 12, .rows = 12, .jitter = 0.2});
  for (auto& position : soup.positions) {
    for (double& coordinate : position) coordinate *= 1e-44;
  }
  const auto mesh = BuildOrFail(
      {"tiny", Join(soup, {.positions = {{2, 0, 0}, {3, 0, 0}, {2, 1, 0}},
                           .triangles = {{0, 1, 2}}})});
  Query query{.sources = {{VertexPoint{0}}}};
  const DistanceField exact = SolveOrFail(*mesh, query);
  query.tolerance = 1e-3;
  ExpectCertified(SolveOrFail(*mesh, query), query.tolerance, exact);
}

// Faces are needles in the plane, and the source lies right beside a vertex and
// two millionths of an edge beside another: the straight line is the truth.
TEST(ToleranceTest, NeedlesBesideTheSourceAreWithinTheBound) {
  const TriangleSoup soup = {
      {{0, 0, 0},
       {1, 0, 0},
       {1, 6.2048961140194968e-06, 0},
       {0, 6.2048961140194968e-06, 0},
       {0.125, 1.5512240285048742e-06, 0},
       {0.0014414843063293924, 4.2914933419179671e-08, 0},
       {0.0013170932103056016, 4.3118470809901088e-08, 0},
       {0.625, 5.4292840997670593e-06, 0},
       {0.25, 5.4292840997670593e-06, 0},
       {0.875, 1.5512240285048742e-06, 0},
       {0.25, 1.5512240285048742e-06, 0},
       {0.875, 6.2048961140194968e-06, 0},
       {0.4323415689593616, 5.3954146341633787e-06, 0},
       {0.35735161576907709, 3.0932508636195481e-06, 0},
       {0.6640958719193869, 3.4090172227293444e-06, 0},
       {0.16188755221852907, 4.9945355152010581e-06, 0},
       {0.15979504241526765, 4.9871708604816492e-06, 0},
       {0.75, 7.7561201425243709e-07, 0}},
      {{1, 2, 9},   {2, 7, 13},  {2, 11, 7},  {3, 0, 6},  {0, 1, 17},
       {3, 6, 5},   {0, 5, 6},   {4, 3, 5},   {3, 4, 16}, {5, 2, 4},
       {4, 7, 12},  {7, 3, 8},   {2, 5, 10},  {5, 0, 9},  {5, 9, 10},
       {9, 2, 14},  {11, 3, 7},  {7, 8, 12},  {8, 4, 12}, {7, 4, 13},
       {4, 2, 13},  {2, 10, 14}, {10, 9, 14}, {4, 8, 15}, {8, 3, 15},
       {4, 15, 16}, {15, 3, 16}, {1, 9, 17},  {9, 0, 17}}};
  const auto mesh = BuildOrFail({"needles", soup});
  const SurfacePoint source = EdgePoint{9, 2, 2.4011990274240679e-14};
  for (const double tolerance : {1e-5, 1e-3, 0.1}) {
    const DistanceField field = SolveOrFail(
        *mesh, Query{.sources = {{source}}, .tolerance = tolerance});
    for (uint32_t v = 0; v < mesh->vertex_count(); ++v) {
      const auto truth = static_cast<double>(
          Norm(ToVec3(soup.positions[v]) - PositionIn(soup, source)));
      const double certified =
          field.certified_errors.empty() ? 0 : field.certified_errors[v];
      EXPECT_NEAR(field.distances[v], truth,
                  (certified + 1e-10) * truth + 1e-15)
          << v << " within " << tolerance;
    }
  }
}

TEST(ToleranceTest, SmallOnesAreAnsweredExactly) {
  const auto mesh = BuildOrFail({"terrain", Terrain(20, 20, 0.6, 3)});
  for (const double tolerance : {kLeastTolerance, 9e-6, 1e-5}) {
    const ValidQuery query =
        ValidQuery::Make(
            {.sources = {{VertexPoint{0}}}, .tolerance = tolerance}, *mesh)
            .value();
    EXPECT_EQ(query->tolerance, tolerance < 1e-5 ? 0 : tolerance);
  }
}

// Beyond some point a looser tolerance saves nothing more.
TEST(ToleranceTest, LooseOnesAreCertifiedTighter) {
  const auto mesh = BuildOrFail({"terrain", Terrain(50, 50, 0.6, 3)});
  for (const double tolerance : {0.01, 0.1}) {
    const auto field = Solve(*mesh, Query{.sources = {{VertexPoint{0}}},
                                          .tolerance = tolerance})
                           .value();
    EXPECT_GT(field.certified_error, 0);
    EXPECT_LE(field.certified_error, 2e-3) << tolerance;
  }
}

TEST(ToleranceTest, AnyNumberOfThreadsGivesTheSameBits) {
  Random random(3);
  const TriangleSoup soup = Terrain(70, 70, 0.5, 3);
  const auto mesh = BuildOrFail({"terrain", soup});
  Query query = Question(soup, random);
  query.tolerance = 1e-4;
  NoCheckpoint checkpoint;
  const auto expected = Solve(*mesh, query, {}, checkpoint).value();
  for (const uint32_t threads : {2u, 5u}) {
    const auto field =
        Solve(*mesh, query, {.threads = threads}, checkpoint).value();
    EXPECT_EQ(AllDistances(field), AllDistances(expected));
    EXPECT_EQ(field.certified_errors, expected.certified_errors);
    EXPECT_EQ(field.target_certified_errors, expected.target_certified_errors);
  }
}

// Stops every third poll.
class Impatient final : public Checkpoint {
 public:
  absl::Status Poll(const Progress& progress) override {
    EXPECT_GE(progress.settled_radius, radius_);
    radius_ = progress.settled_radius;
    return ++polls_ % 3 == 0 ? absl::CancelledError("stop") : absl::OkStatus();
  }
  double radius() const { return radius_; }

 private:
  double radius_ = 0;
  uint64_t polls_ = 0;
};

TEST(ToleranceTest, WhatStopsEarlyIsCertifiedUpToWhereItStopped) {
  Random random(13);
  for (const NamedMesh& scene : Scenes()) {
    SCOPED_TRACE(scene.name);
    const auto mesh = BuildOrFail(scene);
    Query query = Question(scene.soup, random);
    const DistanceField exact = SolveOrFail(*mesh, query);
    query.tolerance = std::pow(10, random.Uniform(-5, -1));
    const auto computation =
        StartComputation(*mesh, Valid(*mesh, query), {}).value();
    NoCheckpoint patient;
    const double radius = FarthestOf(exact.distances) * random.Uniform(0.1, 1);
    ASSERT_TRUE(computation->Advance({.radius = radius}, patient).ok());
    EXPECT_GE(computation->Field().settled_radius, radius);
    ExpectCertified(computation->Field(), query.tolerance, exact);
    Impatient checkpoint;
    while (!computation->Advance({}, checkpoint).ok()) {
      const DistanceField field = computation->Field();
      EXPECT_GE(field.settled_radius, checkpoint.radius());
      ExpectCertified(field, query.tolerance, exact);
    }
    EXPECT_TRUE(std::isinf(computation->Field().settled_radius));
    ExpectCertified(computation->Field(), query.tolerance, exact);
  }
}

TEST(ToleranceTest, NothingIsGivenBeyondARadius) {
  Random random(14);
  const TriangleSoup soup = Terrain(14, 14, 0.3, /*seed=*/5);
  const auto mesh = BuildOrFail({"grid", soup});
  size_t given = 0;
  for (int i = 0; i < 60; ++i) {
    Query query{.sources = {{RandomFacePoint(soup, random)}},
                .targets = {RandomFacePoint(soup, random)}};
    const DistanceField exact = SolveOrFail(*mesh, query);
    query.tolerance = std::pow(10, random.Uniform(-4, -1));
    const std::unique_ptr<Computation> computation =
        *StartComputation(*mesh, Valid(*mesh, query), {});
    NoCheckpoint checkpoint;
    std::vector<double> radii = exact.distances;
    std::ranges::sort(radii);
    // All but at a distance each, where that and what is given part.
    for (size_t v = 0; v < radii.size(); v += 10) {
      const double radius = radii[v] * (1 + query.tolerance / 4);
      ASSERT_TRUE(computation->Advance({.radius = radius}, checkpoint).ok());
      const DistanceField field = computation->Field();
      for (const double distance : AllDistances(field)) {
        if (std::isinf(distance) || std::isinf(field.settled_radius)) continue;
        ASSERT_LE(distance, radius);
        ++given;
      }
      double largest = 0;
      for (size_t w = 0; w < field.distances.size(); ++w) {
        if (std::isinf(field.distances[w])) {
          ASSERT_EQ(field.certified_errors[w], 0) << w;
        }
        largest = std::max<double>(largest, field.certified_errors[w]);
      }
      ASSERT_EQ(field.certified_error,
                std::max<double>(largest, field.target_certified_errors[0]));
      ExpectCertified(field, query.tolerance, exact);
    }
  }
  EXPECT_GT(given, 0);
}

TEST(ToleranceTest, TargetsAreCertifiedWhenASearchStopsAtThem) {
  Random random(17);
  const TriangleSoup soup = Torus({.around = 80, .across = 50});
  const auto mesh = BuildOrFail({"torus", soup});
  for (int i = 0; i < 10; ++i) {
    Query query{.sources = {{RandomVertexPoint(soup, random)}},
                .targets = {RandomFacePoint(soup, random),
                            RandomFacePoint(soup, random)}};
    const DistanceField exact = SolveOrFail(*mesh, query);
    query.tolerance = 1e-3;
    const auto computation =
        StartComputation(*mesh, Valid(*mesh, query), {}).value();
    NoCheckpoint checkpoint;
    ASSERT_TRUE(computation->Advance({.targets = 1}, checkpoint).ok());
    const DistanceField field = computation->Field();
    EXPECT_TRUE(std::isfinite(
        std::min(field.target_distances[0], field.target_distances[1])));
    ExpectCertified(field, query.tolerance, exact);
  }
}

TEST(ToleranceTest, SourcesCanBeAdded) {
  Random random(19);
  const TriangleSoup soup = Terrain(40, 40, 1, 8);
  const auto mesh = BuildOrFail({"terrain", soup});
  Query query{.sources = {{VertexPoint{7}}}, .tolerance = 1e-3};
  const auto computation =
      StartComputation(*mesh, Valid(*mesh, query), {}).value();
  NoCheckpoint checkpoint;
  for (const uint32_t v : {1200u, 40u, 800u}) {
    ASSERT_TRUE(computation->Advance({}, checkpoint).ok());
    query.sources.push_back({VertexPoint{v}});
    ASSERT_TRUE(computation->AddSource(query.sources.back()).ok());
  }
  ASSERT_TRUE(computation->Advance({}, checkpoint).ok());
  query.tolerance = 0;
  ExpectCertified(computation->Field(), 1e-3, SolveOrFail(*mesh, query));
}

TEST(ToleranceTest, WhatCannotMergeIsExact) {
  const TriangleSoup soup = Terrain(12, 12, 1, 8);
  const auto mesh = BuildOrFail({"terrain", soup});
  const Query plain{.sources = {{VertexPoint{7}}}};
  Query traced = plain;
  traced.trace = true;
  Query by_mmp = plain;
  by_mmp.algorithm = Algorithm::kMmp;
  Query from_curve = plain;
  from_curve.sources = {{Curve{{VertexPoint{7}, VertexPoint{8}}}}};
  for (Query query : {traced, by_mmp, from_curve}) {
    const DistanceField exact = SolveOrFail(*mesh, query);
    query.tolerance = 0.1;
    EXPECT_EQ(Valid(*mesh, query)->tolerance, 0);
    NoCheckpoint checkpoint;
    const auto field = Solve(*mesh, query, {}, checkpoint).value();
    EXPECT_EQ(field.distances, exact.distances);
    EXPECT_EQ(field.certified_error, 0);
  }
}

TEST(ToleranceTest, TolerancesOutOfRangeAreRefused) {
  const auto mesh = BuildOrFail({"icosphere", Icosphere(0)});
  for (const double tolerance : {-1e-3, 1e-10, 0.2, std::nan("")}) {
    const auto query = ValidQuery::Make(
        {.sources = {{VertexPoint{0}}}, .tolerance = tolerance}, *mesh);
    EXPECT_EQ(query.status().code(), absl::StatusCode::kInvalidArgument);
    EXPECT_NE(query.status().message().find("tolerance"), std::string::npos);
  }
}

}  // namespace
}  // namespace geodesic::test
