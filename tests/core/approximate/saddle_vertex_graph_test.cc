// The saddle vertex graph: its arcs against the exact solver's traces, its
// fields against the exact ones, its pairs against its fields.

#include "geodesic/approximate/saddle_vertex_graph.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <numeric>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/strings/match.h"
#include "tests/core/approximate/method_check.h"
#include "tests/support/checkpoints.h"
#include "tests/support/meshes/crowded_meshes.h"
#include "tests/support/meshes/curved_meshes.h"
#include "tests/support/meshes/mesh_edits.h"
#include "tests/support/meshes/planar_meshes.h"
#include "tests/support/random.h"

namespace geodesic::test {
namespace {

// Arcs are in single precision; a way has some.
constexpr double kArcTolerance = 1e-6;

std::shared_ptr<const SaddleVertexGraph> GraphOrFail(
    const Mesh& mesh, const SaddleGraphOptions& options) {
  NoCheckpoint checkpoint;
  return SaddleVertexGraph::Prepare(mesh, options, checkpoint).value();
}

absl::Status StatusOf(const Mesh& mesh, const SaddleGraphOptions& options) {
  NoCheckpoint checkpoint;
  return SaddleVertexGraph::Prepare(mesh, options, checkpoint).status();
}

double ToFile(const Mesh& mesh, double length) {
  return std::ldexp(length, mesh.scale_exponent());
}

std::map<uint32_t, double> ArcsAt(const SaddleVertexGraph& graph, uint32_t v) {
  std::map<uint32_t, double> arcs;
  for (const auto& [to, length] : graph.ArcsOf(v)) {
    EXPECT_TRUE(arcs.emplace(to, ToFile(graph.mesh(), length)).second);
  }
  return arcs;
}

// Of the K nearest vertices, those that the exact solver's trace reaches
// straight from the source are arcs of their distance.
void ExpectArcs(const NamedMesh& named, uint32_t neighbours,
                SaddleGraphBuilder builder) {
  SCOPED_TRACE(named.name);
  const auto mesh = BuildOrFail(named);
  const auto graph =
      GraphOrFail(*mesh, {.neighbours = neighbours, .builder = builder});
  int direct = 0;
  for (uint32_t v = 0; v < mesh->vertex_count(); v += 7) {
    const std::map<uint32_t, double> arcs = ArcsAt(*graph, v);
    const DistanceField field =
        SolveOrFail(*mesh, {.sources = {{VertexPoint{v}}}, .trace = true});
    for (const auto& [to, length] : arcs) {
      EXPECT_GE(length, field.distances[to] * (1 - kArcTolerance));
    }
    std::vector<uint32_t> nearest(mesh->vertex_count());
    std::iota(nearest.begin(), nearest.end(), 0);
    std::ranges::sort(nearest, {},
                      [&](uint32_t w) { return field.distances[w]; });
    for (uint32_t i = 1; i <= neighbours && i < nearest.size(); ++i) {
      const uint32_t w = nearest[i];
      if (field.arrivals[w].pseudo_source != v) continue;
      // Several vertices as far as the last wanted: any may be left out.
      if (i + 1 < nearest.size() && field.distances[w] * (1 + 1e-9) >=
                                        field.distances[nearest[neighbours]]) {
        break;
      }
      ++direct;
      ASSERT_TRUE(arcs.contains(w)) << v << " to " << w;
      EXPECT_NEAR(arcs.at(w), field.distances[w],
                  kArcTolerance * field.distances[w]);
    }
  }
  EXPECT_GT(direct, 100);
}

TEST(SaddleVertexGraph, ArcsAreTheDirectGeodesicsAroundAVertex) {
  for (const auto builder :
       {SaddleGraphBuilder::kFwp, SaddleGraphBuilder::kIch}) {
    ExpectArcs({"terrain", Terrain(15, 15, 2, 3)}, 40, builder);
    ExpectArcs({"torus", Torus({.around = 24, .across = 16, .noise = 0.1})}, 25,
               builder);
    ExpectArcs({"plane with a hole",
                MakeGrid(WithHole({.columns = 16,
                                   .rows = 12,
                                   .diagonals = Diagonals::kRandom,
                                   .jitter = 0.2}))},
               30, builder);
  }
}

// Paths on a polyhedron are direct geodesics between vertices, so a graph of
// all of these is exact.
TEST(SaddleVertexGraph, IsExactWithAllNeighbours) {
  for (const TriangleSoup& soup :
       {Terrain(12, 10, 2, 5), Torus({.noise = 0.2, .seed = 4}),
        MakePlate(UShape({.columns = 9, .rows = 9}), 0.5)}) {
    const auto mesh = BuildOrFail({"surface", soup});
    const auto graph = GraphOrFail(*mesh, {.neighbours = mesh->vertex_count()});
    for (const uint32_t v : {0u, mesh->vertex_count() / 2}) {
      const std::vector<Source> sources = {{VertexPoint{v}}};
      EXPECT_LE(
          CompareWithExact(*mesh, sources, AskOrFail(*graph, *mesh, sources))
              .largest,
          kArcTolerance);
    }
  }
}

TEST(SaddleVertexGraph, IsNeverShorterAndNearerWithMoreNeighbours) {
  const auto mesh = BuildOrFail(
      {"torus", Torus({.around = 80, .across = 40, .noise = 0.03})});
  const std::vector<Source> sources = {{VertexPoint{11}}};
  const std::vector<double> exact =
      SolveOrFail(*mesh, kDefaultAlgorithm, sources);
  double before = 1;
  for (const uint32_t neighbours : {10u, 25u, 60u, 150u}) {
    const std::vector<double> field = AskOrFail(
        *GraphOrFail(*mesh, {.neighbours = neighbours}), *mesh, sources);
    for (uint32_t v = 0; v < field.size(); ++v) {
      ASSERT_GE(field[v], exact[v] * (1 - kArcTolerance)) << v;
    }
    const double error = CompareWithExact(*mesh, sources, field).mean;
    EXPECT_LE(error, before / 2) << neighbours;
    before = error;
  }
  EXPECT_LE(before, 0.001);
}

// The nearest neighbour of nearly every vertex of the fine part lies in there
// too; edges lead out of it.
TEST(SaddleVertexGraph, ReachesAllThatEdgesDo) {
  TriangleSoup soup = MakeGrid({.columns = 24, .rows = 6});
  for (Point& p : soup.positions) {
    if (p[0] <= 12) p[0] *= 0.05;
  }
  const auto mesh = BuildOrFail({"fine and coarse", soup});
  for (const uint32_t neighbours : {1u, 3u}) {
    const std::vector<Source> sources = {{VertexPoint{0}}};
    CompareWithExact(*mesh, sources,
                     AskOrFail(*GraphOrFail(*mesh, {.neighbours = neighbours}),
                               *mesh, sources));
  }
}

TEST(SaddleVertexGraph, BuildersAndThreadsAgree) {
  const auto mesh =
      BuildOrFail({"torus", Torus({.around = 40, .across = 20, .noise = 0.1})});
  const auto one = GraphOrFail(*mesh, {.threads = 1});
  const auto four = GraphOrFail(*mesh, {.threads = 4});
  ASSERT_EQ(one->arc_count(), four->arc_count());
  for (uint32_t v = 0; v < mesh->vertex_count(); ++v) {
    EXPECT_EQ(ArcsAt(*one, v), ArcsAt(*four, v));
  }
  const auto ich = GraphOrFail(*mesh, {.builder = SaddleGraphBuilder::kIch});
  const std::vector<double> expected =
      AskOrFail(*one, *mesh, {{VertexPoint{3}}});
  const std::vector<double> got = AskOrFail(*ich, *mesh, {{VertexPoint{3}}});
  for (uint32_t v = 0; v < got.size(); ++v) {
    EXPECT_NEAR(got[v], expected[v], kArcTolerance * expected[v]);
  }
}

TEST(SaddleGraphSearch, FindsWhatTheFieldSays) {
  const TriangleSoup soup =
      AddIsolatedVertices(Join(Terrain(30, 20, 1.5, 8), Icosphere(2)), 2);
  const auto mesh = BuildOrFail({"terrain and sphere", soup});
  const auto graph = GraphOrFail(*mesh, {.neighbours = 30});
  NoCheckpoint checkpoint;
  const Landmarks landmarks = MakeLandmarks(*mesh, 6, {}, checkpoint).value();
  SaddleGraphSearch search(*graph);
  Random random(1);
  uint64_t undirected = 0, directed = 0;
  for (int i = 0; i < 12; ++i) {
    const uint32_t from = random.Below(mesh->vertex_count());
    const std::vector<double> field =
        AskOrFail(*graph, *mesh, {{VertexPoint{from}}});
    for (int j = 0; j < 20; ++j) {
      const uint32_t to = random.Below(mesh->vertex_count());
      const double plain =
          search.Distance(from, to, nullptr, checkpoint).value();
      undirected += search.expanded();
      const double guided =
          search.Distance(from, to, &landmarks, checkpoint).value();
      directed += search.expanded();
      if (std::isinf(field[to])) {
        EXPECT_TRUE(std::isinf(plain));
        EXPECT_TRUE(std::isinf(guided));
        continue;
      }
      EXPECT_NEAR(plain, field[to], kArcTolerance * field[to]);
      EXPECT_NEAR(guided, field[to], kArcTolerance * field[to]);
      EXPECT_NEAR(search.Distance(to, from, &landmarks, checkpoint).value(),
                  field[to], kArcTolerance * field[to]);
    }
  }
  EXPECT_LT(directed, undirected);
}

TEST(SaddleGraphSearch, StopsWhenItIsTold) {
  const auto mesh = BuildOrFail({"sphere", Icosphere(5)});
  const auto graph = GraphOrFail(*mesh, {.neighbours = 30});
  const uint32_t farthest = mesh->vertex_count() - 1;
  SaddleGraphSearch search(*graph);
  RecordingCheckpoint whole;
  const double distance = search.Distance(0, farthest, nullptr, whole).value();
  ASSERT_GE(whole.polls().size(), search.expanded() / 2048);
  ASSERT_GE(whole.polls().size(), 1u);
  for (uint64_t poll = 0; poll < whole.polls().size(); ++poll) {
    RecordingCheckpoint checkpoint(poll);
    EXPECT_EQ(search.Distance(0, farthest, nullptr, checkpoint).status(),
              RecordingCheckpoint::Stopped());
  }
  NoCheckpoint again;
  EXPECT_EQ(search.Distance(0, farthest, nullptr, again).value(), distance);
}

TEST(SaddleVertexGraph, RefusesByName) {
  const auto sphere = BuildOrFail({"sphere", Icosphere(1)});
  for (const SaddleGraphOptions& options : {SaddleGraphOptions{.neighbours = 0},
                                            {.neighbours = 10001},
                                            {.threads = 0},
                                            {.threads = 257}}) {
    EXPECT_TRUE(absl::IsInvalidArgument(StatusOf(*sphere, options)));
  }
  const auto book =
      BuildOrFail({"book", Book(MakeGrid({.columns = 3, .rows = 3}), 3)});
  const absl::Status many_faces = StatusOf(*book, {});
  EXPECT_TRUE(absl::IsInvalidArgument(many_faces));
  EXPECT_TRUE(absl::StrContains(std::string(many_faces.message()),
                                "edges of three faces"));
  const auto flat =
      BuildOrFail({"flat", InsertZeroAreaFaces(Icosphere(1), 5, 1)});
  const absl::Status no_area = StatusOf(*flat, {});
  EXPECT_TRUE(absl::IsInvalidArgument(no_area));
  EXPECT_TRUE(
      absl::StrContains(std::string(no_area.message()), "faces without area"));
}

TEST(SaddleVertexGraph, TellsHowManyVerticesAreDone) {
  const auto mesh = BuildOrFail({"sphere", Icosphere(4)});
  RecordingCheckpoint checkpoint;
  ASSERT_TRUE(SaddleVertexGraph::Prepare(*mesh, {}, checkpoint).ok());
  uint64_t before = 0;
  for (const Progress& progress : checkpoint.polls()) {
    EXPECT_GE(progress.vertices_reached, before);
    EXPECT_EQ(progress.vertices, mesh->vertex_count());
    before = progress.vertices_reached;
  }
  EXPECT_EQ(before, mesh->vertex_count());
  EXPECT_GT(checkpoint.polls().size(), 50u);
}

// Around a hub a search asks in its midst: no vertex was done since.
TEST(SaddleVertexGraph, DoesNoMoreOnceItIsToldToStop) {
  const auto mesh = BuildOrFail({"fan", NeedleFan(8192)});
  RecordingCheckpoint whole;
  ASSERT_TRUE(SaddleVertexGraph::Prepare(*mesh, {}, whole).ok());
  const auto same = std::ranges::adjacent_find(whole.polls(), {},
                                               &Progress::vertices_reached);
  ASSERT_NE(same, whole.polls().end());
  const auto midst = static_cast<uint64_t>(same - whole.polls().begin()) + 1;
  RecordingCheckpoint checkpoint(midst);
  EXPECT_EQ(SaddleVertexGraph::Prepare(*mesh, {}, checkpoint).status(),
            RecordingCheckpoint::Stopped());
  EXPECT_EQ(checkpoint.polls().size(), midst + 1);
}

// When all arcs are found they are put together: a step for each vertex and
// half-edge, twice, and a poll for every 2048.
TEST(SaddleVertexGraph, AsksWhileItPutsArcsTogether) {
  const auto mesh = BuildOrFail({"fan", NeedleFan(8192)});
  RecordingCheckpoint checkpoint;
  ASSERT_TRUE(
      SaddleVertexGraph::Prepare(*mesh, {.neighbours = 2}, checkpoint).ok());
  const auto all_done = std::ranges::count(
      checkpoint.polls(), mesh->vertex_count(), &Progress::vertices_reached);
  EXPECT_GT(all_done,
            2 * (mesh->vertex_count() + mesh->half_edge_count()) / 2048);
}

}  // namespace
}  // namespace geodesic::test
