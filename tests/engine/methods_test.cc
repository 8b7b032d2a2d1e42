// Approximate methods are prepared once, kept within their budget and on disk,
// and their fields never pass for exact ones.

#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "server/engine/base/status_details.h"
#include "server/engine/methods/method_engine.h"
#include "tests/engine/durable_fixture.h"
#include "tests/support/meshes/curved_meshes.h"

namespace geodesic::server {
namespace {

using test::RecordingObserver;

constexpr MethodChoice kFmm = {.method = ApproximateMethod::kFmm};
constexpr MethodChoice kHeat = {.method = ApproximateMethod::kHeat};
constexpr MethodChoice kGraph = {.method = ApproximateMethod::kSvg,
                                 .neighbours = 20};

class MethodsTest : public test::HeldMeshTest {
 protected:
  using Told = std::optional<absl::StatusOr<MethodHandle>>;

  void SetUp() override {
    HeldMeshTest::SetUp();
    Hold(geodesic::test::Icosphere(3));
  }

  absl::StatusOr<MethodJobs::Ticket> Ask(const MethodChoice& choice,
                                         std::shared_ptr<Told> told) {
    return engine().methods().Prepare(
        mesh_, choice,
        {.done = [told](const absl::StatusOr<MethodHandle>& p) { *told = p; }},
        {});
  }

  absl::StatusOr<MethodHandle> Prepare(const MethodChoice& choice) {
    const auto told = std::make_shared<Told>();
    const auto ticket = Ask(choice, told);
    if (!ticket.ok()) return ticket.status();
    executor_.RunAll();
    return told->value_or(absl::UnknownError("not told"));
  }

  // The field from vertex 0; exact without a choice.
  FieldAnswer FieldBy(const std::optional<MethodChoice>& choice) {
    FieldRequest request{.mesh_digest = mesh_->digest};
    if (choice.has_value()) request.method = *Prepare(*choice);
    const absl::StatusOr<FieldAnswer> answer = Field(std::move(request));
    EXPECT_TRUE(answer.ok()) << answer.status();
    return answer.ok() ? *answer : FieldAnswer();
  }

