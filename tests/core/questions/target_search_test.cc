// Searches for targets find what whole fields of another algorithm say.

#include "geodesic/target_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "absl/strings/str_cat.h"
#include "tests/core/questions/path_check.h"
#include "tests/support/checkpoints.h"
#include "tests/support/field_check.h"
#include "tests/support/meshes/curved_meshes.h"
#include "tests/support/meshes/mesh_edits.h"
#include "tests/support/meshes/planar_meshes.h"
#include "tests/support/meshes/polyhedra.h"
#include "tests/support/queries.h"
#include "tests/support/random.h"
#include "tests/support/surface_points.h"

namespace geodesic::test {
namespace {

// Pairs and fields may differ by so much. Both are within some 1e-14 of the
// truth; a window that is missing makes a difference of 1e-6 and more.
constexpr double kPairTolerance = 1e-12;

// Distances of far places differ by next to nothing there.
TriangleSoup Squeezed(TriangleSoup soup, double factor) {
  for (Point& position : soup.positions) position[1] *= factor;
  return soup;
}

std::vector<NamedMesh> Surfaces() {
  std::vector<NamedMesh> meshes = {
      {"icosphere", Icosphere(4)},
      {"sphere by meridians", UvSphere(30, 24)},
      {"noisy torus", Torus({.around = 40, .across = 24, .noise = 0.15})},
      {"terrain", Terrain(40, 36, 1.5, 7)},
      // Ways of more edges than landmarks are good for.
      {"long terrain", Terrain(1000, 3, 1.5, 8)},
      {"box", BoxGrid(1, 2, 3, 6, 8, 10)},
      {"saddles", SaddleRow(20, 1e-9, 4)},
      {"hyperbolic", HyperbolicGrid(20, 20, 1e-3)},
      {"U-shaped grid", MakeGrid(UShape({.columns = 24, .rows = 24}))},
      {"two parts and loose vertices",
       AddIsolatedVertices(
           Join(Icosphere(3), RotateAndShift(Terrain(12, 12, 1, 3), 5)), 3)},
      {"needles",
       Squeezed(MakeGrid({.columns = 30, .rows = 6, .jitter = 0.3}), 1e-5)},
      {"a book", Book(MakeGrid({.columns = 8, .rows = 8}), 4)}};
  for (uint64_t seed = 1; seed <= 12; ++seed) {
    meshes.push_back({absl::StrCat("edited ", seed),
                      EditedMesh(seed, /*degenerate=*/seed % 3 == 0)});
  }
  return meshes;
}

class TargetSearchOn {
 public:
  explicit TargetSearchOn(const NamedMesh& named)
      : mesh_(BuildOrFail(named)), soup_(named.soup), search_(*mesh_) {}

  const Mesh& mesh() const { return *mesh_; }

  Landmarks MakeSome(uint32_t count) const {
    NoCheckpoint checkpoint;
    absl::StatusOr<Landmarks> made =
        MakeLandmarks(*mesh_, count, {}, checkpoint);
    EXPECT_TRUE(made.ok()) << made.status();
    return *std::move(made);
  }

  std::vector<double> Find(const Query& query, const Landmarks* landmarks) {
    NoCheckpoint checkpoint;
    const absl::StatusOr<TargetDistances> found =
        search_.Run(Valid(*mesh_, query), landmarks, checkpoint);
    EXPECT_TRUE(found.ok()) << found.status();
    return found.ok() ? found->distances : std::vector<double>();
  }

  // From fields, by another rule.
  std::vector<double> Expected(Query query) const {
    query.algorithm = Algorithm::kMmp;
    return SolveOrFail(*mesh_, query).target_distances;
  }

  // Expects the same from searches without landmarks and with some.
  void ExpectRight(const Query& query, const Landmarks& landmarks) {
    const std::vector<double> expected = Expected(query);
    const std::vector<double> found = Find(query, nullptr);
    const std::vector<double> with_landmarks = Find(query, &landmarks);
    ASSERT_EQ(found.size(), expected.size());
    ASSERT_EQ(with_landmarks.size(), expected.size());
    for (size_t t = 0; t < expected.size(); ++t) {
      SCOPED_TRACE(absl::StrCat("from ", Name(query.sources[0]), " to ",
                                Name(query.targets[t])));
      if (std::isinf(expected[t])) {
        EXPECT_EQ(found[t], expected[t]);
        EXPECT_EQ(with_landmarks[t], expected[t]);
        continue;
      }
      EXPECT_NEAR(found[t], expected[t], kPairTolerance * expected[t]);
      EXPECT_NEAR(with_landmarks[t], expected[t], kPairTolerance * expected[t]);
    }
  }

