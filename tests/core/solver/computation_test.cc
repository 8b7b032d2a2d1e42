// Computations that stop at a radius or at targets and go on: after a limit,
// after a cancellation, with more sources. What they say in the end is what one
// computation says at once.

#include "geodesic/computation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "tests/core/exactness/every_algorithm.h"
#include "tests/support/checkpoints.h"
#include "tests/support/meshes/curved_meshes.h"
#include "tests/support/meshes/mesh_edits.h"
#include "tests/support/meshes/planar_meshes.h"
#include "tests/support/surface_points.h"

namespace geodesic::test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// A certified distance may improve by roundings, no more.
constexpr double kRoundings = 1e-12;

// Questions on meshes with ties, curvature, needles and boundaries, from
// sources of every kind.
struct ComputationScene {
  std::string name;
  std::shared_ptr<const Mesh> mesh;
  Query query;  // with targets; the algorithm is to be set
};

ComputationScene MakeScene(std::string name, const TriangleSoup& soup,
                           Query query) {
  Random random(7);
  query.targets.push_back(RandomVertexPoint(soup, random));
  for (int i = 0; i < 4; ++i) {
    query.targets.push_back(RandomEdgePoint(soup, random));
    query.targets.push_back(RandomFacePoint(soup, random));
  }
  std::shared_ptr<const Mesh> mesh = BuildOrFail({name, soup});
  return {std::move(name), std::move(mesh), std::move(query)};
}

// Some hundred faces each.
std::vector<ComputationScene> ComputationScenes() {
  const TriangleSoup grid = MakeGrid({.columns = 14, .rows = 12});
  const TriangleSoup sphere = Icosphere(2);
  const TriangleSoup needles =
      InsertNeedles(Torus({.around = 16, .across = 10, .noise = 0.1}), 30, 5);
  const TriangleSoup bay = MakeGrid(UShape({.columns = 12, .rows = 12}));
  const TriangleSoup pieces =
      AddIsolatedVertices(Join(Terrain(10, 10, 1.5, 3), Icosphere(1)), 2);
  Random random(11);
  std::vector<ComputationScene> scenes;
  // Every distance from a corner occurs twice or more.
  scenes.push_back(MakeScene("grid", grid, {.sources = {{VertexPoint{0}}}}));
  scenes.push_back(
      MakeScene("icosphere", sphere,
                {.sources = {{FacePoint{3, {0.25, 0.25, 0.5}}, 0.125}}}));
  scenes.push_back(
      MakeScene("torus with needles", needles,
                {.sources = {{VertexPoint{9}, 0.25},
                             {RandomEdgePoint(needles, random)},
                             {Curve{RandomCurve(needles, 4, random)}}}}));
  scenes.push_back(
      MakeScene("U", bay,
                {.sources = {{Curve{RandomCurve(bay, 5, random)}, 0.5},
                             {Curve{RandomCurve(bay, 3, random)}}}}));
  scenes.push_back(MakeScene("pieces", pieces,
                             {.sources = {{VertexPoint{17}},
                                          {RandomFacePoint(pieces, random)},
                                          {VertexPoint{60}, 1}}}));
  return scenes;
}

// Fails the test unless `field` has the distances of `whole` up to its settled
// radius, +infinity beyond it and nothing else.
void ExpectCertified(const std::string& context, const DistanceField& field,
                     const DistanceField& whole) {
  const std::vector<double> got = AllDistances(field);
  const std::vector<double> expected = AllDistances(whole);
  ASSERT_EQ(got.size(), expected.size()) << context;
  const double radius = field.settled_radius;
  for (size_t i = 0; i < got.size(); ++i) {
    if (expected[i] > radius * (1 + kRoundings) || std::isinf(expected[i])) {
      EXPECT_EQ(got[i], kInfinity) << context << ": " << i << " is at "
                                   << expected[i] << ", beyond " << radius;
    } else if (expected[i] < radius * (1 - kRoundings) ||
               std::isfinite(got[i])) {
      EXPECT_NEAR(got[i], expected[i], kRoundings * expected[i])
          << context << ": " << i << ", settled radius " << radius;
    }
  }
}

