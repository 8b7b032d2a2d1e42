// Fields that end at a radius or a target: cut, covered, in order.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <numbers>
#include <string>

#include "tests/engine/engine_fixture.h"
#include "tests/support/meshes/planar_meshes.h"

namespace geodesic::server {
namespace {

using test::RecordingObserver;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr uint32_t kSide = 20;  // cells

double Euclid(const Point& a, const Point& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

class LimitedFieldTest : public test::EngineTest {
 protected:
  using EngineTest::EngineTest;

  void SetUp() override {
    soup_ = geodesic::test::MakeGrid({.columns = kSide, .rows = kSide});
    digest_ = Upload(soup_).value().mesh.digest;
  }

  FieldRequest Request(FieldReach reach = {}) const {
    return {.mesh_digest = digest_,
            .query = {.sources = {{VertexPoint{0}, 0}}},
            .reach = reach};
  }

  // Asks and runs everything.
  struct Reply {
    FieldCall call;
    FieldAnswer answer;
  };
  Reply Ask(const FieldRequest& request) {
    const auto observer = std::make_shared<RecordingObserver>();
    const auto call = engine_.fields().Compute(request, observer);
    EXPECT_TRUE(call.ok()) << call.status();
    if (call->answer.has_value()) return {*call, *call->answer};
    executor_.RunAll();
    EXPECT_EQ(observer->calls, 1);
    EXPECT_TRUE(observer->answer->ok()) << observer->answer->status();
    return {*call, **observer->answer};
  }

  // Euclid up to `radius`; what lies beyond is infinite or right.
  void ExpectExactUpTo(const DistanceField& field, double radius) const {
    for (size_t v = 0; v < field.distances.size(); ++v) {
      const double expected = Euclid(soup_.positions[0], soup_.positions[v]);
      if (expected <= radius || field.distances[v] != kInfinity) {
        EXPECT_NEAR(field.distances[v], expected, 1e-10 * expected);
      }
    }
  }

  TriangleSoup soup_;
  std::string digest_;
};

TEST_F(LimitedFieldTest, EndsAtItsRadiusAndAnswersForLess) {
  const Reply reply = Ask(Request({.radius = 8}));
  EXPECT_EQ(reply.call.origin, FieldOrigin::kComputed);
  EXPECT_EQ(reply.answer.field->settled_radius, 8);
  ExpectExactUpTo(*reply.answer.field, 8);
  EXPECT_EQ(reply.answer.field->distances.back(), kInfinity);
  EXPECT_EQ(Ask(Request({.radius = 5})).call.origin, FieldOrigin::kCached);
  EXPECT_EQ(Ask(Request({.radius = 8})).call.origin, FieldOrigin::kCached);
  EXPECT_EQ(engine_.counters().solves_started, 1);
}

// Drawing the rest of the map would be work for nothing.
TEST_F(LimitedFieldTest, ALogMapEndsAtItsRadiusInAFieldThatReachesFurther) {
  FieldRequest request = Request();
  request.extras.log_map = true;
  Ask(request);
  request.reach.radius = 5;
  const Reply reply = Ask(request);
  EXPECT_EQ(reply.call.origin, FieldOrigin::kCached);
  const LogMap& map = reply.answer.derived->log_map;
  for (size_t v = 0; v < map.coordinates.size(); ++v) {
    EXPECT_EQ(std::isnan(map.coordinates[v][0]),
              reply.answer.field->distances[v] > 5)
        << v;
  }
}

TEST_F(LimitedFieldTest, AWiderOneTakesTheOthersPlace) {
  Ask(Request({.radius = 5}));
  const Reply all = Ask(Request());
  EXPECT_EQ(all.answer.origin, FieldOrigin::kComputed);
  EXPECT_EQ(all.answer.field->settled_radius, kInfinity);
  ExpectExactUpTo(*all.answer.field, kInfinity);
  EXPECT_EQ(engine_.fields().cache().size(), 1);
  EXPECT_EQ(Ask(Request({.radius = 5})).call.origin, FieldOrigin::kCached);
}

TEST_F(LimitedFieldTest, EqualLimitsShareAFlightAndOthersDoNot) {
  const auto a = std::make_shared<RecordingObserver>();
  const auto b = std::make_shared<RecordingObserver>();
  const auto c = std::make_shared<RecordingObserver>();
  ASSERT_TRUE(engine_.fields().Compute(Request({.radius = 5}), a).ok());
  const auto joined = engine_.fields().Compute(Request({.radius = 5}), b);
  EXPECT_EQ(joined->origin, FieldOrigin::kJoined);
  const auto other = engine_.fields().Compute(Request({.radius = 6}), c);
  EXPECT_EQ(other->origin, FieldOrigin::kComputed);
  executor_.RunAll();
  EXPECT_EQ(**a->field, **b->field);
  EXPECT_EQ((**c->field)->settled_radius, 6);
}

TEST_F(LimitedFieldTest, StopsWhenTargetsAreThere) {
  FieldRequest request = Request({.targets = 2});
  const double t = 0.25;
  // The last one is the corner farthest from the source.
  constexpr uint32_t kLast = (kSide + 1) * (kSide + 1) - 1;
  request.query.targets = {VertexPoint{3}, EdgePoint{1, 2, t},
                           VertexPoint{kLast}};
  const Reply reply = Ask(request);
  const DistanceField& field = *reply.answer.field;
  ASSERT_EQ(field.target_distances.size(), 3);
  EXPECT_NEAR(field.target_distances[0], 3, 1e-10);
  EXPECT_NEAR(field.target_distances[1], 1 + t, 1e-10);
  EXPECT_LT(field.settled_radius, kInfinity);
  ExpectExactUpTo(field, field.settled_radius);
  request.reach.targets = 3;
  const Reply more = Ask(request);
  EXPECT_EQ(more.call.origin, FieldOrigin::kComputed);
  EXPECT_NEAR(more.answer.field->target_distances[2],
              kSide * std::numbers::sqrt2, 1e-10);
}

TEST_F(LimitedFieldTest, AWholeFieldAnswersForVertexTargets) {
  Ask(Request());
  FieldRequest request = Request({.targets = 1});
  request.query.targets = {VertexPoint{7}};
  EXPECT_EQ(Ask(request).call.origin, FieldOrigin::kCached);
  request.reach = {};
  EXPECT_EQ(Ask(request).call.origin, FieldOrigin::kCached);
  request.query.targets = {EdgePoint{0, 1, 0.5}};
  EXPECT_EQ(Ask(request).call.origin, FieldOrigin::kComputed);
}

TEST_F(LimitedFieldTest, VerticesComeInOrderWhileItSolves) {
  FieldRequest request = Request({.radius = 12});
  request.extras.settled_order = true;
  const auto observer = std::make_shared<RecordingObserver>();
  const auto call = engine_.fields().Compute(request, observer);
  ASSERT_TRUE(call.ok()) << call.status();
  ASSERT_NE(call->settled, nullptr);
  executor_.RunAll();
  ASSERT_TRUE(observer->answer->ok());
  const auto settled = call->settled->Read(0, 10'000);
  uint32_t expected = 0;
  for (const Point& position : soup_.positions) {
    expected += Euclid(soup_.positions[0], position) <= 12;
  }
  EXPECT_EQ(settled.size(), expected);
  for (size_t i = 0; i < settled.size(); ++i) {
    EXPECT_NEAR(settled[i].distance,
                Euclid(soup_.positions[0], soup_.positions[settled[i].vertex]),
                1e-10);
    EXPECT_GE(settled[i].distance, settled[i == 0 ? 0 : i - 1].distance);
  }
  // The cache gives the same order.
  const auto again =
      engine_.fields().Compute(request, std::make_shared<RecordingObserver>());
  EXPECT_EQ(again->origin, FieldOrigin::kCached);
  executor_.RunAll();
  const auto cached = again->settled->Read(0, 10'000);
  ASSERT_EQ(cached.size(), settled.size());
  for (size_t i = 0; i < settled.size(); ++i) {
    EXPECT_EQ(cached[i].vertex, settled[i].vertex);
  }
  EXPECT_EQ(engine_.counters().solves_started, 1);
}

}  // namespace
}  // namespace geodesic::server
