// Around a pole wavefronts meet along every meridian. The windows that cross a
// meridian lose there by rounding alone, and are not to go on for ever.

#include "solver/rules/passed_windows.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <utility>

#include "geodesic/solve.h"
#include "tests/support/curved_meshes.h"
#include "tests/support/field_check.h"

namespace geodesic {
namespace {

DistanceField FromPole(const Mesh& mesh, Algorithm algorithm,
                       uint32_t threads = 1) {
  NoCheckpoint checkpoint;
  return Solve(mesh,
               Query{.sources = {{VertexPoint{0}}}, .algorithm = algorithm},
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

TEST(PassedWindows, KeepASampleUntilLateWindowsOftenLose) {
  constexpr uint32_t kHalfEdges = 1 << 20;
  PassedWindows passed(kHalfEdges);
  WindowBlock block{.next = nullptr, .count = 1, .log_room = 2};
  ASSERT_NE(passed.At(32), nullptr);
  EXPECT_EQ(passed.At(33), nullptr);
  *passed.At(32) = &block;
  for (int i = 0; i < 1000; ++i) passed.Count(100, 20);
  EXPECT_EQ(passed.At(33), nullptr);
  for (int i = 0; i < 10; ++i) passed.Count(100, 80);
  ASSERT_NE(passed.At(33), nullptr);
  EXPECT_EQ(*passed.At(33), nullptr);
  EXPECT_EQ(*passed.At(32), &block);
}

}  // namespace
}  // namespace geodesic
