#include "geodesic/rows/pairs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "geodesic/rows/kept_searches.h"
#include "server/engine/rows/pair_order.h"
#include "server/engine/rows/row_engine.h"
#include "tests/engine/engine_fixture.h"
#include "tests/support/meshes/curved_meshes.h"
#include "tests/support/meshes/planar_meshes.h"

namespace geodesic::server {
namespace {

using ::geodesic::test::MakeGrid;

// On the grid geodesics are straight, so every distance is Euclid's.
class PairEngineTest : public test::EngineTest {
 protected:
  static constexpr uint32_t kSide = 10;

  void SetUp() override { Hold(MakeGrid({.columns = kSide, .rows = kSide})); }

  void Hold(const TriangleSoup& soup) {
    soup_ = soup;
    digest_ = Upload(soup).value().mesh.digest;
  }

  absl::StatusOr<PairCall> Start(std::vector<PointPair> pairs) {
    return engine_.rows().ComputePairs(
        {.mesh_digest = digest_, .pairs = std::move(pairs)}, [] {});
  }

  // Runs the question to its end.
  absl::StatusOr<std::vector<double>> Ask(std::vector<PointPair> pairs) {
    absl::StatusOr<PairCall> call = Start(std::move(pairs));
    if (!call.ok()) return call.status();
    call_ = *std::move(call);
    PairOrder order(call_.pair_count);
    while (!order.is_whole()) {
      executor_.RunAll();
      const auto row = call_.rows->Take();
      if (!row.has_value()) return absl::InternalError("no row came");
      if (!row->ok()) return row->status();
      order.Add(**row);
    }
    return std::vector(order.known().begin(), order.known().end());
  }

  void ExpectEuclid(const std::vector<PointPair>& pairs) {
    const auto distances = Ask(pairs).value();
    ASSERT_EQ(distances.size(), pairs.size());
    for (size_t i = 0; i < pairs.size(); ++i) {
      const Point a = PositionOf(pairs[i].source, *call_.mesh->mesh);
      const Point b = PositionOf(pairs[i].target, *call_.mesh->mesh);
      EXPECT_NEAR(distances[i],
                  std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]), 1e-12)
          << i;
    }
  }

  uint32_t CountLandmarks() const {
    return engine_.meshes().landmarks().CountOf(digest_);
  }
  PairCounts counts() const { return call_.work->answered.counts(); }

  TriangleSoup soup_;
  std::string digest_;
  PairCall call_;
};

TEST_F(PairEngineTest, HasLandmarksMadeForLaterQuestions) {
  const auto call = Start({{VertexPoint{0}, VertexPoint{99}}}).value();
  executor_.RunOne();
  EXPECT_TRUE(call.rows->Take().has_value());
  EXPECT_EQ(CountLandmarks(), 0);
  executor_.RunAll();
  EXPECT_EQ(CountLandmarks(), Landmarks::kMost);
}

TEST_F(PairEngineTest, ALongListHasLandmarksMadeFirst) {
  Hold(MakeGrid({.columns = 20, .rows = 20}));
  std::vector<PointPair> pairs;
  for (uint32_t i = 0; i < 1000; ++i) {
    // No end is shared by so many that a field would pay.
    pairs.push_back({VertexPoint{i % 441}, VertexPoint{i * 5 % 441}});
  }
  const auto call = Start(pairs).value();
  executor_.RunOne();
  EXPECT_EQ(CountLandmarks(), LandmarksWorth(pairs.size()));
  call.rows->Cancel();
  executor_.RunAll();
  ExpectEuclid(pairs);
}

TEST_F(PairEngineTest, AFieldInTheCacheAnswersBothWays) {
  const auto observer = std::make_shared<test::RecordingObserver>();
  ASSERT_TRUE(engine_.fields()
                  .Compute({.mesh_digest = digest_,
                            .query = {.sources = {{VertexPoint{60}}}}},
                           observer)
                  .ok());
  executor_.RunAll();
  ASSERT_EQ(observer->calls, 1);
  ExpectEuclid({{VertexPoint{60}, VertexPoint{3}},
                {VertexPoint{4}, VertexPoint{60}},
                {VertexPoint{4}, VertexPoint{5}},
                {VertexPoint{60}, EdgePoint{3, 4, 0.5}}});
  EXPECT_EQ(counts().from_cache, 2);
  EXPECT_EQ(counts().searched, 2);
}

