// Paths that are traced from a field: in jobs of their own, as they are taken.
// On the grid geodesics are straight, so every distance is Euclid's.

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "geodesic/surface_point.h"
#include "tests/engine/engine_fixture.h"
#include "tests/support/meshes/planar_meshes.h"

namespace geodesic::server {
namespace {

using geodesic::test::MakeGrid;
using test::RecordingObserver;

class TracedPathsTest : public test::EngineTest {
 protected:
  static constexpr uint32_t kSide = 10;

  // Vertices and a place in a face, 40 in all, as far as `radius`.
  void Ask(double radius) {
    const auto uploaded = Upload(MakeGrid({.columns = kSide, .rows = kSide}));
    ASSERT_TRUE(uploaded.ok()) << uploaded.status();
    mesh_ = *engine_.meshes().Get(uploaded->mesh.digest);
    FieldRequest request{.mesh_digest = uploaded->mesh.digest,
                         .reach = {.radius = radius},
                         .extras = {.paths = true}};
    request.query.sources = {{VertexPoint{0}}};
    for (uint32_t i = 0; i < 39; ++i) {
      request.query.targets.push_back(VertexPoint{3 * i + 1});
    }
    request.query.targets.insert(request.query.targets.begin() + 20,
                                 FacePoint{7, {0.2, 0.3, 0.5}});
    const auto observer = std::make_shared<RecordingObserver>();
    call_ = *engine_.fields().Compute(request, observer);
    executor_.RunAll();
    answer_ = **observer->answer;
    ASSERT_TRUE(answer_.derived->paths.has_value());
  }

  std::shared_ptr<RowPipeline> Trace(
      TimePoint deadline = kNoDeadline,
      std::shared_ptr<const void> account = nullptr) {
    return *engine_.rows().TracePaths(
        *call_, answer_, deadline,
        {.client = "a", .account = std::move(account)}, [] {});
  }

  // In all rows, in order.
  std::vector<GeodesicPath> TakeAll(RowPipeline& rows) {
    std::vector<GeodesicPath> paths;
    while (paths.size() < call_->query->targets.size()) {
      executor_.RunAll();
      auto row = rows.Take();
      EXPECT_TRUE(row.has_value() && row->ok());
      if (!row.has_value() || !row->ok()) break;
      EXPECT_GE((*row)->memory.bytes(), BytesOf((*row)->paths));
      for (GeodesicPath& path : (*row)->paths) paths.push_back(std::move(path));
    }
    return paths;
  }

  MeshHandle mesh_;
  std::optional<FieldCall> call_;
  FieldAnswer answer_;
};

TEST_F(TracedPathsTest, LeadToTheirTargetsInOrder) {
  constexpr double kRadius = 9;
  Ask(30);  // a field that is there may reach further
  Ask(kRadius);
  const auto rows = Trace();
  EXPECT_FALSE(rows->Take().has_value()) << "no job has run";
  const std::vector<GeodesicPath> paths = TakeAll(*rows);
  for (size_t t = 0; t < paths.size(); ++t) {
    const Point target = PositionOf(call_->query->targets[t], *mesh_->mesh);
    const double distance = std::hypot(target[0], target[1]);
    if (distance > kRadius) {
      EXPECT_TRUE(std::isinf(paths[t].distance)) << t;
      EXPECT_TRUE(paths[t].points.empty()) << t;
    } else {
      EXPECT_NEAR(paths[t].distance, distance, 1e-12) << t;
      EXPECT_EQ(paths[t].points.back(), call_->query->targets[t]) << t;
    }
  }
}

// Each path along the strip has far more points than the strip has vertices.
class LongPathsTest : public test::EngineTest {
 protected:
  static Limits LittleMemory() {
    Limits limits = SmallLimits();
    limits.solver_memory_bytes = 2 << 20;
    return limits;
  }
  LongPathsTest() : EngineTest(LittleMemory()) {}
};

TEST_F(LongPathsTest, BeyondTheMemoryOfSolversAreRefused) {
  constexpr uint32_t kCells = 4000;
  const auto uploaded = Upload(MakeGrid({.columns = kCells, .rows = 1}));
  ASSERT_TRUE(uploaded.ok()) << uploaded.status();
  FieldRequest request{.mesh_digest = uploaded->mesh.digest,
                       .extras = {.paths = true}};
  request.query.sources = {{VertexPoint{0}}};
  request.query.targets.assign(16, VertexPoint{2 * kCells + 1});
  const auto observer = std::make_shared<RecordingObserver>();
  const FieldCall call = *engine_.fields().Compute(request, observer);
  executor_.RunAll();
  ASSERT_TRUE((*observer->answer).ok()) << observer->answer->status();
  const auto rows = *engine_.rows().TracePaths(call, **observer->answer,
                                               kNoDeadline, {}, [] {});
  executor_.RunAll();
  const auto row = rows->Take();
  ASSERT_TRUE(row.has_value());
  EXPECT_TRUE(absl::IsResourceExhausted(row->status())) << row->status();
}

TEST_F(TracedPathsTest, GoOnWhileTheServerDrains) {
  Ask(30);
  engine_.scheduler().BeginDrain();
  EXPECT_EQ(TakeAll(*Trace()).size(), call_->query->targets.size());
}

TEST_F(TracedPathsTest, StopAtTheirDeadline) {
  Ask(30);
  const auto rows = Trace(clock_.Now() + std::chrono::seconds(1));
  clock_.Advance(std::chrono::seconds(1));
  executor_.RunAll();
  EXPECT_TRUE(absl::IsDeadlineExceeded(rows->Take()->status()));
}

TEST_F(TracedPathsTest, AreDroppedWhenNobodyWaits) {
  Ask(30);
  const auto rows = Trace();
  rows->Cancel();
  EXPECT_EQ(engine_.scheduler().queued(), 0);
}

TEST_F(TracedPathsTest, CountForTheirClientUntilTheLastIsThere) {
  Ask(30);
  auto account = std::make_shared<int>(0);
  const std::weak_ptr<const void> held = account;
  const auto rows = Trace(kNoDeadline, std::move(account));
  EXPECT_FALSE(held.expired());
  TakeAll(*rows);
  EXPECT_TRUE(held.expired());
}

}  // namespace
}  // namespace geodesic::server
