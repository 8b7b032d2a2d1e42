// However many threads share a computation, its result is the same to the bit.

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "geodesic/computation.h"
#include "geodesic/solve.h"
#include "tests/support/field_check.h"
#include "tests/support/meshes/curved_meshes.h"
#include "tests/support/meshes/mesh_edits.h"
#include "tests/support/meshes/planar_meshes.h"
#include "tests/support/surface_points.h"

namespace geodesic {
namespace {

// With wavefronts wide enough for threads to share them.
std::vector<test::NamedMesh> WideScenes() {
  TriangleSoup fins = test::Terrain(30, 30, 1, 5);
  // A third face on some edges: windows go on into both others.
  for (uint32_t i = 0; i < 30; ++i) {
    const Triangle face = fins.triangles[60 * i];
    const auto tip = static_cast<uint32_t>(fins.positions.size());
    const Point from = fins.positions[face[0]];
    fins.positions.push_back({from[0], from[1], 9});
    fins.triangles.push_back({face[0], face[1], tip});
  }
  return {
      {"terrain", test::Terrain(60, 60, 2, 3)},
      {"icosphere", test::Icosphere(4)},
      {"grid", test::MakeGrid({.columns = 70, .rows = 60})},
      {"torus with needles",
       test::InsertNeedles(
           test::Torus({.around = 70, .across = 40, .noise = 0.1}), 200, 5)},
      {"turned faces", test::TurnFaces(test::Terrain(40, 40, 1, 4), 6)},
      {"fins", fins}};
}

Query Question(const TriangleSoup& soup) {
  test::Random random(3);
  Query query{.sources = {{VertexPoint{7}}, {VertexPoint{900}, 0.25}},
              .trace = true};
  query.sources.push_back({test::RandomFacePoint(soup, random), 0.5});
  for (int i = 0; i < 40; ++i) {
    query.targets.push_back(test::RandomFacePoint(soup, random));
  }
  return query;
}

bool AreSame(const Arrival& a, const Arrival& b) {
  return a.pseudo_source == b.pseudo_source && a.entry == b.entry &&
         a.x == b.x && a.depth == b.depth;
}

void ExpectSameBits(const DistanceField& field, const DistanceField& expected) {
  EXPECT_EQ(field.distances, expected.distances);
  EXPECT_EQ(field.target_distances, expected.target_distances);
  EXPECT_EQ(field.settled_radius, expected.settled_radius);
  EXPECT_EQ(field.statistics.windows_created,
            expected.statistics.windows_created);
  ASSERT_EQ(field.arrivals.size(), expected.arrivals.size());
  for (size_t v = 0; v < field.arrivals.size(); ++v) {
    ASSERT_TRUE(AreSame(field.arrivals[v], expected.arrivals[v])) << v;
  }
}

TEST(ThreadsTest, AnyNumberGivesTheSameBits) {
  for (const test::NamedMesh& scene : WideScenes()) {
    SCOPED_TRACE(scene.name);
    const auto mesh = test::BuildOrFail(scene);
    const Query query = Question(scene.soup);
    NoCheckpoint checkpoint;
    const auto expected = Solve(*mesh, query, {}, checkpoint);
    ASSERT_TRUE(expected.ok());
    for (const uint32_t threads : {2u, 3u, 8u}) {
      const auto field = Solve(*mesh, query, {.threads = threads}, checkpoint);
      ASSERT_TRUE(field.ok());
      ExpectSameBits(*field, *expected);
    }
  }
}

TEST(ThreadsTest, AComputationThatStopsGoesOnWithItsThreads) {
  const TriangleSoup soup = test::Terrain(50, 50, 1, 3);
  const auto mesh = test::BuildOrFail({"terrain", soup});
  const Query query = Question(soup);
  NoCheckpoint checkpoint;
  std::vector<DistanceField> fields;
  for (const uint32_t threads : {1u, 4u}) {
    auto computation = StartComputation(*mesh, test::Valid(*mesh, query),
                                        {.threads = threads});
    ASSERT_TRUE(computation.ok());
    for (const double radius : {5.0, 12.0, 1e9}) {
      ASSERT_TRUE((*computation)->Advance({.radius = radius}, checkpoint).ok());
      fields.push_back((*computation)->Field());
    }
  }
  for (size_t i = 0; i < 3; ++i) ExpectSameBits(fields[i + 3], fields[i]);
}

TEST(ThreadsTest, NumbersOutOfRangeAreRefused) {
  const auto mesh = test::BuildOrFail({"icosphere", test::Icosphere(0)});
  NoCheckpoint checkpoint;
  for (const uint32_t threads : {0u, kMostSolveThreads + 1}) {
    const auto field = Solve(*mesh, {.sources = {{VertexPoint{0}}}},
                             {.threads = threads}, checkpoint);
    EXPECT_EQ(field.status().code(), absl::StatusCode::kInvalidArgument);
    EXPECT_NE(field.status().message().find("options.threads"),
              std::string::npos);
  }
}

}  // namespace
}  // namespace geodesic
