// That every question hears when it is to stop, wherever it is, and that what
// it does between two polls is bounded by work, not by places: where very many
// faces meet, most of the work is at one of them.

#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "geodesic/mesh.h"
#include "geodesic/mesh_summary.h"
#include "tests/support/checkpoints.h"
#include "tests/support/crowded_meshes.h"
#include "tests/support/curved_meshes.h"
#include "tests/support/every_question.h"
#include "tests/support/planar_meshes.h"

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

// Each vertex is a step of its own; what is around the source is found by one
// search each.
TEST(Stopping, ALogMapAroundAHubTakesAStepForEachVertex) {
  constexpr uint32_t kFaces = 8 * kSteps;
  EXPECT_EQ(PollsOf("log map", NeedleFan(kFaces), 0), 1 + kFaces / kSteps);
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