  const MethodStore& store() { return engine().meshes().methods(); }
};

TEST_F(MethodsTest, EqualPreparationsAreOne) {
  const auto a = std::make_shared<Told>(), b = std::make_shared<Told>(),
             other = std::make_shared<Told>();
  ASSERT_TRUE(Ask(kHeat, a).ok());
  ASSERT_TRUE(Ask(kHeat, b).ok());
  MethodChoice smoother = kHeat;
  smoother.lambda = 10;
  ASSERT_TRUE(Ask(smoother, other).ok());
  executor_.RunAll();
  ASSERT_TRUE((*a)->ok() && (*b)->ok() && (*other)->ok());
  EXPECT_EQ((**a)->method, (**b)->method);
  EXPECT_NE((**a)->method, (**other)->method);
  EXPECT_EQ(engine().methods().made(), 2);
  EXPECT_EQ(Prepare(kHeat)->method, (**a)->method) << "it was there";
  EXPECT_EQ(engine().methods().made(), 2);
}

TEST_F(MethodsTest, NobodyWaitingStopsTheWork) {
  const auto told = std::make_shared<Told>();
  const auto ticket = Ask(kGraph, told);
  ASSERT_TRUE(ticket.ok());
  // At its first look at the clock the job is under way.
  clock_.at_look = [&] {
    clock_.at_look = nullptr;
    engine().methods().Leave(*ticket);
  };
  executor_.RunAll();
  EXPECT_FALSE(told->has_value());
  EXPECT_EQ(engine().methods().made(), 0);
  EXPECT_EQ(store().size(), 0);
  EXPECT_EQ(engine().solver_memory().used(), 0);
}

TEST_F(MethodsTest, FieldsOfDifferentAccuracyNeverAnswerEachOther) {
  const FieldAnswer exact = FieldBy(std::nullopt);
  const FieldAnswer marched = FieldBy(kFmm);
  const FieldAnswer heated = FieldBy(kHeat);
  MethodChoice smoother = kHeat;
  smoother.lambda = 10;
  const FieldAnswer smooth = FieldBy(smoother);
  for (const FieldAnswer* answer : {&exact, &marched, &heated, &smooth}) {
    EXPECT_EQ(answer->origin, FieldOrigin::kComputed);
  }
  EXPECT_NE(exact.field->distances, marched.field->distances);
  EXPECT_NE(exact.field->distances, heated.field->distances);
  EXPECT_NE(heated.field->distances, smooth.field->distances);
  EXPECT_EQ(FieldBy(std::nullopt).field, exact.field);
  EXPECT_EQ(FieldBy(kHeat).field, heated.field);
  EXPECT_EQ(FieldBy(smoother).field, smooth.field);
  EXPECT_EQ(engine().fields().FindWhole(*mesh_, VertexPoint{0}), exact.field);
  EXPECT_EQ(engine().fields().FindWhole(*mesh_, VertexPoint{1}), nullptr);
}

TEST_F(MethodsTest, NorDoThoseOnDisk) {
  const std::vector<double> marched = FieldBy(kFmm).field->distances;
  RestartWithMesh();
  const FieldAnswer exact = FieldBy(std::nullopt);
  EXPECT_EQ(exact.origin, FieldOrigin::kComputed);
  EXPECT_NE(exact.field->distances, marched);
  RestartWithMesh();
  EXPECT_EQ(FieldBy(kHeat).origin, FieldOrigin::kComputed);
  const FieldAnswer again = FieldBy(kFmm);
  EXPECT_EQ(again.origin, FieldOrigin::kCached);
  EXPECT_EQ(again.field->distances, marched);
  EXPECT_EQ(FieldBy(std::nullopt).field->distances, exact.field->distances);
}

// Before anything is prepared for them, too.
TEST_F(MethodsTest, ApproximateFieldsRefuseWhatTheyCannotDo) {
  for (const MethodHandle& method :
       {*Prepare(kFmm), MethodHandle{.mesh = mesh_, .choice = kHeat}}) {
    const auto refusal = [&](FieldRequest request) {
      request.mesh_digest = mesh_->digest;
      request.method = method;
      if (request.query.sources.empty()) {
        request.query.sources = {{VertexPoint{0}}};
      }
      return engine()
          .fields()
          .Compute(request, std::make_shared<RecordingObserver>())
          .status();
    };
    EXPECT_TRUE(
        absl::IsInvalidArgument(refusal({.extras = {.settled_order = true}})));
    EXPECT_TRUE(
        absl::IsInvalidArgument(refusal({.extras = {.gradients = true}})));
    EXPECT_TRUE(absl::IsInvalidArgument(refusal(
        {.query = {.targets = {VertexPoint{1}}}, .reach = {.targets = 1}})));
    EXPECT_TRUE(absl::IsInvalidArgument(
        refusal({.query = {.targets = {FacePoint{0, {0.25, 0.25, 0.5}}}}})));
    const Triangle& corners = mesh_->mesh->triangle(0);
    EXPECT_TRUE(absl::IsInvalidArgument(
        refusal({.query = {.sources = {{Curve{{VertexPoint{corners[0]},
                                               VertexPoint{corners[1]}}}}}}})));
    const absl::Status good = refusal({.query = {.targets = {VertexPoint{1}}}});
    EXPECT_EQ(good.ok(), method.method != nullptr) << good;
    EXPECT_EQ(IsNotPrepared(good), method.method == nullptr) << good;
  }
  executor_.RunAll();
}

TEST_F(MethodsTest, GraphsOutliveTheServer) {
  const absl::StatusOr<MethodHandle> built = Prepare(kGraph);
  ASSERT_TRUE(built.ok()) << built.status();
  const std::vector<double> distances = FieldBy(kGraph).field->distances;
  EXPECT_EQ(engine().methods().made(), 1);
  RestartWithMesh();
  EXPECT_EQ(store().size(), 0);
  EXPECT_EQ(Prepare(kGraph)->method->method(), ApproximateMethod::kSvg);
  EXPECT_EQ(engine().methods().loaded(), 1);
  EXPECT_EQ(engine().methods().made(), 0);
  const auto& graph =
      static_cast<const SaddleVertexGraph&>(*Prepare(kGraph)->method);
  const absl::StatusOr<ValidQuery> query =
      ValidQuery::Make({.sources = {{VertexPoint{0}}}}, *mesh_->mesh);
  NoCheckpoint checkpoint;
  EXPECT_EQ(graph.Distances(*query, checkpoint)->distances, distances);
  MethodChoice wider = kGraph;
  wider.neighbours = 21;
  ASSERT_TRUE(Prepare(wider).ok());
  EXPECT_EQ(engine().methods().made(), 1) << "another K is another graph";
}

TEST_F(MethodsTest, AMeshTakesAllOfItAlong) {
  ASSERT_TRUE(Prepare(kGraph).ok());
  ASSERT_TRUE(Prepare(kHeat).ok());
  EXPECT_EQ(engine().meshes().Describe(mesh_->digest)->methods.size(), 2);
  EXPECT_GT(store().used_bytes(), 0);
  const std::string digest = std::exchange(mesh_, nullptr)->digest;
  ASSERT_TRUE(Delete(digest).ok());
  EXPECT_EQ(store().size(), 0);
  EXPECT_EQ(store().used_bytes(), 0);
  Hold(geodesic::test::Icosphere(3));
  ASSERT_TRUE(Prepare(kGraph).ok());
  EXPECT_EQ(engine().methods().loaded(), 0) << "its file is gone";
}

TEST_F(MethodsTest, WhatCannotBePreparedSaysWhy) {
  MethodChoice bad = kHeat;
  bad.lambda = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(absl::IsInvalidArgument(Prepare(bad).status()));
  MethodChoice none = kGraph;
  none.neighbours = 0;
  EXPECT_TRUE(absl::IsInvalidArgument(Prepare(none).status()));
  EXPECT_EQ(store().size(), 0);
}

TEST_F(MethodsTest, TheBudgetHoldsTheLatest) {
  const uint64_t heat_bytes = Prepare(kHeat)->method->bytes();
  limits_.prepared_memory_bytes = heat_bytes + heat_bytes / 2;
  RestartWithMesh();
  ASSERT_TRUE(Prepare(kHeat).ok());
  MethodChoice smoother = kHeat;
  smoother.lambda = 10;
  ASSERT_TRUE(Prepare(smoother).ok());
  EXPECT_EQ(store().size(), 1);
  EXPECT_EQ(store().evictions(), 1);
  EXPECT_FALSE(engine().methods().Find(mesh_, kHeat).has_value());
  EXPECT_TRUE(engine().methods().Find(mesh_, smoother).has_value());

  limits_.prepared_memory_bytes = heat_bytes / 2;
  RestartWithMesh();
  const absl::Status refused = Prepare(kHeat).status();
  EXPECT_TRUE(absl::IsResourceExhausted(refused)) << refused;
  EXPECT_NE(refused.message().find("--limit prepared-memory"),
            std::string::npos);
}

}  // namespace
}  // namespace geodesic::server
