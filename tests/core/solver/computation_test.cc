// Computations that go on: after a limit, after a cancellation, with more
// sources. What they say in the end is what one computation says at once.

#include "geodesic/computation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "tests/core/solver/computation_fixture.h"
#include "tests/core/solver/computation_scenes.h"
#include "tests/support/curved_meshes.h"
#include "tests/support/mesh_edits.h"
#include "tests/support/surface_points.h"

namespace geodesic::test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Says stop at one poll.
class StoppingCheckpoint final : public Checkpoint {
 public:
  explicit StoppingCheckpoint(uint64_t stop_at) : stop_at_(stop_at) {}

  absl::Status Poll(const Progress& progress) override {
    told_ = progress.settled_radius;
    return polls_++ == stop_at_ ? absl::CancelledError("stopped here")
                                : absl::OkStatus();
  }

  // What the last poll was told.
  double settled_radius() const { return told_; }

 private:
  const uint64_t stop_at_;
  uint64_t polls_ = 0;
  double told_ = 0;
};

class ComputationTest : public ComputationFixture {};

TEST_P(ComputationTest, InStepsIsBitForBitWhatItIsAtOnce) {
  for (const ComputationScene& scene : ComputationScenes()) {
    const Query query = WithAlgorithm(scene.query);
    const DistanceField whole = WholeField(*scene.mesh, query);
    const double far = Farthest(whole);
    const auto computation = StartOrFail(*scene.mesh, query);
    ASSERT_NE(computation, nullptr);
    double settled = 0;
    for (const Reach& reach :
         {Reach{.radius = 0}, Reach{.radius = 0.2 * far}, Reach{.targets = 3},
          Reach{.radius = 0.1 * far}, Reach{.radius = 0.8 * far}}) {
      ASSERT_TRUE(computation->Advance(reach, checkpoint_).ok());
      const DistanceField field = computation->Field();
      EXPECT_GE(field.settled_radius, settled) << scene.name;
      settled = field.settled_radius;
      ExpectCertified(scene.name, field, whole);
    }
    ASSERT_TRUE(computation->Advance({}, checkpoint_).ok());
    const DistanceField field = computation->Field();
    EXPECT_EQ(field.settled_radius, kInfinity) << scene.name;
    EXPECT_EQ(AllDistances(field), AllDistances(whole)) << scene.name;
    // What is complete stays so.
    ASSERT_TRUE(computation->Advance({.radius = 1}, checkpoint_).ok());
    EXPECT_EQ(AllDistances(computation->Field()), AllDistances(whole));
  }
}

TEST_P(ComputationTest, TracedOneInStepsHasTheSameTrace) {
  for (const ComputationScene& scene : ComputationScenes()) {
    Query query = WithAlgorithm(scene.query);
    query.trace = true;
    const DistanceField whole = WholeField(*scene.mesh, query);
    const auto computation = StartOrFail(*scene.mesh, query);
    ASSERT_NE(computation, nullptr);
    ASSERT_TRUE(
        computation->Advance({.radius = Farthest(whole) / 2}, checkpoint_)
            .ok());
    const DistanceField half = computation->Field();
    for (uint32_t v = 0; v < scene.mesh->vertex_count(); ++v) {
      EXPECT_EQ(half.arrivals[v].pseudo_source == kNoPseudoSource,
                std::isinf(half.distances[v]))
          << scene.name << " " << v;
    }
    ASSERT_TRUE(computation->Advance({}, checkpoint_).ok());
    const DistanceField field = computation->Field();
    for (uint32_t v = 0; v < scene.mesh->vertex_count(); ++v) {
      EXPECT_EQ(field.arrivals[v].pseudo_source,
                whole.arrivals[v].pseudo_source)
          << scene.name << " " << v;
      EXPECT_EQ(field.arrivals[v].entry, whole.arrivals[v].entry);
    }
  }
}

TEST_P(ComputationTest, CancelledKeepsWhatIsCertifiedAndGoesOn) {
  const std::shared_ptr<const Mesh> mesh =
      BuildOrFail({"terrain", Terrain(40, 40, 1, 5)});
  ASSERT_NE(mesh, nullptr);
  const Query query =
      WithAlgorithm({.sources = {{VertexPoint{5}}},
                     .targets = {FacePoint{900, {0.25, 0.25, 0.5}}}});
  const DistanceField whole = WholeField(*mesh, query);
  for (const uint64_t poll : {0, 1, 2, 3}) {
    const auto computation = StartOrFail(*mesh, query);
    ASSERT_NE(computation, nullptr);
    StoppingCheckpoint stopping(poll);
    EXPECT_EQ(computation->Advance({}, stopping),
              absl::CancelledError("stopped here"));
    const DistanceField field = computation->Field();
    EXPECT_GE(field.settled_radius, stopping.settled_radius());
    EXPECT_LT(field.settled_radius, Farthest(whole));
    ExpectCertified("cancelled", field, whole);
    ASSERT_TRUE(computation->Advance({}, checkpoint_).ok());
    EXPECT_EQ(AllDistances(computation->Field()), AllDistances(whole));
  }
}