class ComputationTest : public EveryAlgorithm {
 protected:
  static std::unique_ptr<Computation> Start(const Mesh& mesh,
                                            const Query& query) {
    return StartComputation(mesh, Valid(mesh, query), {}).value();
  }

  // The field when it has come so far.
  DistanceField Advance(Computation& computation, const Reach& reach) {
    EXPECT_TRUE(computation.Advance(reach, checkpoint_).ok());
    return computation.Field();
  }

  NoCheckpoint checkpoint_;
};

// On a plane, where the answer is Euclid's.
TEST_P(ComputationTest, IsExactUpToTheRadiusAndAbsentBeyond) {
  const TriangleSoup grid = MakeGrid({.columns = 14, .rows = 12});
  const auto mesh = BuildOrFail({"grid", grid});
  // At 5 lie the vertices (5, 0), (4, 3), (3, 4) and (0, 5).
  const Query query = Ask(
      {.sources = {{VertexPoint{0}}},
       .targets = {VertexPoint{5}, VertexPoint{4 * 15 + 3}, VertexPoint{6}}});
  for (const double radius : {0.0, 0.5, 1.0, 5.0, 7.3, 100.0}) {
    const auto computation = Start(*mesh, query);
    const DistanceField field = Advance(*computation, {.radius = radius});
    EXPECT_GE(field.settled_radius, radius);
    if (radius < 7) {
      EXPECT_EQ(field.settled_radius, radius);
    }
    const auto expect = [&](double got, double distance) {
      if (std::abs(distance - radius) < 1e-12) return;  // a tie
      if (distance > radius) {
        EXPECT_EQ(got, kInfinity) << distance << " within " << radius;
      } else {
        EXPECT_NEAR(got, distance, 1e-12) << "within " << radius;
      }
    };
    for (uint32_t v = 0; v < mesh->vertex_count(); ++v) {
      expect(field.distances[v], static_cast<double>(Distance(
                                     grid.positions[0], grid.positions[v])));
    }
    expect(field.target_distances[0], 5);
    expect(field.target_distances[1], 5);
    expect(field.target_distances[2], 6);
  }
}

TEST_P(ComputationTest, StopsWhenSoManyTargetsAreCertified) {
  for (const ComputationScene& scene : ComputationScenes()) {
    const Query query = Ask(scene.query);
    const DistanceField whole = SolveOrFail(*scene.mesh, query);
    for (const uint64_t wanted : {0, 1, 4, 9}) {
      const auto computation = Start(*scene.mesh, query);
      const DistanceField field = Advance(*computation, {.targets = wanted});
      uint64_t certified = 0;
      for (const double d : field.target_distances) {
        certified += std::isfinite(d) ? 1 : 0;
      }
      // All that can be reached may be fewer.
      EXPECT_TRUE(certified >= wanted || field.settled_radius == kInfinity)
          << scene.name << ": " << certified << " of " << wanted;
      ExpectCertified(scene.name, field, whole);
    }
  }
}

// Windows propagated stand for time: they are counted, not measured.
TEST_P(ComputationTest, CostsWhatItCovers) {
  const TriangleSoup terrain = Terrain(36, 36, 1, 7);
  const auto mesh = BuildOrFail({"terrain", terrain});
  // In the middle; so is the target.
  const Query query = Ask({.sources = {{VertexPoint{18 * 37 + 18}}},
                           .targets = {VertexPoint{18 * 37 + 20}}});
  const uint64_t whole =
      SolveOrFail(*mesh, query).statistics.windows_propagated;
  // An eighth of the area; a queue that knows no order may do more, but not
  // everything.
  for (const Reach reach : {Reach{.radius = 7}, Reach{.targets = 1}}) {
    const auto computation = Start(*mesh, query);
    EXPECT_LT(Advance(*computation, reach).statistics.windows_propagated,
              whole * 4 / 5);
  }
}

