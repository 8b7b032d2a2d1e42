// Around a pole wavefronts meet along every meridian. The windows that cross a
// meridian lose there by rounding alone, and are not to go on for ever. Those
// that lose to windows which are useless themselves have to go on.

#include "solver/rules/passed_windows.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "geodesic/solve.h"
#include "solver/queues/fwp_buckets.h"
#include "solver/rules/front.h"
#include "solver/rules/list_worker.h"
#include "solver/start_computation.h"
#include "solver/windows/window_blocks.h"
#include "tests/support/field_check.h"
#include "tests/support/meshes/curved_meshes.h"
#include "tests/support/meshes/planar_meshes.h"
#include "tests/support/oracles/brute_force.h"

namespace geodesic {
namespace {

using Passed = PassedWindows<WindowBlock*>;

DistanceField FromPole(const Mesh& mesh, Algorithm algorithm,
                       uint32_t threads = 1, uint32_t source = 0) {
  NoCheckpoint checkpoint;
  return Solve(
             mesh,
             Query{.sources = {{VertexPoint{source}}}, .algorithm = algorithm},
             {.threads = threads}, checkpoint)
      .value();
}

TEST(PassedWindows, LeaveNoMoreAroundAPoleThanMmp) {
  for (const auto& [meridians, bands] :
       {std::pair{20u, 30u}, {40u, 60u}, {30u, 200u}, {100u, 250u}}) {
    SCOPED_TRACE(testing::Message() << meridians << " x " << bands);
    const auto mesh =
        test::BuildOrFail({"sphere", test::UvSphere(meridians, bands)});
    const DistanceField lists = FromPole(*mesh, Algorithm::kFwpList);
    const DistanceField mmp = FromPole(*mesh, Algorithm::kFwpMmp);
    EXPECT_LT(static_cast<double>(lists.statistics.windows_propagated),
              1.3 * static_cast<double>(mmp.statistics.windows_propagated));
    for (uint32_t v = 0; v < mesh->vertex_count(); ++v) {
      ASSERT_NEAR(lists.distances[v], mmp.distances[v],
                  1e-14 * mmp.distances[v])
          << v;
    }
  }
}

TEST(PassedWindows, AreTheSameOnAnyNumberOfThreads) {
  const auto mesh = test::BuildOrFail({"sphere", test::UvSphere(150, 150)});
  const DistanceField one = FromPole(*mesh, Algorithm::kFwpList);
  for (const uint32_t threads : {2u, 5u}) {
    const DistanceField several = FromPole(*mesh, Algorithm::kFwpList, threads);
    EXPECT_EQ(several.distances, one.distances);
    EXPECT_EQ(several.statistics.windows_propagated,
              one.statistics.windows_propagated);
  }
}

// The threads decide together when to keep all lists, however they share work.
TEST(PassedWindows, AreTheSameInEveryRun) {
  const auto mesh = test::BuildOrFail({"sphere", test::UvSphere(200, 300)});
  const DistanceField one = FromPole(*mesh, Algorithm::kFwpList, 1, 1000);
  for (int run = 0; run < 6; ++run) {
    const DistanceField several = FromPole(*mesh, Algorithm::kFwpList, 6, 1000);
    EXPECT_EQ(several.distances, one.distances);
  }
}

void ExpectBruteForce(const TriangleSoup& soup, const SurfacePoint& source) {
  const auto mesh = test::BuildOrFail({"strip", soup});
  const std::vector<Source> sources = {{source}};
  const AlgorithmInfo lists[] = {kAlgorithms[0]};
  ASSERT_EQ(lists[0].algorithm, Algorithm::kFwpList);
  std::vector<double> expected =
      test::BruteForce(soup, {source}).Distances(sources);
  expected.pop_back();  // the source's own
  test::ExpectFromAll(lists, "strip", *mesh, {.sources = sources}, expected,
                      test::CoordinateRounding(soup.positions));
}

// Right beside a vertex windows of the source and of the vertex tie within
// rounding. Where the vertex improves by a rounding its windows are dropped
// wherever they have got to, so what came late must not lose to what they left.
// Strips of larger meshes, on which distances were up to 7 % too long.
TEST(PassedWindows, DoNotCountOnceTheirPseudoSourceHasImproved) {
  const std::vector<Point> strip = {
      {4, 2, 0},    {4, 2, -2e-9},  {6, 2, 0},    {2, 3, 7e-8},
      {2, 3, 0},    {4, 3, 0},      {4, 3, 3e-8}, {6, 3, 4e-8},
      {9e-8, 4, 0}, {1.88, 3.9, 0}, {2, 3.8, 0},  {8e-8, 4.9, 7e-8},
      {2, 5, 0}};
  const std::vector<Triangle> faces = {
      {0, 5, 4}, {0, 1, 6},  {0, 6, 5},  {1, 2, 7},  {1, 7, 6},   {3, 9, 8},
      {3, 4, 9}, {4, 10, 9}, {4, 5, 10}, {8, 9, 11}, {9, 12, 11}, {9, 10, 12}};
  ExpectBruteForce({strip, faces},
                   FacePoint{9,
                             {1.0351048486647982e-15, 0.99999999999999645,
                              2.5135584193218637e-15}});
  const std::vector<Triangle> more_faces = {
      {0, 1, 2},    {0, 3, 4},    {1, 5, 6},    {5, 8, 9},
      {7, 10, 11},  {7, 11, 8},   {10, 12, 11}, {12, 13, 11},
      {11, 13, 14}, {13, 16, 20}, {13, 17, 14}, {15, 18, 19},
      {15, 19, 16}, {17, 13, 20}, {21, 22, 18}, {22, 19, 18}};
  ExpectBruteForce(
      {{{0, 0, 0},
        {-1, -0.2, -1.9},
        {-0.7, -0.7, 5},
        {0.6, -0.8, 0.6},
        {0.9, -0.5, -4},
        {-2, -0.5, -4},
        {-1, -1, 9},
        {-2.9128308425145266, 0.72, -5.61611},
        {-2.912828, -0.7179477, -5.616094},
        {-2, -2, 10},
        {-3.88377, 0.96, -7.488},
        {-3.8837629809575818, -0.9572616, -7.4881236818929091},
        {-4.85471, 1.196578, -9.36018},
        {-4.8547024760775797, -1.1965766919596499, -9.3601830767368224},
        {-3.7425466862310657, -3.316, 23.37},
        {-6, 1, -10},
        {-5.8256403, -1.4358914, -11.232231739155729},
        {-4.4910695108550707, -3.9787403983965688, 28.047151182737462},
        {-7, 2, -10},
        {-7, -2, -10},
        {-5.2395636323911754, -4.64, 32.721549225770829},
        {-8, 2, -10},
        {-8, -2, -10}},
       more_faces},
      EdgePoint{0, 3, 6.8474021429128988e-12});
}

// A vertex hardly above an edge may see half a plane through a gap that is
// narrower than what windows from afar may lose there.
TEST(PassedWindows, LeaveANarrowWindowOfANearPseudoSourceWhatItHolds) {
  const auto mesh =
      test::BuildOrFail({"grid", test::MakeGrid({.columns = 2, .rows = 2})});
  using Front = Front<FwpBuckets, Origin>;
  FwpBuckets queue(TuningFor(*mesh, {}).value());
  const Query query = {.sources = {{VertexPoint{0}}}};
  const Front front(*mesh, query, queue, nullptr);
  BlockPool pool;
  ListWorker<Front> worker(front, pool);
  constexpr HalfEdge kCrossed = 4;
  const double length = mesh->frame(kCrossed).length;
  WindowBlock* passed = nullptr;
  const auto cross = [&](const Origin& origin, const Interval& interval) {
    worker.Clear();
    worker.Open(kCrossed, 0, origin, interval);
    const WaitingLists lists = {worker.handed_on()[0].list, nullptr};
    return worker.Cross(kCrossed, lists, &passed, Winding::kUnknown).propagated;
  };
  const double middle = length / 2, gap = 1e-13 * length;
  const Origin far = {.x = middle, .depth = length};
  const Origin near = {.x = middle, .depth = 1e-9 * length, .sigma = length};
  EXPECT_EQ(cross(far, {0, middle - gap}), 1u);
  EXPECT_EQ(cross(far, {middle + gap, length}), 1u);
  EXPECT_EQ(cross(near, {middle - gap, middle + gap}), 1u);
  EXPECT_EQ(cross(near, {middle - gap, middle + gap}), 0u);
}

// So large that a sample of half-edges does.
std::shared_ptr<const Mesh> Sheet() {
  return test::BuildOrFail(
      {"sheet", test::MakeGrid({.columns = 110, .rows = 110})});
}

constexpr MetWindows kOftenLose = {.all = 300, .late = 100, .lost = 80};

TEST(PassedWindows, KeepASampleUntilManyAreLateAndOftenLose) {
  const std::shared_ptr<const Mesh> mesh = Sheet();
  Passed passed(*mesh);
  WindowBlock block{.next = nullptr, .count = 1, .log_room = 2};
  ASSERT_NE(passed.At(32, 1), nullptr);
  EXPECT_EQ(passed.At(33, 1), nullptr);
  *passed.At(32, 1) = &block;
  const MetWindows seldom_lose = {.all = 200, .late = 100, .lost = 20};
  for (int i = 0; i < 1000; ++i) passed.Count(seldom_lose);
  EXPECT_EQ(passed.At(33, 1), nullptr);
  const MetWindows few_are_late = {.all = 2000, .late = 100, .lost = 95};
  for (int i = 0; i < 1000; ++i) passed.Count(few_are_late);
  EXPECT_EQ(passed.At(33, 1), nullptr);
  for (int i = 0; i < 20; ++i) passed.Count(kOftenLose);
  ASSERT_NE(passed.At(33, 1), nullptr);
  EXPECT_EQ(*passed.At(33, 1), nullptr);
  EXPECT_EQ(*passed.At(32, 1), &block);
}

TEST(PassedWindows, AreForgottenForTheNextSearch) {
  const std::shared_ptr<const Mesh> mesh = Sheet();
  Passed passed(*mesh);
  WindowBlock block{.next = nullptr, .count = 1, .log_room = 2};
  for (int search = 0; search < 2; ++search) {
    SCOPED_TRACE(search);
    EXPECT_EQ(*passed.At(32, 1), nullptr);
    EXPECT_EQ(passed.At(33, 1), nullptr);
    *passed.At(32, 1) = &block;
    for (int i = 0; i < 20; ++i) passed.Count(kOftenLose);
    *passed.At(33, 1) = &block;
    std::vector<WindowBlock*> dropped;
    const std::vector<HalfEdge> crossed = {31, 32, 33};
    passed.Clear(crossed, [&](WindowBlock* list) { dropped.push_back(list); });
    EXPECT_THAT(dropped, testing::ElementsAre(&block, &block));
  }
}

TEST(PassedWindows, KeepWhatCrossesOften) {
  const std::shared_ptr<const Mesh> mesh = Sheet();
  Passed passed(*mesh);
  WindowBlock block{.next = nullptr, .count = 1, .log_room = 2};
  EXPECT_EQ(passed.At(35, kManyCrossings - 1), nullptr);
  ASSERT_NE(passed.At(35, kManyCrossings), nullptr);
  *passed.At(35, kManyCrossings) = &block;
  EXPECT_EQ(*passed.At(33, kManyCrossings), nullptr);
  EXPECT_EQ(*passed.At(35, kManyCrossings), &block);
  std::vector<WindowBlock*> dropped;
  passed.Clear({}, [&](WindowBlock* list) { dropped.push_back(list); });
  EXPECT_THAT(dropped, testing::UnorderedElementsAre(&block, nullptr));
  EXPECT_EQ(*passed.At(35, kManyCrossings), nullptr);
}

}  // namespace
}  // namespace geodesic