// Again and again, a poll at a time, it still comes to the end.
TEST_P(ComputationTest, CancelledOverAndOverComesToTheEnd) {
  const std::shared_ptr<const Mesh> mesh =
      BuildOrFail({"terrain", Terrain(24, 24, 1, 5)});
  ASSERT_NE(mesh, nullptr);
  const Query query = WithAlgorithm({.sources = {{VertexPoint{5}}}});
  const DistanceField whole = WholeField(*mesh, query);
  const auto computation = StartOrFail(*mesh, query);
  ASSERT_NE(computation, nullptr);
  int cancelled = 0;
  while (std::isfinite(computation->Field().settled_radius)) {
    StoppingCheckpoint stopping(1);
    EXPECT_EQ(computation->Advance({}, stopping),
              absl::CancelledError("stopped here"));
    ASSERT_LT(++cancelled, 1000);
    ExpectCertified("cancelled", computation->Field(), whole);
  }
  EXPECT_GT(cancelled, 2);
  EXPECT_EQ(AllDistances(computation->Field()), AllDistances(whole));
}

TEST_P(ComputationTest, AddedSourcesAreAsGoodAsThoseFromTheStart) {
  for (const ComputationScene& scene : ComputationScenes()) {
    Query query = WithAlgorithm(scene.query);
    const auto computation = StartOrFail(*scene.mesh, query);
    ASSERT_NE(computation, nullptr);
    ASSERT_TRUE(computation->Advance({}, checkpoint_).ok());
    const uint32_t faces = scene.mesh->face_count();
    const Triangle& last = scene.mesh->triangle(faces - 1);
    // One by one, of every kind; the fourth is too far off to matter.
    for (const Source& source :
         {Source{VertexPoint{last[0]}},
          Source{EdgePoint{last[1], last[2], 0.3}},
          Source{FacePoint{faces / 2, {0.5, 0.125, 0.375}}, 0.25},
          Source{VertexPoint{last[1]}, 1e6}}) {
      query.sources.push_back(source);
      ASSERT_TRUE(computation->AddSource(source).ok());
      // Nothing is certified until it has gone on.
      EXPECT_EQ(computation->Field().settled_radius, 0);
      ASSERT_TRUE(computation->Advance({}, checkpoint_).ok());
      EXPECT_TRUE(FieldsAgree({scene.name, query.sources, GetParam().name},
                              AllDistances(WholeField(*scene.mesh, query)),
                              AllDistances(computation->Field())));
    }
  }
}

// With a limit, and several at once.
TEST_P(ComputationTest, GoesOnWithAddedSourcesInSteps) {
  for (const ComputationScene& scene : ComputationScenes()) {
    Query query = WithAlgorithm(scene.query);
    const auto computation = StartOrFail(*scene.mesh, query);
    ASSERT_NE(computation, nullptr);
    ASSERT_TRUE(computation->Advance({}, checkpoint_).ok());
    query.sources.push_back({VertexPoint{2}});
    ASSERT_TRUE(computation->AddSource(query.sources.back()).ok());
    const DistanceField whole = WholeField(*scene.mesh, query);
    for (const double part : {0.1, 0.4}) {
      ASSERT_TRUE(
          computation->Advance({.radius = part * Farthest(whole)}, checkpoint_)
              .ok());
      ExpectCertified(scene.name, computation->Field(), whole);
    }
    ASSERT_TRUE(computation->Advance({}, checkpoint_).ok());
    EXPECT_TRUE(FieldsAgree({scene.name, query.sources, GetParam().name},
                            AllDistances(whole),
                            AllDistances(computation->Field())));
  }
}

TEST_P(ComputationTest, RefusesSourcesThatItCannotTake) {
  const std::shared_ptr<const Mesh> mesh =
      BuildOrFail({"icosphere", Icosphere(1)});
  ASSERT_NE(mesh, nullptr);
  Query query = WithAlgorithm({.sources = {{VertexPoint{3}}}});
  const auto computation = StartOrFail(*mesh, query);
  ASSERT_NE(computation, nullptr);
  // It has not come to its end.
  EXPECT_TRUE(
      absl::IsFailedPrecondition(computation->AddSource({VertexPoint{4}})));
  ASSERT_TRUE(computation->Advance({}, checkpoint_).ok());
  const std::vector<double> before = computation->Field().distances;
  for (const Source& source :
       {Source{VertexPoint{42}}, Source{VertexPoint{1}, std::nan("")},
        Source{VertexPoint{1}, -1}, Source{EdgePoint{0, 0, 0.5}},
        Source{FacePoint{80, {1, 0, 0}}}, Source{FacePoint{0, {0.5, 0.6, 0.7}}},
        Source{Curve{{VertexPoint{1}}}}}) {
    const absl::Status status = computation->AddSource(source);
    EXPECT_TRUE(absl::IsInvalidArgument(status)) << status;
  }
  EXPECT_EQ(computation->Field().distances, before);
  query.trace = true;
  const auto traced = StartOrFail(*mesh, query);
  ASSERT_NE(traced, nullptr);
  ASSERT_TRUE(traced->Advance({}, checkpoint_).ok());
  EXPECT_TRUE(absl::IsFailedPrecondition(traced->AddSource({VertexPoint{4}})));
}

GEODESIC_TEST_EVERY_ALGORITHM(ComputationTest);

}  // namespace
}  // namespace geodesic::test
