// Fields within a tolerance: an exact field answers for them, they never answer
// for an exact one, nor one tolerance for another, in memory and on disk.

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "tests/engine/durable_fixture.h"
#include "tests/support/meshes/curved_meshes.h"

namespace geodesic::server {
namespace {

using test::RecordingObserver;

class EngineToleranceTest : public test::HeldMeshTest {
 protected:
  void SetUp() override {
    HeldMeshTest::SetUp();
    Hold(geodesic::test::Terrain(30, 30, 0.6, 3));
  }

  // The field from vertex 0.
  FieldAnswer Within(double tolerance, FieldRequest request = {}) {
    request.mesh_digest = mesh_->digest;
    request.query.tolerance = tolerance;
    const absl::StatusOr<FieldAnswer> answer = Field(std::move(request));
    EXPECT_TRUE(answer.ok()) << answer.status();
    return answer.ok() ? *answer : FieldAnswer();
  }

  // Whether the truth is within what is certified, and that within `tolerance`.
  static void ExpectCertified(const DistanceField& field, double tolerance,
                              const DistanceField& exact) {
    EXPECT_GT(field.certified_error, 0);
    EXPECT_LE(field.certified_error, tolerance);
    ASSERT_EQ(field.certified_errors.size(), exact.distances.size());
    for (size_t v = 0; v < exact.distances.size(); ++v) {
      if (std::isinf(field.distances[v])) continue;
      EXPECT_LE(field.certified_errors[v], field.certified_error);
      EXPECT_LE(std::abs(field.distances[v] - exact.distances[v]),
                field.certified_errors[v] * exact.distances[v])
          << v;
    }
  }
};

TEST_F(EngineToleranceTest, AnExactFieldAnswersForATolerance) {
  const FieldAnswer exact = Within(0);
  EXPECT_EQ(exact.field->certified_error, 0);
  const FieldAnswer answer = Within(1e-3);
  EXPECT_EQ(answer.origin, FieldOrigin::kCached);
  EXPECT_EQ(answer.field, exact.field);
}

TEST_F(EngineToleranceTest, SoDoesOneThatKeepsPaths) {
  const FieldAnswer traced = Within(0, {.extras = {.gradients = true}});
  const FieldAnswer answer =
      Within(1e-3, {.query = {.targets = {VertexPoint{9}}}});
  EXPECT_EQ(answer.origin, FieldOrigin::kCached);
  EXPECT_EQ(answer.field, traced.field);
}

// What is certified of each vertex lies beside its distance.
TEST_F(EngineToleranceTest, TheyTakeMoreOfTheCache) {
  const FieldCache& cache = engine().fields().cache();
  Within(1e-2);
  const uint64_t within = cache.used_bytes();
  Within(0);
  const uint64_t exact = cache.used_bytes() - within;
  EXPECT_GE(within, exact + mesh_->mesh->vertex_count() * sizeof(float));
}

TEST_F(EngineToleranceTest, NoFieldWithinOneAnswersForAnother) {
  const FieldAnswer fine = Within(1e-5);
  const FieldAnswer coarse = Within(1e-2);
  EXPECT_EQ(fine.origin, FieldOrigin::kComputed);
  EXPECT_EQ(coarse.origin, FieldOrigin::kComputed);
  EXPECT_EQ(engine().fields().FindWhole(*mesh_, VertexPoint{0}), nullptr)
      << "pairs are exact";
  const FieldAnswer exact = Within(0);
  EXPECT_EQ(exact.origin, FieldOrigin::kComputed);
  ExpectCertified(*fine.field, 1e-5, *exact.field);
  ExpectCertified(*coarse.field, 1e-2, *exact.field);
  EXPECT_GT(coarse.field->certified_error, 1e-5);
  // Each has its own, also beside the exact one.
  EXPECT_EQ(Within(1e-5).field, fine.field);
  EXPECT_EQ(Within(1e-2).field, coarse.field);
  EXPECT_EQ(Within(0).field, exact.field);
}

TEST_F(EngineToleranceTest, NorDoThoseOnDisk) {
  const FieldAnswer coarse = Within(1e-2);
  RestartWithMesh();
  const FieldAnswer fine = Within(1e-4);
  EXPECT_EQ(fine.origin, FieldOrigin::kComputed);
  const FieldAnswer exact = Within(0);
  EXPECT_EQ(exact.origin, FieldOrigin::kComputed);
  ExpectCertified(*coarse.field, 1e-2, *exact.field);
  RestartWithMesh();
  const FieldAnswer again = Within(1e-2);
  EXPECT_EQ(again.origin, FieldOrigin::kCached);
  EXPECT_EQ(again.field->distances, coarse.field->distances);
  EXPECT_EQ(again.field->certified_errors, coarse.field->certified_errors);
  EXPECT_EQ(again.field->certified_error, coarse.field->certified_error);
  EXPECT_EQ(Within(0).field->distances, exact.field->distances);
  // A tolerance that nobody has asked for: the exact one answers from disk.
  RestartWithMesh();
  const FieldAnswer other = Within(0.05);
  EXPECT_EQ(other.origin, FieldOrigin::kCached);
  EXPECT_EQ(other.field->distances, exact.field->distances);
  EXPECT_EQ(other.field->certified_error, 0);
}

TEST_F(EngineToleranceTest, LimitsAreCertified) {
  constexpr double kRadius = 12;
  const FieldAnswer near = Within(1e-3, {.reach = {.radius = kRadius}});
  EXPECT_EQ(near.field->settled_radius, kRadius);
  EXPECT_EQ(Within(1e-3, {.reach = {.radius = kRadius / 2}}).field, near.field);
  EXPECT_EQ(Within(1e-3).origin, FieldOrigin::kComputed) << "it reaches on";
  const DistanceField exact = *Within(0).field;
  ExpectCertified(*near.field, 1e-3, exact);
  for (size_t v = 0; v < exact.distances.size(); ++v) {
    EXPECT_EQ(std::isinf(near.field->distances[v]),
              exact.distances[v] > kRadius)
        << v;
  }
}

TEST_F(EngineToleranceTest, WhatItDoesNotHaveIsRefusedByName) {
  const auto refusal = [&](FieldExtras extras) {
    const absl::Status status =
        engine()
            .fields()
            .Compute(
                {.mesh_digest = mesh_->digest,
                 .query = {.sources = {{VertexPoint{0}}}, .tolerance = 1e-3},
                 .extras = extras},
                std::make_shared<RecordingObserver>())
            .status();
    EXPECT_TRUE(absl::IsInvalidArgument(status)) << status;
    return std::string(status.message()).substr(0, 11);
  };
  EXPECT_EQ(refusal({.settled_order = true}), "progressive");
  EXPECT_EQ(refusal({.gradients = true}), "quantities:");
  EXPECT_EQ(refusal({.nearest_sources = true}), "quantities:");
}

}  // namespace
}  // namespace geodesic::server
