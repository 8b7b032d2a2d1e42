// Paths to few targets, which are searched for. On the grid geodesics are
// straight, so every distance is Euclid's.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <memory>
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

double Euclid(const Point& a, const Point& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

class FoundPathsTest : public test::EngineTest {
 protected:
  void SetUp() override {
    digest_ = Upload(MakeGrid({.columns = 10, .rows = 10})).value().mesh.digest;
    mesh_ = *engine_.meshes().Get(digest_);
  }

  FieldRequest PathsTo(std::vector<SurfacePoint> targets) const {
    FieldRequest request{.mesh_digest = digest_, .extras = {.paths = true}};
    request.query.sources = {{VertexPoint{0}}};
    request.reach.targets = targets.size();
    request.query.targets = std::move(targets);
    return request;
  }

  // The answer, computed to its end.
  FieldAnswer Ask(const FieldRequest& request) {
    const auto observer = std::make_shared<RecordingObserver>();
    const auto call = engine_.fields().Compute(request, observer);
    EXPECT_TRUE(call.ok()) << call.status();
    executor_.RunAll();
    EXPECT_TRUE(observer->answer.has_value());
    EXPECT_TRUE(observer->answer->ok()) << observer->answer->status();
    return **observer->answer;
  }

  Point PositionOf(const SurfacePoint& point) const {
    return geodesic::PositionOf(point, *mesh_->mesh);
  }

  std::string digest_;
  MeshHandle mesh_;
};

TEST_F(FoundPathsTest, AreStraightAndLeaveNoField) {
  const std::vector<SurfacePoint> targets{
      VertexPoint{120}, FacePoint{7, {0.2, 0.3, 0.5}}, EdgePoint{3, 4, 0.25}};
  {
    const FieldAnswer answer = Ask(PathsTo(targets));
    EXPECT_EQ(answer.origin, FieldOrigin::kComputed);
    EXPECT_FALSE(answer.derived->paths.has_value());
    const std::vector<GeodesicPath>& paths = answer.derived->found_paths;
    ASSERT_EQ(paths.size(), targets.size());
    for (size_t t = 0; t < targets.size(); ++t) {
      const double distance =
          Euclid(PositionOf(VertexPoint{0}), PositionOf(targets[t]));
      EXPECT_NEAR(paths[t].distance, distance, 1e-12) << t;
      EXPECT_EQ(paths[t].distance, answer.field->target_distances[t]);
      ASSERT_GE(paths[t].positions.size(), 2);
      double length = 0;
      for (size_t i = 1; i < paths[t].positions.size(); ++i) {
        length += Euclid(paths[t].positions[i - 1], paths[t].positions[i]);
      }
      EXPECT_NEAR(length, distance, 1e-12) << t;
      EXPECT_LT(Euclid(paths[t].positions.back(), PositionOf(targets[t])),
                1e-12);
    }
    engine_.searches().pool().DropIdle();
    EXPECT_GE(engine_.solver_memory().used(), BytesOf(paths));
  }
  EXPECT_EQ(engine_.fields().cache().size(), 0);
  EXPECT_EQ(engine_.solver_memory().used(), 0);
}

TEST_F(FoundPathsTest, ComeFromAFieldThatIsThere) {
  FieldRequest whole = PathsTo({});
  whole.reach = {};
  Ask(whole);
  const FieldAnswer answer = Ask(PathsTo({VertexPoint{120}}));
  EXPECT_EQ(answer.origin, FieldOrigin::kCached);
  EXPECT_TRUE(answer.derived->paths.has_value());
}

TEST_F(FoundPathsTest, ManyTargetsOrARadiusTakeAField) {
  std::vector<SurfacePoint> many;
  for (uint32_t i = 0; i < kFieldInSearches; ++i) {
    many.push_back(VertexPoint{9 * i});
  }
  EXPECT_TRUE(Ask(PathsTo(std::move(many))).derived->paths.has_value());
  EXPECT_EQ(engine_.fields().cache().size(), 1);
  FieldRequest near = PathsTo({VertexPoint{119}});
  near.query.sources = {{VertexPoint{1}}};
  near.reach.radius = 3;
  EXPECT_TRUE(Ask(near).derived->paths.has_value());
  EXPECT_EQ(engine_.fields().cache().size(), 2);
}

TEST_F(FoundPathsTest, EqualQuestionsShareASearch) {
  const auto a = std::make_shared<RecordingObserver>();
  const auto b = std::make_shared<RecordingObserver>();
  const FieldRequest request = PathsTo({VertexPoint{120}});
  ASSERT_TRUE(engine_.fields().Compute(request, a).ok());
  ASSERT_EQ(engine_.fields().Compute(request, b)->origin, FieldOrigin::kJoined);
  executor_.RunAll();
  EXPECT_EQ((*a->answer)->derived, (*b->answer)->derived);
}

}  // namespace
}  // namespace geodesic::server