TEST_P(ComputationTest, NegativeAndUndefinedRadiiAreRefused) {
  const auto mesh = BuildOrFail({"icosphere", Icosphere(1)});
  const Query query = Ask({.sources = {{VertexPoint{3}}}});
  const auto computation = Start(*mesh, query);
  for (const double radius : {-1.0, -kInfinity, std::nan("")}) {
    const absl::Status status =
        computation->Advance({.radius = radius}, checkpoint_);
    EXPECT_TRUE(absl::IsInvalidArgument(status)) << status;
    EXPECT_THAT(std::string(status.message()),
                testing::HasSubstr("reach.radius"));
  }
  // No harm done.
  ASSERT_TRUE(computation->Advance({}, checkpoint_).ok());
  EXPECT_EQ(computation->Field().distances,
            SolveOrFail(*mesh, query).distances);
}

TEST_P(ComputationTest, InStepsIsBitForBitWhatItIsAtOnce) {
  for (const ComputationScene& scene : ComputationScenes()) {
    const Query query = Ask(scene.query);
    const DistanceField whole = SolveOrFail(*scene.mesh, query);
    const double far = FarthestOf(AllDistances(whole));
    const auto computation = Start(*scene.mesh, query);
    double settled = 0;
    // One is a distance that occurs: a tie with the radius.
    for (const Reach& reach :
         {Reach{.radius = 0}, Reach{.radius = 0.1 * far}, Reach{.targets = 3},
          Reach{.radius = 0.05 * far}, Reach{.radius = whole.distances[40]},
          Reach{.radius = 0.55 * far}, Reach{.radius = 0.8 * far}}) {
      const DistanceField field = Advance(*computation, reach);
      EXPECT_GE(field.settled_radius, settled) << scene.name;
      if (reach.targets == Reach().targets) {
        EXPECT_GE(field.settled_radius, reach.radius) << scene.name;
      }
      settled = field.settled_radius;
      ExpectCertified(scene.name, field, whole);
    }
    const DistanceField field = Advance(*computation, {});
    EXPECT_EQ(field.settled_radius, kInfinity) << scene.name;
    EXPECT_EQ(AllDistances(field), AllDistances(whole)) << scene.name;
    // What is complete stays so.
    EXPECT_EQ(AllDistances(Advance(*computation, {.radius = 1})),
              AllDistances(whole));
  }
}

TEST_P(ComputationTest, TracedOneInStepsHasTheSameTrace) {
  for (const ComputationScene& scene : ComputationScenes()) {
    Query query = Ask(scene.query);
    query.trace = true;
    const DistanceField whole = SolveOrFail(*scene.mesh, query);
    const auto computation = Start(*scene.mesh, query);
    const DistanceField half =
        Advance(*computation, {.radius = FarthestOf(AllDistances(whole)) / 2});
    for (uint32_t v = 0; v < scene.mesh->vertex_count(); ++v) {
      EXPECT_EQ(half.arrivals[v].pseudo_source == kNoPseudoSource,
                std::isinf(half.distances[v]))
          << scene.name << " " << v;
    }
    const DistanceField field = Advance(*computation, {});
    for (uint32_t v = 0; v < scene.mesh->vertex_count(); ++v) {
      EXPECT_EQ(field.arrivals[v].pseudo_source,
                whole.arrivals[v].pseudo_source)
          << scene.name << " " << v;
      EXPECT_EQ(field.arrivals[v].entry, whole.arrivals[v].entry);
    }
  }
}