 private:
  const std::shared_ptr<const Mesh> mesh_;
  const TriangleSoup soup_;
  TargetSearch search_;
};

TEST(TargetSearch, FindsWhatFieldsSayBetweenVertices) {
  Random random(1);
  for (const NamedMesh& named : Surfaces()) {
    SCOPED_TRACE(named.name);
    TargetSearchOn search(named);
    const Landmarks landmarks = search.MakeSome(5);
    for (int i = 0; i < 8; ++i) {
      search.ExpectRight({.sources = {{RandomVertexPoint(named.soup, random)}},
                          .targets = {RandomVertexPoint(named.soup, random)}},
                         landmarks);
    }
  }
}

TEST(TargetSearch, FindsWhatFieldsSayBetweenAllKindsOfPoints) {
  Random random(2);
  for (const NamedMesh& named : Surfaces()) {
    SCOPED_TRACE(named.name);
    TargetSearchOn search(named);
    const Landmarks landmarks = search.MakeSome(3);
    for (int i = 0; i < 8; ++i) {
      Query query;
      for (int s = 0; s < 1 + i % 3; ++s) {
        query.sources.push_back({RandomSurfacePoint(named.soup, random)});
        query.sources.back().offset = i % 2 == 0 ? 0 : random.Uniform(0, 0.3);
      }
      for (int t = 0; t < 1 + i / 2; ++t) {
        query.targets.push_back(RandomSurfacePoint(named.soup, random));
      }
      search.ExpectRight(query, landmarks);
    }
  }
}

TEST(TargetSearch, FindsPathsThatAreHardlyLongerWithinATolerance) {
  Random random(7);
  for (const NamedMesh& named : Surfaces()) {
    SCOPED_TRACE(named.name);
    TargetSearchOn search(named);
    const Landmarks landmarks = search.MakeSome(4);
    for (int i = 0; i < 24; ++i) {
      Query query{.sources = {{RandomSurfacePoint(named.soup, random)}},
                  .targets = {RandomSurfacePoint(named.soup, random),
                              RandomVertexPoint(named.soup, random)},
                  .tolerance = std::pow(10, random.Uniform(-5, -1))};
      if (i % 4 == 0) query.sources[0].offset = random.Uniform(0, 1);
      if (i % 6 == 0) {
        query.sources = {{RandomVertexPoint(named.soup, random), 0.2},
                         {RandomVertexPoint(named.soup, random)}};
      }
      const std::vector<double> expected = search.Expected(query);
      const Landmarks none(search.mesh());
      for (const Landmarks* some : {&none, &landmarks}) {
        const std::vector<double> found = search.Find(query, some);
        ASSERT_EQ(found.size(), expected.size());
        for (size_t t = 0; t < expected.size(); ++t) {
          SCOPED_TRACE(absl::StrCat("from ", Name(query.sources[0]), " to ",
                                    Name(query.targets[t]), " within ",
                                    query.tolerance));
          if (std::isinf(expected[t])) {
            EXPECT_EQ(found[t], expected[t]);
            continue;
          }
          EXPECT_GE(found[t], expected[t] * (1 - kPairTolerance));
          EXPECT_LE(found[t], expected[t] * (1 + query.tolerance));
        }
      }
    }
  }
}

TEST(TargetSearch, TakesAPathThatIsGoodEnough) {
  const NamedMesh named{"terrain", Terrain(60, 60, 0.5, 7)};
  const auto mesh = BuildOrFail(named);
  Query query{.sources = {{VertexPoint{0}}},
              .targets = {VertexPoint{mesh->vertex_count() - 1}}};
  TargetSearch search(*mesh);
  NoCheckpoint checkpoint;
  const auto run = [&](double tolerance) {
    query.tolerance = tolerance;
    return *search.Run(Valid(*mesh, query), nullptr, checkpoint);
  };
  const TargetDistances exact = run(0);
  EXPECT_EQ(exact.certified_error, 0);
  // So little is computed exactly.
  EXPECT_EQ(run(1e-6).distances, exact.distances);
  EXPECT_EQ(run(1e-6).certified_error, 0);
  const TargetDistances near = run(0.1);
  EXPECT_EQ(near.certified_error, 0.1);
  EXPECT_LT(near.statistics.windows_propagated,
            exact.statistics.windows_propagated / 100);
}

TEST(TargetSearch, TracesShortestPaths) {
  Random random(5);
  for (const NamedMesh& named : Surfaces()) {
    SCOPED_TRACE(named.name);
    const auto mesh = BuildOrFail(named);
    TargetSearch search(*mesh);
    NoCheckpoint checkpoint;
    for (int i = 0; i < 6; ++i) {
      const ValidQuery query =
          Valid(*mesh, {.sources = {{RandomSurfacePoint(named.soup, random)}},
                        .targets = {RandomSurfacePoint(named.soup, random),
                                    RandomSurfacePoint(named.soup, random)},
                        .trace = i != 2});
      const TargetDistances found =
          search.Run(query, nullptr, checkpoint).value();
      if (!query->trace) {
        EXPECT_TRUE(found.paths.empty());
        continue;
      }
      ASSERT_EQ(found.paths.size(), 2);
      for (size_t t = 0; t < 2; ++t) {
        EXPECT_EQ(found.paths[t].distance, found.distances[t]);
        if (std::isinf(found.distances[t])) continue;
        EXPECT_TRUE(IsShortestPath(
            *mesh, found.paths[t], PointOf(query->sources[0]),
            query->targets[t], found.distances[t], {.check_bends = false}))
            << "to " << Name(query->targets[t]);
      }
    }
  }
}

// Where several faces meet, the way back from what a search has left of the
// field is lost now and then: on one in two hundred of these paths.
TEST(TargetSearch, TracesPathsThroughManySheets) {
  Random random(6);
  NoCheckpoint checkpoint;
  for (uint64_t seed = 1; seed <= 30; ++seed) {
    TriangleSoup soup = Book(MakeGrid({.columns = 6,
                                       .rows = 6,
                                       .diagonals = Diagonals::kRandom,
                                       .seed = seed}),
                             4);
    for (uint64_t layer = 0; layer < 4; ++layer) {
      soup = AddLayer(soup, soup.triangles.size() / 5, 0.3, 4 * seed + layer);
    }
    const auto mesh = BuildOrFail({"book", soup});
    const auto landmarks = MakeLandmarks(*mesh, 4, {}, checkpoint);
    ASSERT_TRUE(landmarks.ok()) << landmarks.status();
    TargetSearch search(*mesh);
    for (int i = 0; i < 30; ++i) {
      const ValidQuery query =
          Valid(*mesh, {.sources = {{RandomSurfacePoint(soup, random)}},
                        .targets = {RandomSurfacePoint(soup, random)},
                        .trace = true});
      const auto found = search.Run(query, &*landmarks, checkpoint);
      ASSERT_TRUE(found.ok()) << found.status() << ", seed " << seed;
      EXPECT_EQ(found->paths[0].distance, found->distances[0]);
      EXPECT_TRUE(IsShortestPath(*mesh, found->paths[0],
                                 PointOf(query->sources[0]), query->targets[0],
                                 found->distances[0], {.check_bends = false}))
          << Name(query->sources[0]) << " to " << Name(query->targets[0]);
    }
  }
}

// Windows wind round the needles on edge 0 - 1 so often that the search drops
// some, others than a field would.
TEST(TargetSearch, FindsTheWayAroundNeedlesOnOneEdge) {
  const std::vector<Triangle> faces = {
      {0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {6, 5, 0}, {7, 1, 8}, {1, 0, 8},
      {0, 7, 8}, {0, 5, 7}, {6, 4, 5}, {4, 9, 6}, {5, 10, 6}};
  const TriangleSoup needles = {
      {{2.4402932016105294e-08, -2.1493271145915391e-08, 2.000000020262735},
       {3.0000000486651666, 1.9999999986079811, -1.2783843264571558e-08},
       {-2.0000000108994103, 3.0000000154881881, -1.7182587950786631e-08},
       {1.9999999692550743, 2.9999999573600924, -1.8310484510554693e-08},
       {2.2499999820795415, 1.4999999606433545, 0.50000000763958052},
       {2.8125000221475198, 1.8749999706940188, 0.12500001279586492},
       {0.56249996264666158, 0.37499996045444711, 1.624999957349567},
       {1.7929687040496993, 1.1953125100815842, 0.80468752448621361},
       {1.4531249989926447, 0.96874995458362001, 1.0312500484782496},
       {2.249999973817058, 1.5000000008344847, 0.49999998298107995},
       {3.0000000496261743, 2.0000000373424616, 1.9447574285786772e-08}},
      faces};
  NoCheckpoint checkpoint;
  const auto mesh = BuildOrFail({"needles", needles});
  TargetSearch search(*mesh);
  for (uint32_t source = 0; source < mesh->vertex_count(); ++source) {
    const std::vector<double> field =
        SolveOrFail(*mesh, Algorithm::kFwpMmp, {{VertexPoint{source}}});
    for (uint32_t v = 0; v < mesh->vertex_count(); ++v) {
      const auto found =
          search.Run(Valid(*mesh, {.sources = {{VertexPoint{source}}},
                                   .targets = {VertexPoint{v}},
                                   .trace = true}),
                     nullptr, checkpoint);
      ASSERT_TRUE(found.ok())
          << found.status() << ", " << source << " to " << v;
      // Needles are 1e-8 high.
      EXPECT_NEAR(found->distances[0], field[v], 1e-7) << source << " to " << v;
    }
  }
}

// Windows of a search wind round these without end, those of a field do not.
TEST(TargetSearch, GivesWayToAFieldWhereWindowsWind) {
  const std::vector<Point> positions = {
      {1, 3, 2},       {2.7, 1.3, 2}, {1.5, 2.5, 2.001}, {3, 1, 1.9996},
      {2.6, 1.37, 2},  {3, 3, 2},     {3, 1, 2},         {0, 2, 0},
      {0.7, 1.8, 0.5}, {3, 1, 2},     {2.8, 1.2, 2},     {0.4, 1.9, 0.2}};
  const std::vector<Triangle> faces = {
      {0, 1, 2}, {0, 3, 1}, {2, 4, 5}, {6, 7, 8},  {2, 1, 4},  {4, 9, 5},
      {9, 3, 5}, {1, 2, 0}, {3, 1, 0}, {3, 1, 10}, {7, 8, 11}, {11, 3, 6}};
  const TriangleSoup needles = {positions, faces};
  const auto mesh = BuildOrFail({"needles", needles});
  NoCheckpoint checkpoint;
  const auto found = TargetSearch(*mesh)
                         .Run(Valid(*mesh, {.sources = {{VertexPoint{5}}},
                                            .targets = {VertexPoint{7}},
                                            .trace = true}),
                              nullptr, checkpoint)
                         .value();
  const std::vector<double> field =
      SolveOrFail(*mesh, Algorithm::kMmp, {{VertexPoint{5}}});
  EXPECT_NEAR(found.distances[0], field[7], 1e-12);
  EXPECT_LT(found.statistics.windows_propagated, 100'000);
}

// As programs export what is to be seen from both sides. A search knows too few
// distances to tell which of two faces at one place a path came through.
TEST(TargetSearch, FollowsPathsWhereEveryFaceHasABack) {
  Random random(5);
  for (const TriangleSoup& soup :
       {HyperbolicGrid(40, 40, 0.02), MakeGrid({.columns = 14, .rows = 14}),
        UvSphere(20, 12)}) {
    const TriangleSoup backed = AddBackFaces(soup);
    const auto front = BuildOrFail({"front", soup});
    const auto both = BuildOrFail({"both", backed});
    TargetSearch search(*both), in_front(*front);
    NoCheckpoint checkpoint;
    for (int i = 0; i < 40; ++i) {
      Query query{
          .sources = {{VertexPoint{random.Below(front->vertex_count())}}},
          .targets = {i % 2 == 0 ? RandomEdgePoint(soup, random)
                                 : RandomFacePoint(soup, random)},
          .trace = true};
      if (i % 3 == 0) {
        query.sources = {{RandomFacePoint(backed, random)}};
        query.targets = {RandomFacePoint(backed, random)};
      }
      const auto found = search.Run(Valid(*both, query), nullptr, checkpoint);
      ASSERT_TRUE(found.ok()) << i << ": " << found.status();
      EXPECT_TRUE(IsShortestPath(*both, found->paths[0],
                                 Canonicalize(PointOf(query.sources[0]), *both),
                                 Canonicalize(query.targets[0], *both),
                                 found->distances[0]))
          << i;
      if (i % 3 == 0) continue;
      const auto same =
          in_front.Run(Valid(*front, query), nullptr, checkpoint).value();
      EXPECT_NEAR(found->distances[0], same.distances[0],
                  1e-12 * same.distances[0]);
    }
  }
}

TEST(TargetSearch, GivesTheSameBitsAfterOtherSearches) {
  Random random(3);
  for (const NamedMesh& named : Surfaces()) {
    SCOPED_TRACE(named.name);
    TargetSearchOn used(named);
    const Landmarks landmarks = used.MakeSome(4);
    for (int i = 0; i < 4; ++i) {
      const Query query{.sources = {{RandomVertexPoint(named.soup, random)}},
                        .targets = {RandomSurfacePoint(named.soup, random)}};
      TargetSearchOn fresh(named);
      EXPECT_EQ(used.Find(query, &landmarks), fresh.Find(query, &landmarks));
    }
  }
}

TEST(TargetSearch, GoesOnAfterBeingStopped) {
  const NamedMesh named{"terrain", Terrain(60, 60, 1.5, 7)};
  const auto mesh = BuildOrFail(named);
  TargetSearch search(*mesh);
  const Query query{.sources = {{VertexPoint{0}}},
                    .targets = {VertexPoint{mesh->vertex_count() - 1}}};
  for (uint64_t polls = 0; polls < 4; ++polls) {
    RecordingCheckpoint stop(polls);
    const auto stopped = search.Run(Valid(*mesh, query), nullptr, stop);
    if (stopped.ok()) break;
    EXPECT_EQ(stopped.status().code(), absl::StatusCode::kCancelled);
  }
  NoCheckpoint checkpoint;
  const TargetDistances found =
      search.Run(Valid(*mesh, query), nullptr, checkpoint).value();
  const std::vector<double> field =
      SolveOrFail(*mesh, Algorithm::kMmp, query.sources);
  EXPECT_NEAR(found.distances[0], field.back(), kPairTolerance * field.back());
}

// What is far off the way is not looked at.
TEST(TargetSearch, PropagatesFewWindowsBesideAField) {
  const NamedMesh named{"terrain", Terrain(120, 120, 0.5, 7)};
  const auto mesh = BuildOrFail(named);
  TargetSearch search(*mesh);
  NoCheckpoint checkpoint;
  const Query query{.sources = {{VertexPoint{60 * 121 + 10}}},
                    .targets = {VertexPoint{60 * 121 + 110}}};
  const TargetDistances found =
      search.Run(Valid(*mesh, query), nullptr, checkpoint).value();
  const DistanceField field = SolveOrFail(*mesh, query);
  EXPECT_LT(found.statistics.windows_propagated,
            field.statistics.windows_propagated / 4);
}

// The straight line is far from the way, and little is left to choose from.
TEST(TargetSearch, PropagatesNoMoreThanAFieldAlongARibbon) {
  constexpr uint32_t kColumns = 1500;
  TriangleSoup ribbon = MakeGrid(
      {.columns = kColumns, .rows = 1, .diagonals = Diagonals::kAlternating});
  for (Point& p : ribbon.positions) {
    const double along = p[0] / kColumns;
    const double across = 0.04 * (p[1] - 0.5);
    p = {5 * along, across * std::cos(7 * along), across * std::sin(7 * along)};
  }
  const TargetSearchOn search({"ribbon", ribbon});
  const Query query{.sources = {{VertexPoint{0}}},
                    .targets = {VertexPoint{2 * kColumns + 1}}};
  const DistanceField field = SolveOrFail(search.mesh(), query);
  TargetSearch one(search.mesh());
  NoCheckpoint checkpoint;
  for (const uint32_t count : {0u, 8u}) {
    const Landmarks landmarks = search.MakeSome(count);
    const TargetDistances found =
        one.Run(Valid(search.mesh(), query), &landmarks, checkpoint).value();
    EXPECT_NEAR(found.distances[0], field.target_distances[0],
                kPairTolerance * field.target_distances[0]);
    EXPECT_LE(found.statistics.windows_propagated,
              field.statistics.windows_propagated);
  }
}

TEST(TargetSearch, PropagatesNothingWhereNoPathLeads) {
  const TriangleSoup ball = Icosphere(2);
  const auto mesh =
      BuildOrFail({"two balls", Join(ball, RotateAndShift(ball, 5))});
  const auto vertex = static_cast<uint32_t>(ball.positions.size());
  const auto face = static_cast<uint32_t>(ball.triangles.size());
  TargetSearch search(*mesh);
  NoCheckpoint checkpoint;
  const TargetDistances found =
      search
          .Run(Valid(*mesh, {.sources = {{VertexPoint{0}}},
                             .targets = {VertexPoint{vertex},
                                         FacePoint{face, {0.2, 0.3, 0.5}}}}),
               nullptr, checkpoint)
          .value();
  EXPECT_TRUE(std::isinf(found.distances[0]));
  EXPECT_TRUE(std::isinf(found.distances[1]));
  EXPECT_EQ(found.statistics.windows_propagated, 0);
}

TEST(TargetSearch, NeedsATarget) {
  const auto mesh = BuildOrFail({"icosphere", Icosphere(1)});
  TargetSearch search(*mesh);
  NoCheckpoint checkpoint;
  EXPECT_EQ(search
                .Run(Valid(*mesh, {.sources = {{VertexPoint{0}}}}), nullptr,
                     checkpoint)
                .status()
                .code(),
            absl::StatusCode::kInvalidArgument);
}

TEST(Landmarks, BoundDistancesFromBelow) {
  Random random(4);
  for (const NamedMesh& named : Surfaces()) {
    SCOPED_TRACE(named.name);
    const TargetSearchOn search(named);
    const Mesh& mesh = search.mesh();
    const Landmarks landmarks = search.MakeSome(Landmarks::kMost);
    for (int i = 0; i < 12; ++i) {
      const SurfacePoint target = RandomSurfacePoint(named.soup, random);
      const Landmarks::Place place = landmarks.PlaceOf(target, mesh);
      const std::vector<double> field =
          SolveOrFail(mesh, Algorithm::kMmp, {{target}});
      for (uint32_t v = 0; v < mesh.vertex_count(); ++v) {
        EXPECT_LE(
            std::ldexp(landmarks.LowerBound(v, place), mesh.scale_exponent()),
            field[v])
            << v << " from " << Name(target);
      }
    }
  }
}

TEST(Landmarks, AreTwoStepsTooLowAtTheMost) {
  const auto mesh =
      BuildOrFail({"two parts", Join(Icosphere(3), Terrain(9, 9, 1, 3))});
  Landmarks landmarks(*mesh);
  std::vector<std::vector<double>> fields;
  for (int i = 0; i < 6; ++i) {
    ASSERT_TRUE(landmarks.next().has_value());
    fields.push_back(SolveOrFail(*mesh, Algorithm::kMmp,
                                 {{VertexPoint{*landmarks.next()}}}));
    landmarks.Add(*mesh, fields.back());
  }
  const double unit = std::ldexp(1.0, mesh->scale_exponent());
  const double slack = 2.01 * landmarks.step() * unit;
  for (uint32_t t = 0; t < mesh->vertex_count(); t += 7) {
    const Landmarks::Place place = landmarks.PlaceOf(VertexPoint{t}, *mesh);
    for (uint32_t v = 0; v < mesh->vertex_count(); ++v) {
      const double bound = landmarks.LowerBound(v, place) * unit;
      if (std::isinf(fields[0][t]) && std::isinf(fields[0][v])) {
        EXPECT_EQ(bound, 0);
        continue;
      }
      double best = 0;
      for (const std::vector<double>& field : fields) {
        best = std::max(best, std::abs(field[t] - field[v]));
      }
      EXPECT_GE(bound, best - slack) << v << " from " << t;
    }
  }
}

// Where the way from the landmark is short beside the edges around.
TEST(Landmarks, BoundDistancesOfPlacesBesideThem) {
  const NamedMesh named{"terrain", Terrain(12, 12, 1, 3)};
  const auto mesh = BuildOrFail(named);
  Random random(6);
  for (uint32_t landmark = 0; landmark < mesh->vertex_count(); ++landmark) {
    Landmarks landmarks(*mesh);
    landmarks.Add(
        *mesh, SolveOrFail(*mesh, Algorithm::kMmp, {{VertexPoint{landmark}}}));
    for (const HalfEdge h : mesh->Outgoing(landmark)) {
      const double t = std::pow(10, random.Uniform(-12, -2));
      const SurfacePoint target = EdgePoint{landmark, mesh->To(h), t};
      EXPECT_LE(
          landmarks.LowerBound(landmark, landmarks.PlaceOf(target, *mesh)),
          t * mesh->frame(h).length)
          << Name(target);
    }
  }
}

}  // namespace
}  // namespace geodesic::test
