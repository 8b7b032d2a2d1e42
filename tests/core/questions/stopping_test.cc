// That every question hears when it is to stop, wherever it is, and that what
// it does between two polls is bounded by work, not by places: where very many
// faces meet, most of the work is at one of them.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "geodesic/computation.h"
#include "geodesic/isolines.h"
#include "geodesic/mesh.h"
#include "geodesic/mesh_summary.h"
#include "geodesic/solve.h"
#include "geodesic/trace.h"
#include "geodesic_types/algorithms.h"
#include "tests/support/checkpoints.h"
#include "tests/support/every_question.h"
#include "tests/support/meshes/crowded_meshes.h"
#include "tests/support/meshes/curved_meshes.h"
#include "tests/support/meshes/planar_meshes.h"
#include "tests/support/queries.h"

namespace geodesic::test {
namespace {

struct Crowd {
  std::string name;
  std::shared_ptr<const Mesh> mesh;
  uint32_t source;
};

std::vector<Crowd> Crowds(uint32_t faces) {
  const auto build = [](const TriangleSoup& soup) {
    return Mesh::Build(soup).value();
  };
  return {{"pages", build(Pages(faces)), 2},
          {"pages, from the spine", build(Pages(faces)), 0},
          {"needles", build(NeedleFan(faces)), 0},
          {"needles, from the rim", build(NeedleFan(faces)), 1},
          {"one point", build(FanInOnePoint(faces)), 1},
          {"fins", build(FinnedStrip(faces / 4)), 0},
          {"strip", build(Strip(faces / 2, 0.1, 1)), 0},
          {"grid", build(MakeGrid({.columns = 20, .rows = faces / 40})), 0}};
}

class StoppingTest : public ::testing::TestWithParam<size_t> {};

TEST_P(StoppingTest, EveryQuestionEndsAtThePollThatSaysSo) {
  const Crowd crowd = Crowds(800)[GetParam()];
  for (const AnyQuestion& question : EveryQuestion(/*algorithms=*/true)) {
    SCOPED_TRACE(crowd.name + ", " + question.name);
    RecordingCheckpoint whole;
    if (!question.ask(*crowd.mesh, crowd.source, whole).ok()) continue;
    const uint64_t polls = whole.polls().size();
    ASSERT_GT(polls, 0u);
    for (uint64_t poll = 0; poll < polls; poll += 1 + poll / 2) {
      RecordingCheckpoint checkpoint(poll);
      EXPECT_EQ(question.ask(*crowd.mesh, crowd.source, checkpoint),
                RecordingCheckpoint::Stopped())
          << poll;
      EXPECT_EQ(checkpoint.polls().size(), poll + 1);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Crowds, StoppingTest,
                         ::testing::Range(size_t{0}, size_t{8}));

uint64_t PollsOf(const std::string& name, const TriangleSoup& soup,
                 uint32_t source) {
  const auto mesh = Mesh::Build(soup).value();
  for (const AnyQuestion& question : EveryQuestion(/*algorithms=*/false)) {
    if (question.name != name) continue;
    RecordingCheckpoint checkpoint;
    EXPECT_TRUE(question.ask(*mesh, source, checkpoint).ok());
    return checkpoint.polls().size();
  }
  ADD_FAILURE() << "no question is " << name;
  return 0;
}

// A poll comes after 2048 steps (kWorkBetweenPolls); the first is before all.
constexpr uint64_t kSteps = 2048;

// Each of the eight paths crosses the edge, and looks at its faces once.
TEST(Stopping, APathOverAnEdgeOfManyFacesLooksAtEachOnce) {
  constexpr uint32_t kFaces = 16 * kSteps;
  const uint64_t polls = PollsOf("paths", Pages(kFaces), 2);
  EXPECT_EQ(polls, 1 + 8 * (kFaces / kSteps));
}

// Each source looks at all of the faces, and asks for every kSteps of them.
TEST(Stopping, FieldsOfManySourcesAskForEachFaceAtAnEdge) {
  constexpr uint32_t kFaces = 8 * kSteps, kSources = 4;
  const auto mesh = Mesh::Build(Pages(kFaces)).value();
  for (const AnyQuestion& question :
       QuestionsOfManySources(kSources, /*algorithms=*/true)) {
    if (!question.name.starts_with("field") ||
        question.name.find("with offsets") != std::string::npos) {
      continue;
    }
    SCOPED_TRACE(question.name);
    RecordingCheckpoint checkpoint;
    EXPECT_TRUE(question.ask(*mesh, 0, checkpoint).ok());
    EXPECT_GE(checkpoint.polls().size(), kSources * kFaces / kSteps);
  }
}

// Each line looks twice at the faces around its hub, and then once for the way.
TEST(Stopping, LinesFromAHubAskByFaces) {
  const auto mesh = Mesh::Build(NeedleFan(2 * kSteps)).value();
  const LineQuestion lines = {
      .sources = std::vector<SurfacePoint>(3, VertexPoint{0}),
      .directions = {Point{1, 0, 0}},
      .lengths = {0.5}};
  RecordingCheckpoint checkpoint;
  const auto take = [](const TracedLine&) { return absl::OkStatus(); };
  ASSERT_TRUE(TraceLines(*mesh, lines, 0, 3, checkpoint, take).ok());
  EXPECT_EQ(checkpoint.polls().size(), 3 * (2 * 2 + 1 + 2));
}

// Where every edge has very many faces, a vertex looks at nearly as many as
// there are pairs of them: not all vertices do between two polls.
TEST(Stopping, FieldsAskBetweenVerticesThatLookAtVeryManyFaces) {
  constexpr uint32_t kPoints = 30;
  const auto mesh = Mesh::Build(AllTriangles(kPoints)).value();
  Query query;
  for (uint32_t v = 0; v < kPoints; ++v) {
    query.sources.push_back({VertexPoint{v}, 1e-6 * v});
  }
  // They all look first of all.
  RecordingCheckpoint checkpoint(/*stop_at=*/kPoints);
  ASSERT_EQ(Solve(*mesh, query, {}, checkpoint).status(),
            RecordingCheckpoint::Stopped());
  uint64_t before = 0, most = 0;
  for (const Progress& progress : checkpoint.polls()) {
    most = std::max(
        most, progress.live_windows - std::min(before, progress.live_windows));
    before = progress.live_windows;
  }
  EXPECT_LT(most, 100'000u);
}

// All that one vertex sees beyond its edges would take as long.
TEST(Stopping, FieldsAskWhileAVertexLooksAtVeryManyFaces) {
  const auto mesh = Mesh::Build(AllTriangles(90)).value();
  for (const AlgorithmInfo& info : kAlgorithms) {
    SCOPED_TRACE(AlgorithmName(info.algorithm));
    RecordingCheckpoint checkpoint(/*stop_at=*/20);
    ASSERT_EQ(
        Solve(*mesh,
              {.sources = {{VertexPoint{0}}}, .algorithm = info.algorithm}, {},
              checkpoint)
            .status(),
        RecordingCheckpoint::Stopped());
    uint64_t before = 0, most = 0;
    for (const Progress& progress : checkpoint.polls()) {
      most = std::max(most, progress.live_windows -
                                std::min(before, progress.live_windows));
      before = progress.live_windows;
    }
    EXPECT_LT(most, 50'000u);
  }
}

// Each page is entered by as many windows, of which each is compared with each
// other before a line is drawn there.
TEST(Stopping, IsolinesOfManySourcesAskForEachTwoWaysIntoAFace) {
  constexpr uint32_t kFaces = 256, kSources = 64;
  const auto mesh = Mesh::Build(Pages(kFaces)).value();
  Query query;
  for (uint32_t i = 0; i < kSources; ++i) {
    const double t = 0.01 + 0.97 * i / kSources;
    query.sources.push_back({FacePoint{0, {0.99 - t, t, 0.01}}});
  }
  RecordingCheckpoint field, isolines;
  ASSERT_TRUE(Solve(*mesh, query, {}, field).ok());
  const IsolineOptions far = {
      .levels = {0.5}, .chord_error = std::numeric_limits<double>::infinity()};
  ASSERT_TRUE(
      ComputeIsolines(*mesh, Valid(*mesh, query), far, {}, isolines).ok());
  // A poll comes after 4096 ways.
  EXPECT_GT(isolines.polls().size() - field.polls().size(),
            kFaces * kSources * kSources / 4096);
}

// Each of two lines crosses all faces. Once the first is drawn it counts as
// bytes that are held.
TEST(Stopping, IsolinesAskWhileALineIsDrawn) {
  constexpr uint32_t kFaces = 32 * kSteps;
  const auto mesh = Mesh::Build(NeedleFan(kFaces)).value();
  const IsolineOptions isolines = {
      .levels = {0.4, 0.5},
      .chord_error = std::numeric_limits<double>::infinity()};
  RecordingCheckpoint checkpoint;
  ASSERT_TRUE(ComputeIsolines(*mesh,
                              Valid(*mesh, {.sources = {{VertexPoint{0}}}}),
                              isolines, {}, checkpoint)
                  .ok());
  const std::vector<Progress>& polls = checkpoint.polls();
  // A poll comes after 4096 points.
  EXPECT_GE(std::ranges::count(polls, polls.back().solver_bytes,
                               &Progress::solver_bytes),
            kFaces / 4096 - 1);
}

// The rim's vertices are at 1, or where they are in space: in each of the two
// the hub is the first that anything goes on from.
TEST(Stopping, FieldsAskAndGoOnAmidTheFacesAroundAHub) {
  constexpr uint32_t kFaces = 16 * kSteps;
  const auto flat = Mesh::Build(NeedleFan(kFaces)).value();
  const auto point = Mesh::Build(FanInOnePoint(kFaces)).value();
  for (const AlgorithmInfo& info : kAlgorithms) {
    SCOPED_TRACE(AlgorithmName(info.algorithm));
    for (const auto& mesh : {flat, point}) {
      const Query query{.sources = {{VertexPoint{0}}},
                        .algorithm = info.algorithm};
      const DistanceField whole = Solve(*mesh, query).value();
      const auto computation =
          StartComputation(*mesh, Valid(*mesh, query), {}).value();
      uint64_t stops = 0;
      for (;; ++stops) {
        RecordingCheckpoint checkpoint(2);
        if (computation->Advance({}, checkpoint).ok()) break;
        const DistanceField part = computation->Field();
        for (size_t v = 1; v < part.distances.size(); ++v) {
          if (std::isinf(part.distances[v])) continue;
          ASSERT_EQ(part.distances[v], whole.distances[v]) << v;
        }
      }
      EXPECT_GE(stops, kFaces / kSteps / 2 - 1);
      EXPECT_EQ(computation->Field().distances, whole.distances);
    }
  }
}

// Also amid the faces at an edge.
TEST(Stopping, FieldsGoOnWhereTheyWereStopped) {
  const auto mesh = Mesh::Build(Pages(2 * kSteps)).value();
  for (const AlgorithmInfo& info : kAlgorithms) {
    SCOPED_TRACE(AlgorithmName(info.algorithm));
    const Query query{.sources = {{FacePoint{9, {0.2, 0.3, 0.5}}},
                                  {EdgePoint{0, 1, 0.4}},
                                  {VertexPoint{70}}},
                      .algorithm = info.algorithm,
                      .trace = true};
    const DistanceField whole = Solve(*mesh, query).value();
    // Any two pages unfold into a plane; the sources lie in pages 9, all
    // and 68.
    for (uint32_t page = 0; page < mesh->face_count(); ++page) {
      const double expected =
          std::min({std::hypot(0.05, page == 9 ? 0.5 : 1.5),
                    std::hypot(0.1, 1.0), page == 68 ? 0.0 : 2.0});
      ASSERT_NEAR(whole.distances[page + 2], expected, 1e-14) << page;
    }
    const auto computation =
        StartComputation(*mesh, Valid(*mesh, query), {}).value();
    uint64_t stops = 0;
    for (;; ++stops) {
      RecordingCheckpoint checkpoint(2);
      if (computation->Advance({}, checkpoint).ok()) break;
    }
    EXPECT_GE(stops, 3u);
    EXPECT_EQ(computation->Field().distances, whole.distances);
  }
}

// Each vertex is a step of its own, after two looks at the faces around the
// source; what is around it is then found by one search each.
TEST(Stopping, ALogMapAroundAHubTakesAStepForEachVertex) {
  constexpr uint32_t kFaces = 8 * kSteps;
  EXPECT_EQ(PollsOf("log map", NeedleFan(kFaces), 0),
            1 + 3 * (kFaces / kSteps));
}

// The way back from the vertex in row i and column j crosses i + j edges and
// more, but from those straight along an edge: rows * columns * (rows +
// columns) / 2 in all, about.
TEST(Stopping, ALogMapPollsOnTheWaysBack) {
  constexpr uint32_t kSide = 64;
  const uint64_t polls =
      PollsOf("log map", MakeGrid({.columns = kSide, .rows = kSide}), 0);
  EXPECT_GT(polls, kSide * kSide * kSide / 2 / kSteps);
}

// Of many vertices at one place, each has the gradient of the one that its path
// comes from, which is found once.
TEST(Stopping, GradientsInOnePointTakeAStepForEachVertex) {
  constexpr uint32_t kFaces = 8 * kSteps;
  const uint64_t polls = PollsOf("gradients", FanInOnePoint(kFaces), 1);
  EXPECT_LE(polls, 2 + 2 * kFaces / kSteps);
}

// It asks for every 256 edges at a boundary, however many meet in a vertex.
TEST(Stopping, ASummaryAsksWhereManyEdgesMeet) {
  for (const TriangleSoup& soup : {Pages(8 * kSteps), FanInOnePoint(kSteps)}) {
    const auto mesh = Mesh::Build(soup).value();
    RecordingCheckpoint whole;
    const absl::StatusOr<MeshSummary> summary = Summarize(*mesh, whole);
    ASSERT_TRUE(summary.ok());
    const uint64_t polls = whole.polls().size();
    EXPECT_GT(polls, summary->boundary_edges / 1024);
    for (uint64_t poll = 0; poll < polls; poll += 1 + poll / 2) {
      RecordingCheckpoint checkpoint(poll);
      EXPECT_EQ(Summarize(*mesh, checkpoint).status(),
                RecordingCheckpoint::Stopped());
    }
  }
}

}  // namespace
}  // namespace geodesic::test