// Whoever links the core alone has them from the same question.
TEST_F(PairEngineTest, HasTheBitsOfTheCore) {
  Hold(geodesic::test::Terrain(30, 30, /*roughness=*/0.5, /*seed=*/7));
  std::vector<PointPair> pairs;
  for (uint32_t i = 0; i < kFieldInSearches; ++i) {
    pairs.push_back({VertexPoint{i}, FacePoint{900 + i, {0.2, 0.3, 0.5}}});
    pairs.push_back({EdgePoint{40, 41, 0.25}, VertexPoint{900 - 7 * i}});
  }
  const auto distances = Ask(pairs).value();
  EXPECT_EQ(call_.algorithm, AlgorithmChoice(Algorithm::kFwpList));
  EXPECT_EQ(counts().searched, kFieldInSearches);
  EXPECT_EQ(counts().from_fields, kFieldInSearches);
  EXPECT_EQ(engine_.counters().pairs.searched, kFieldInSearches);
  EXPECT_EQ(engine_.counters().pairs.from_fields, kFieldInSearches);
  EXPECT_GT(call_.rows->windows_propagated(), 0);
  const Mesh& mesh = *call_.mesh->mesh;
  KeptSearches searches(mesh);
  NoCheckpoint checkpoint;
  const auto question =
      PairQuestion::Make(mesh, pairs, {}, searches, 1).value();
  for (uint64_t row = 0; row < question->rows().size(); ++row) {
    const auto found = question->Answer(row, checkpoint).value();
    for (size_t i = 0; i < found.values.size(); ++i) {
      EXPECT_EQ(distances[found.columns[i]], found.values[i]);
    }
  }
}

TEST_F(PairEngineTest, ARowHasItsMemoryBeforeItBegins) {
  const std::vector<PointPair> star(kFieldInSearches,
                                    {VertexPoint{0}, VertexPoint{99}});
  uint64_t used = 0;
  start_ = [&](const Mesh& mesh, const ValidQuery& query,
               const SolveOptions& options) {
    used = engine_.solver_memory().used();
    return StartComputation(mesh, query, options);
  };
  ASSERT_TRUE(Ask(star).ok());
  KeptSearches searches(*call_.mesh->mesh);
  const auto question =
      PairQuestion::Make(*call_.mesh->mesh, star, {}, searches, 1).value();
  EXPECT_EQ(used, question->PlannedBytes() + question->RowBytes());
}

TEST_F(PairEngineTest, KeepsItsSearchAndGivesItUpForOthers) {
  ExpectEuclid({{VertexPoint{0}, VertexPoint{50}}});
  EXPECT_EQ(engine_.searches().pool().idle(), 1);
  EXPECT_GT(engine_.solver_memory().used(), 0);
  ExpectEuclid({{VertexPoint{3}, VertexPoint{70}}});
  EXPECT_EQ(engine_.searches().pool().idle(), 1);
  clock_.Advance(SearchPool::kPatience);
  engine_.searches().pool().DropOld();
  EXPECT_EQ(engine_.solver_memory().used(), 0);
}

TEST_F(PairEngineTest, CancellingStopsTheSearches) {
  std::vector<PointPair> pairs;
  for (uint32_t i = 0; i < 100; ++i) {
    pairs.push_back({VertexPoint{i}, VertexPoint{120 - i}});
  }
  PairCall call = Start(pairs).value();
  int looks = 0;
  clock_.at_look = [&] {
    if (++looks == 20) call.rows->Cancel();
  };
  executor_.RunAll();
  clock_.at_look = nullptr;
  EXPECT_GT(call.work->answered.counts().searched, 0);
  EXPECT_LT(call.work->answered.counts().searched, 32);
  EXPECT_EQ(engine_.scheduler().running(), 0);
  EXPECT_EQ(engine_.scheduler().queued(), 0);
  // The search that was stopped answers the next question.
  ExpectEuclid(pairs);
}

TEST_F(PairEngineTest, DeadlinesHold) {
  auto call = engine_.rows()
                  .ComputePairs({.mesh_digest = digest_,
                                 .pairs = {{VertexPoint{0}, VertexPoint{1}}},
                                 .deadline = clock_.Now()},
                                [] {})
                  .value();
  executor_.RunAll();
  const auto row = call.rows->Take();
  ASSERT_TRUE(row.has_value());
  EXPECT_TRUE(absl::IsDeadlineExceeded(row->status()));
}

}  // namespace
}  // namespace geodesic::server