TEST_P(ComputationTest, CancelledKeepsWhatIsCertifiedAndGoesOn) {
  const auto mesh = BuildOrFail({"terrain", Terrain(40, 40, 1, 5)});
  const Query query = Ask({.sources = {{VertexPoint{5}}},
                           .targets = {FacePoint{900, {0.25, 0.25, 0.5}}}});
  const DistanceField whole = SolveOrFail(*mesh, query);
  for (const uint64_t poll : {0, 1, 2, 3}) {
    const auto computation = Start(*mesh, query);
    RecordingCheckpoint stopping(poll);
    EXPECT_EQ(computation->Advance({}, stopping),
              RecordingCheckpoint::Stopped());
    const DistanceField field = computation->Field();
    EXPECT_GE(field.settled_radius, stopping.polls().back().settled_radius);
    EXPECT_LT(field.settled_radius, FarthestOf(AllDistances(whole)));
    ExpectCertified("cancelled", field, whole);
    EXPECT_EQ(AllDistances(Advance(*computation, {})), AllDistances(whole));
  }
}

// Again and again, a poll at a time, it still comes to the end.
TEST_P(ComputationTest, CancelledOverAndOverComesToTheEnd) {
  const auto mesh = BuildOrFail({"terrain", Terrain(24, 24, 1, 5)});
  const Query query = Ask({.sources = {{VertexPoint{5}}}});
  const DistanceField whole = SolveOrFail(*mesh, query);
  const auto computation = Start(*mesh, query);
  int cancelled = 0;
  while (std::isfinite(computation->Field().settled_radius)) {
    RecordingCheckpoint stopping(1);
    EXPECT_EQ(computation->Advance({}, stopping),
              RecordingCheckpoint::Stopped());
    ASSERT_LT(++cancelled, 1000);
    ExpectCertified("cancelled", computation->Field(), whole);
  }
  EXPECT_GT(cancelled, 2);
  EXPECT_EQ(AllDistances(computation->Field()), AllDistances(whole));
}

TEST_P(ComputationTest, AddedSourcesAreAsGoodAsThoseFromTheStart) {
  for (const ComputationScene& scene : ComputationScenes()) {
    Query query = Ask(scene.query);
    const auto computation = Start(*scene.mesh, query);
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
      EXPECT_TRUE(FieldsAgree({scene.name, query.sources, GetParam().name},
                              AllDistances(SolveOrFail(*scene.mesh, query)),
                              AllDistances(Advance(*computation, {}))));
    }
  }
}

// With a limit, and several at once.
TEST_P(ComputationTest, GoesOnWithAddedSourcesInSteps) {
  for (const ComputationScene& scene : ComputationScenes()) {
    Query query = Ask(scene.query);
    const auto computation = Start(*scene.mesh, query);
    ASSERT_TRUE(computation->Advance({}, checkpoint_).ok());
    query.sources.push_back({VertexPoint{2}});
    ASSERT_TRUE(computation->AddSource(query.sources.back()).ok());
    const DistanceField whole = SolveOrFail(*scene.mesh, query);
    for (const double part : {0.1, 0.4}) {
      const double radius = part * FarthestOf(AllDistances(whole));
      ExpectCertified(scene.name, Advance(*computation, {.radius = radius}),
                      whole);
    }
    EXPECT_TRUE(FieldsAgree({scene.name, query.sources, GetParam().name},
                            AllDistances(whole),
                            AllDistances(Advance(*computation, {}))));
  }
}

TEST_P(ComputationTest, RefusesSourcesThatItCannotTake) {
  const auto mesh = BuildOrFail({"icosphere", Icosphere(1)});
  Query query = Ask({.sources = {{VertexPoint{3}}}});
  const auto computation = Start(*mesh, query);
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
  const auto traced = Start(*mesh, query);
  ASSERT_TRUE(traced->Advance({}, checkpoint_).ok());
  EXPECT_TRUE(absl::IsFailedPrecondition(traced->AddSource({VertexPoint{4}})));
}

GEODESIC_TEST_EVERY_ALGORITHM(ComputationTest);

}  // namespace
}  // namespace geodesic::test
