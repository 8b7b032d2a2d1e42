// The heat method against the exact solver, against itself on other meshes of
// the same surface, and its systems' edges.

#include "geodesic/approximate/heat_method.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "absl/status/status.h"
#include "absl/strings/match.h"
#include "geodesic_types/field_path.h"
#include "tests/core/approximate/method_check.h"
#include "tests/support/checkpoints.h"
#include "tests/support/meshes/curved_meshes.h"
#include "tests/support/meshes/mesh_edits.h"
#include "tests/support/meshes/planar_meshes.h"

namespace geodesic::test {
namespace {

std::vector<double> Field(const Mesh& mesh, const std::vector<Source>& sources,
                          const HeatOptions& options = {}) {
  return AskOrFail(
      *PrepareOrFail(mesh, ApproximateMethod::kHeat, {.heat = options}), mesh,
      sources);
}

absl::Status StatusOf(const Mesh& mesh, const Query& query,
                      const HeatOptions& options = {}) {
  NoCheckpoint checkpoint;
  const auto heat = HeatMethod::Prepare(mesh, options, checkpoint);
  if (!heat.ok()) return heat.status();
  return (*heat)->Distances(Valid(mesh, query), checkpoint).status();
}

double MeanError(const TriangleSoup& soup, const HeatOptions& options,
                 uint32_t source = 0) {
  const auto mesh = BuildOrFail({"surface", soup});
  const std::vector<Source> sources = {{VertexPoint{source}}};
  return CompareWithExact(*mesh, sources, Field(*mesh, sources, options)).mean;
}

void ExpectNear(const std::vector<double>& got,
                const std::vector<double>& expected, double relative) {
  ASSERT_EQ(got.size(), expected.size());
  const double farthest = FarthestOf(expected);
  for (size_t v = 0; v < got.size(); ++v) {
    ASSERT_NEAR(got[v], expected[v], relative * farthest) << "vertex " << v;
  }
}

// What two factorizations of nearly equal matrices may differ by.
constexpr double kSolverRounding = 1e-9;

TEST(HeatMethod, ErrorsShrinkWithTheEdges) {
  double before = 1;
  for (uint32_t levels = 3; levels <= 6; ++levels) {
    const double error = MeanError(Icosphere(levels), {});
    EXPECT_LE(error, 0.75 * before) << levels;
    before = error;
  }
  EXPECT_LE(before, 0.006);
}

// One constant cannot take several sources to 0, least of all near a boundary.
TEST(HeatMethod, SeveralSourcesArePinned) {
  const auto mesh = BuildOrFail(
      {"plane",
       MakeGrid({.columns = 50, .rows = 40, .diagonals = Diagonals::kRandom})});
  // A corner, its neighbour on the boundary, and two inside.
  const std::vector<Source> sources = {{VertexPoint{0}},
                                       {VertexPoint{3}},
                                       {VertexPoint{1000}},
                                       {VertexPoint{1530}}};
  const std::vector<double> field = Field(*mesh, sources);
  for (const Source& source : sources) {
    EXPECT_EQ(field[std::get<VertexPoint>(PointOf(source)).vertex], 0);
  }
  EXPECT_LE(CompareWithExact(*mesh, sources, field).mean, 0.06);
  const std::vector<Source> places = {
      {FacePoint{100, {0.5, 0.3, 0.2}}},
      {EdgePoint{mesh->triangle(3000)[0], mesh->triangle(3000)[1], 0.5}}};
  EXPECT_LE(CompareWithExact(*mesh, places, Field(*mesh, places)).mean, 0.06);
}

// A component's distances do not depend on what happens on others, also where
// one of them makes the system that all share another one.
TEST(HeatMethod, ComponentsDoNotMix) {
  const TriangleSoup torus = Torus({.noise = 0.02}), sphere = Icosphere(3);
  const auto alone = BuildOrFail({"torus", torus});
  const auto joined = BuildOrFail({"torus and sphere", Join(torus, sphere)});
  const uint32_t first = alone->vertex_count();
  const std::vector<double> expected = Field(*alone, {{VertexPoint{5}}});
  // The mean edge of both together sets the time.
  const double longer =
      joined->mean_edge_length() / alone->mean_edge_length() *
      std::ldexp(1, joined->scale_exponent() - alone->scale_exponent());
  const HeatOptions options{.lambda = 1 / (longer * longer)};
  for (const std::vector<Source>& sources :
       {std::vector<Source>{{VertexPoint{5}}, {VertexPoint{first + 1}}},
        {{VertexPoint{5}},
         {VertexPoint{first + 1}},
         {VertexPoint{first + 9}}}}) {
    std::vector<double> got = Field(*joined, sources, options);
    got.resize(first);
    ExpectNear(got, expected, kSolverRounding);
  }
}

// Turned faces make edges irregular; the surface's tufted cover is then two
// copies of it.
TEST(HeatMethod, TheTuftedCoverOfASurfaceGivesItsDistances) {
  for (const TriangleSoup& soup :
       {Icosphere(3), Torus({.around = 40, .across = 12, .noise = 0.1})}) {
    const auto mesh = BuildOrFail({"surface", soup});
    const auto turned = BuildOrFail({"turned faces", TurnFaces(soup, 7)});
    ASSERT_TRUE(turned->HasIrregularEdges());
    for (const std::vector<Source>& sources :
         {std::vector<Source>{{VertexPoint{2}}},
          {{VertexPoint{2}}, {VertexPoint{77}}}}) {
      ExpectNear(Field(*turned, sources), Field(*mesh, sources),
                 kSolverRounding);
    }
  }
}

// From a vertex of the spine, where three pages meet.
TEST(HeatMethod, CrossesEdgesOfManyFaces) {
  const NamedMesh named{"book",
                        Book(MakeGrid({.columns = 20,
                                       .rows = 20,
                                       .diagonals = Diagonals::kAlternating}),
                             3)};
  const auto mesh = BuildOrFail(named);
  ASSERT_TRUE(mesh->HasNonManifoldEdges());
  const std::vector<Source> sources = {{VertexPoint{10}}};
  EXPECT_LE(CompareWithExact(*mesh, sources, Field(*mesh, sources)).mean, 0.05);
}

TEST(HeatMethod, IntrinsicDelaunayEdgesMendNeedles) {
  const TriangleSoup needles =
      InsertNeedles(Torus({.around = 60, .across = 40}), 600, 3);
  const double turned = MeanError(needles, {});
  EXPECT_LE(turned, 0.06);
  // Edges of even faces are Delaunay edges: the option changes nothing.
  const auto mesh = BuildOrFail({"icosphere", Icosphere(3)});
  EXPECT_EQ(Field(*mesh, {{VertexPoint{1}}}),
            Field(*mesh, {{VertexPoint{1}}}, {.intrinsic_delaunay = false}));
}

// The paper's figure 14: faces of unequal edges want more time.
TEST(HeatMethod, UnequalEdgesWantALargerLambda) {
  const TriangleSoup sphere = UvSphere(60, 150);
  const uint32_t source = 75 * 60;
  const double short_time = MeanError(sphere, {.lambda = 1}, source);
  const double long_time = MeanError(sphere, {.lambda = 30}, source);
  EXPECT_LE(long_time, short_time / 2);
  EXPECT_LE(long_time, 0.02);
}

TEST(HeatMethod, RefusesOffsetsAndTimesByName) {
  const auto mesh = BuildOrFail({"sphere", Icosphere(1)});
  const absl::Status offset =
      StatusOf(*mesh, {.sources = {{VertexPoint{0}}, {VertexPoint{1}, 0.5}}});
  EXPECT_TRUE(absl::IsInvalidArgument(offset)) << offset;
  EXPECT_EQ(FieldPathOf(offset), "sources[1].offset");
  for (const double lambda :
       {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    const absl::Status status =
        StatusOf(*mesh, {.sources = {{VertexPoint{0}}}}, {.lambda = lambda});
    EXPECT_TRUE(absl::IsInvalidArgument(status)) << status;
    EXPECT_TRUE(absl::StrContains(std::string(status.message()), "lambda"));
  }
}

// Heat falls by a factor of e in every edge or so: a double holds it for some
// 1,300. What lies beyond must not look near.
TEST(HeatMethod, SaysWhereHeatVanishes) {
  const auto mesh =
      BuildOrFail({"strip", MakeGrid({.columns = 3000, .rows = 1})});
  const Query query{.sources = {{VertexPoint{0}}}};
  const absl::Status status = StatusOf(*mesh, query);
  EXPECT_TRUE(absl::IsFailedPrecondition(status)) << status;
  EXPECT_TRUE(absl::StrContains(std::string(status.message()),
                                "a larger lambda reaches farther"));
  EXPECT_TRUE(StatusOf(*mesh, query, {.lambda = 10}).ok());
}

TEST(HeatMethod, CountsItsBytes) {
  const auto small = BuildOrFail({"sphere", Icosphere(3)});
  const auto large = BuildOrFail({"sphere", Icosphere(5)});
  NoCheckpoint checkpoint;
  const auto of_small = HeatMethod::Prepare(*small, {}, checkpoint);
  const auto of_large = HeatMethod::Prepare(*large, {}, checkpoint);
  // Sixteen times the faces, and factors that fill up.
  EXPECT_GT((*of_large)->bytes(), 16 * (*of_small)->bytes());
  EXPECT_LT((*of_large)->bytes(), 64 * (*of_small)->bytes());
}

TEST(HeatMethod, IsAskedWhileItFactorizesAndTellsOfBytesBefore) {
  const auto mesh = BuildOrFail({"sphere", Icosphere(5)});
  RecordingCheckpoint checkpoint;
  const auto prepared = HeatMethod::Prepare(*mesh, {}, checkpoint);
  ASSERT_TRUE(prepared.ok());
  const auto knows_all = [&](const Progress& progress) {
    return progress.solver_bytes >= (*prepared)->bytes();
  };
  const auto second = std::ranges::find_if(checkpoint.polls(), knows_all) -
                      checkpoint.polls().begin();
  // Two factorizations, a few rows at a time.
  const auto most_rows = 16;
  EXPECT_GE(second, mesh->vertex_count() / most_rows);
  EXPECT_GE(std::ssize(checkpoint.polls()) - second,
            mesh->vertex_count() / most_rows);
}

}  // namespace
}  // namespace geodesic::test
