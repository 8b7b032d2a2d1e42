#include "tests/core/solver/computation_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "geodesic/solve.h"
#include "tests/support/curved_meshes.h"
#include "tests/support/field_check.h"
#include "tests/support/mesh_edits.h"
#include "tests/support/planar_meshes.h"
#include "tests/support/surface_points.h"

namespace geodesic::test {
namespace {

// A certified distance may improve by roundings, no more.
constexpr double kRoundings = 1e-12;

ComputationScene MakeScene(std::string name, const TriangleSoup& soup,
                           Query query) {
  Random random(7);
  query.targets.push_back(RandomVertexPoint(soup, random));
  for (int i = 0; i < 4; ++i) {
    query.targets.push_back(RandomEdgePoint(soup, random));
    query.targets.push_back(RandomFacePoint(soup, random));
  }
  std::shared_ptr<const Mesh> mesh = BuildOrFail({name, soup});
  return {std::move(name), std::move(mesh), std::move(query)};
}

}  // namespace

std::vector<ComputationScene> ComputationScenes() {
  const TriangleSoup grid = MakeGrid({.columns = 14, .rows = 12});
  const TriangleSoup sphere = Icosphere(2);
  const TriangleSoup needles =
      InsertNeedles(Torus({.around = 16, .across = 10, .noise = 0.1}), 30, 5);
  const TriangleSoup bay = MakeGrid(UShape({.columns = 12, .rows = 12}));
  const TriangleSoup pieces =
      AddIsolatedVertices(Join(Terrain(10, 10, 1.5, 3), Icosphere(1)), 2);
  Random random(11);
  std::vector<ComputationScene> scenes;
  // Every distance from a corner occurs twice or more.
  scenes.push_back(MakeScene("grid", grid, {.sources = {{VertexPoint{0}}}}));
  scenes.push_back(
      MakeScene("icosphere", sphere,
                {.sources = {{FacePoint{3, {0.25, 0.25, 0.5}}, 0.125}}}));
  scenes.push_back(
      MakeScene("torus with needles", needles,
                {.sources = {{VertexPoint{9}, 0.25},
                             {RandomEdgePoint(needles, random)},
                             {Curve{RandomCurve(needles, 4, random)}}}}));
  scenes.push_back(
      MakeScene("U", bay,
                {.sources = {{Curve{RandomCurve(bay, 5, random)}, 0.5},
                             {Curve{RandomCurve(bay, 3, random)}}}}));
  scenes.push_back(MakeScene("pieces", pieces,
                             {.sources = {{VertexPoint{17}},
                                          {RandomFacePoint(pieces, random)},
                                          {VertexPoint{60}, 1}}}));
  return scenes;
}

std::unique_ptr<Computation> StartOrFail(const Mesh& mesh, const Query& query) {
  absl::StatusOr<std::unique_ptr<Computation>> started =
      StartComputation(mesh, Valid(mesh, query), {});
  if (started.ok()) return *std::move(started);
  ADD_FAILURE() << started.status().ToString();
  return nullptr;
}

DistanceField WholeField(const Mesh& mesh, const Query& query) {
  NoCheckpoint checkpoint;
  absl::StatusOr<DistanceField> field = Solve(mesh, query, {}, checkpoint);
  if (field.ok()) return *std::move(field);
  ADD_FAILURE() << field.status().ToString();
  return {};
}

std::vector<double> AllDistances(const DistanceField& field) {
  std::vector<double> all = field.distances;
  all.insert(all.end(), field.target_distances.begin(),
             field.target_distances.end());
  return all;
}

double Farthest(const DistanceField& field) {
  double farthest = 0;
  for (const double d : AllDistances(field)) {
    if (std::isfinite(d)) farthest = std::max(farthest, d);
  }
  return farthest;
}

void ExpectCertified(const std::string& context, const DistanceField& field,
                     const DistanceField& whole) {
  const std::vector<double> got = AllDistances(field);
  const std::vector<double> expected = AllDistances(whole);
  ASSERT_EQ(got.size(), expected.size()) << context;
  const double radius = field.settled_radius;
  for (size_t i = 0; i < got.size(); ++i) {
    if (expected[i] > radius * (1 + kRoundings) || std::isinf(expected[i])) {
      EXPECT_EQ(got[i], std::numeric_limits<double>::infinity())
          << context << ": " << i << " is at " << expected[i] << ", beyond "
          << radius;
    } else if (expected[i] < radius * (1 - kRoundings) ||
               std::isfinite(got[i])) {
      EXPECT_NEAR(got[i], expected[i], kRoundings * expected[i])
          << context << ": " << i << ", settled radius " << radius;
    }
  }
}

}  // namespace geodesic::test
