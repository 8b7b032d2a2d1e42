// The part of QueryEngine that deals with fields.

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "geodesic/solve.h"
#include "server/engine/base/status_details.h"
#include "tests/engine/engine_fixture.h"
#include "tests/support/meshes/curved_meshes.h"

namespace geodesic::server {
namespace {

using test::RecordingObserver;

Source At(uint32_t vertex, double offset = 0) {
  return {VertexPoint{vertex}, offset};
}

class FieldQueryTest : public test::EngineTest {
 protected:
  using EngineTest::EngineTest;

  void SetUp() override {
    digest_ = Upload(geodesic::test::Icosphere(2)).value().mesh.digest;
  }

  absl::StatusOr<FieldCall> Ask(
      uint32_t vertex, const std::shared_ptr<RecordingObserver>& observer,
      TimePoint deadline = kNoDeadline) {
    return engine_.fields().Compute(
        {.mesh_digest = digest_,
         .query = {.sources = {{VertexPoint{vertex}, 0}}},
         .deadline = deadline},
        observer);
  }

  std::string digest_;
  std::shared_ptr<RecordingObserver> a_ = std::make_shared<RecordingObserver>();
  std::shared_ptr<RecordingObserver> b_ = std::make_shared<RecordingObserver>();
};

TEST_F(FieldQueryTest, SolvesExactly) {
  const auto call = Ask(0, a_);
  ASSERT_TRUE(call.ok()) << call.status();
  EXPECT_EQ(call->origin, FieldOrigin::kComputed);
  EXPECT_EQ(call->mesh->mesh->vertex_count(), 162);
  EXPECT_EQ(a_->calls, 0);
  executor_.RunAll();
  ASSERT_TRUE(a_->field.has_value());
  ASSERT_TRUE(a_->field->ok()) << a_->field->status();
  NoCheckpoint checkpoint;
  const auto direct = Solve(*(*engine_.meshes().Get(digest_))->mesh,
                            {.sources = {{VertexPoint{0}, 0}}}, {}, checkpoint);
  EXPECT_EQ((**a_->field)->distances, direct->distances);
  EXPECT_EQ(engine_.counters().solves_finished, 1);
}

TEST_F(FieldQueryTest, TheCacheAnswersTheSecondTime) {
  ASSERT_TRUE(Ask(0, a_).ok());
  executor_.RunAll();
  const auto again = Ask(0, b_);
  ASSERT_TRUE(again.ok());
  EXPECT_EQ(again->origin, FieldOrigin::kCached);
  EXPECT_EQ(again->answer->field, **a_->field);
  EXPECT_EQ(b_->calls, 0);
  EXPECT_EQ(engine_.counters().solves_started, 1);
  EXPECT_EQ(executor_.size(), 0);
}

TEST_F(FieldQueryTest, TheOrderOfSourcesDoesNotMatter) {
  const auto ask = [&](std::vector<Source> sources) {
    const auto call = engine_.fields().Compute(
        {digest_, {.sources = std::move(sources)}}, a_);
    executor_.RunAll();
    return call->origin;
  };
  EXPECT_EQ(ask({At(1, 0.5), At(0)}), FieldOrigin::kComputed);
  EXPECT_EQ(ask({At(0), At(1, 0.5), At(1, 0.75)}), FieldOrigin::kCached);
  EXPECT_EQ(ask({At(0), At(1, 0.25)}), FieldOrigin::kComputed);
}

TEST_F(FieldQueryTest, AlgorithmsAreDifferentQuestions) {
  ASSERT_TRUE(Ask(0, a_).ok());
  const auto other = engine_.fields().Compute(
      {digest_,
       {.sources = {{VertexPoint{0}, 0}}, .algorithm = Algorithm::kMmp}},
      b_);
  ASSERT_TRUE(other.ok());
  EXPECT_EQ(other->origin, FieldOrigin::kComputed);
  EXPECT_EQ(other->query->algorithm, Algorithm::kMmp);
}

TEST_F(FieldQueryTest, DeletingAMeshDropsItsFieldsOnly) {
  const std::string other = Upload(test::Tetrahedron())->mesh.digest;
  ASSERT_TRUE(Ask(0, a_).ok());
  ASSERT_TRUE(engine_.fields()
                  .Compute({other, {.sources = {{VertexPoint{0}, 0}}}}, b_)
                  .ok());
  executor_.RunAll();
  EXPECT_EQ(engine_.fields().cache().size(), 2);
  EXPECT_TRUE(Delete(digest_).ok());
  EXPECT_EQ(engine_.fields().cache().size(), 1);
}

TEST_F(FieldQueryTest, ADeletedMeshServesThoseWhoUseIt) {
  ASSERT_TRUE(Ask(0, a_).ok());
  EXPECT_TRUE(Delete(digest_).ok());
  executor_.RunAll();
  EXPECT_TRUE(a_->field->ok());
  EXPECT_EQ(engine_.fields().cache().size(), 0);
  EXPECT_TRUE(absl::IsNotFound(Ask(0, b_).status()));
}

TEST_F(FieldQueryTest, DrainingFinishesWhatIsThereAndTakesNothingNew) {
  ASSERT_TRUE(Ask(0, a_).ok());
  engine_.scheduler().BeginDrain();
  EXPECT_TRUE(absl::IsUnavailable(Ask(1, b_).status()));
  executor_.RunAll();
  EXPECT_TRUE(a_->field->ok());
  EXPECT_TRUE(engine_.scheduler().WaitIdle(std::chrono::milliseconds(0)));
  EXPECT_EQ(Ask(0, b_)->origin, FieldOrigin::kCached);
}

class TinyCacheTest : public FieldQueryTest {
 protected:
  // Room for two fields of 162 vertices.
  static Limits TinyCache() {
    Limits limits = SmallLimits();
    limits.field_cache_bytes = 4000;
    return limits;
  }
  TinyCacheTest() : FieldQueryTest(TinyCache()) {}
};

// Slow readers hold fields; they must not add up beyond the budget.
TEST_F(TinyCacheTest, FieldsInUseBoundWhatIsSolved) {
  ASSERT_TRUE(Ask(0, a_).ok());
  ASSERT_TRUE(Ask(1, b_).ok());
  executor_.RunAll();
  const auto c = std::make_shared<RecordingObserver>();
  ASSERT_TRUE(Ask(2, c).ok());
  executor_.RunAll();
  EXPECT_TRUE(absl::IsResourceExhausted(c->field->status()));
  EXPECT_TRUE(RetryAfter(c->field->status()).has_value());
  EXPECT_EQ(engine_.counters().solves_started, 2);
  a_->field.reset();
  a_->answer.reset();
  ASSERT_TRUE(Ask(2, c).ok());
  executor_.RunAll();
  EXPECT_TRUE(c->field->ok());
}

}  // namespace
}  // namespace geodesic::server
