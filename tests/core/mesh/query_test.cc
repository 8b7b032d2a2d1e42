#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "geodesic/solve.h"
#include "geodesic/valid_query.h"
#include "geodesic_types/field_path.h"
#include "gmock/gmock.h"
#include "gtest/gtest.h"
#include "tests/support/meshes/planar_meshes.h"

namespace geodesic {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

// Ten vertices in two rows of five, eight faces.
std::shared_ptr<const Mesh> Strip() {
  return *Mesh::Build(test::MakeGrid({.columns = 4, .rows = 1}));
}

// What is refused: its path, and why.
struct Refusal {
  std::string path;
  std::string message;
};

Refusal RefusalOf(const Query& query) {
  const absl::Status status = ValidQuery::Make(query, *Strip()).status();
  EXPECT_EQ(status.code(), absl::StatusCode::kInvalidArgument) << status;
  return {FieldPathOf(status).value_or(""), std::string(status.message())};
}

Refusal RefusalOf(const SurfacePoint& point) {
  return RefusalOf(Query{.sources = {{VertexPoint{0}}, {point}}});
}

// The message begins with the path and goes on with `why`.
MATCHER_P2(Refuses, path, why, "") {
  return arg.path == path && arg.message.starts_with(path) &&
         arg.message.find(why) != std::string::npos;
}

TEST(QueryTest, RefusalsNameTheSource) {
  EXPECT_THAT(RefusalOf(Query{}), Refuses("sources", "is empty"));
  EXPECT_THAT(RefusalOf(VertexPoint{10}),
              Refuses("sources[1].vertex",
                      "10 is out of range: the mesh has "
                      "10 vertices, numbered from 0"));
  for (double offset : {-1.0, kInfinity, kNan}) {
    EXPECT_THAT(RefusalOf(Query{.sources = {{VertexPoint{3}, offset}}}),
                Refuses("sources[0].offset", "not a finite number >= 0"));
  }
  EXPECT_THAT(RefusalOf(Query{.sources = {{VertexPoint{0}}},
                              .algorithm = Algorithm(99)}),
              Refuses("algorithm", "unknown"));
}

// The strip is 4 long. Far larger offsets leave no digits for its distances.
TEST(QueryTest, OffsetsAreBoundedByTheSizeOfTheMesh) {
  EXPECT_TRUE(
      ValidQuery::Make({.sources = {{VertexPoint{3}, 1e6}}}, *Strip()).ok());
  for (double offset : {1e7, 2e272}) {
    EXPECT_THAT(RefusalOf(Query{.sources = {{VertexPoint{3}, offset}}}),
                Refuses("sources[0].offset", "size of the mesh"));
  }
}

TEST(QueryTest, RefusalsNamePointsOffTheSurface) {
  EXPECT_THAT(RefusalOf(EdgePoint{10, 0, 0.5}),
              Refuses("sources[1].edge.from", "10 is out of range"));
  EXPECT_THAT(RefusalOf(EdgePoint{0, 10, 0.5}),
              Refuses("sources[1].edge.to", "10 is out of range"));
  EXPECT_THAT(RefusalOf(EdgePoint{0, 4, 0.5}),
              Refuses("sources[1].edge", "no edge between vertices 0 and 4"));
  for (double t : {-0.1, 1.1, kNan}) {
    EXPECT_THAT(RefusalOf(EdgePoint{0, 1, t}),
                Refuses("sources[1].edge.t", "not within [0, 1]"));
  }
  EXPECT_THAT(RefusalOf(FacePoint{8, {1, 0, 0}}),
              Refuses("sources[1].face.face", "8 is out of range"));
  EXPECT_THAT(RefusalOf(FacePoint{2, {-0.1, 0.6, 0.5}}),
              Refuses("sources[1].face.weights[0]", "outside face 2"));
  EXPECT_THAT(RefusalOf(FacePoint{2, {0, kNan, 0.5}}),
              Refuses("sources[1].face.weights[1]", "outside face 2"));
  EXPECT_THAT(RefusalOf(FacePoint{2, {0.5, 0.5, 0.5}}),
              Refuses("sources[1].face.weights", "sum to 1.5, not to 1"));
  EXPECT_THAT(RefusalOf(FacePoint{2, {0.3, 0.3, 0.400003}}),
              Refuses("sources[1].face.weights", "sum to 1.000003, not to 1"));
}

TEST(QueryTest, WeightsMayHaveSixDigits) {
  for (const FacePoint& point :
       {FacePoint{2, {0.333333, 0.333333, 0.333333}},
        FacePoint{2, {0.166667, 0.166667, 0.666667}}}) {
    const absl::Status status =
        ValidQuery::Make(Query{.sources = {{point}}}, *Strip()).status();
    EXPECT_TRUE(status.ok()) << status;
  }
}

TEST(QueryTest, RefusalsNameCurvesAndTargets) {
  const auto after_a_point = [](Curve curve, double offset = 0) {
    return RefusalOf(
        Query{.sources = {{VertexPoint{0}}, {std::move(curve), offset}}});
  };
  EXPECT_THAT(after_a_point({}),
              Refuses("sources[1].curve.points", "is empty"));
  EXPECT_THAT(after_a_point({{VertexPoint{0}, VertexPoint{10}}}),
              Refuses("sources[1].curve.points[1].vertex", "10 is out of"));
  const Refusal apart = after_a_point({{VertexPoint{0}, VertexPoint{4}}});
  EXPECT_EQ(apart.path, "sources[1].curve.points[1]");
  EXPECT_THAT(apart.message, HasSubstr("sources[1].curve.points[0] and [1] lie "
                                       "in no common face"));
  EXPECT_THAT(after_a_point({{VertexPoint{0}}}, kNan),
              Refuses("sources[1].offset", "not a finite number"));
  EXPECT_THAT(RefusalOf(Query{.sources = {{VertexPoint{0}}},
                              .targets = {VertexPoint{0}, VertexPoint{11}}}),
              Refuses("targets[1].vertex", "11 is out of range"));
}

TEST(QueryTest, EveryListedAlgorithmIsValidAndKnownByName) {
  const auto mesh = Strip();
  for (const AlgorithmInfo& info : kAlgorithms) {
    EXPECT_TRUE(
        ValidQuery::Make(
            {.sources = {{VertexPoint{9}}}, .algorithm = info.algorithm}, *mesh)
            .ok());
    EXPECT_EQ(*AlgorithmFromName(info.name), info.algorithm);
    EXPECT_EQ(AlgorithmName(info.algorithm), info.name);
  }
  EXPECT_THAT(std::string(AlgorithmFromName("dijkstra").status().message()),
              HasSubstr("fwp-ch"));
}

Source At(uint32_t vertex, double offset = 0) {
  return {VertexPoint{vertex}, offset};
}

TEST(QueryTest, AValidQueryHasWhatWasGivenInCanonicalForm) {
  const auto mesh = Strip();
  const Triangle corners = mesh->triangle(3);
  const Source curve = {
      Curve{{FacePoint{3, {0, 1, 0}}, VertexPoint{corners[2]}}}, 2};
  const absl::StatusOr<ValidQuery> query =
      ValidQuery::Make({.sources = {At(5, 2), curve, At(1, -0.0), At(5, 1)},
                        .targets = {EdgePoint{1, 0, 0}, VertexPoint{7}}},
                       *mesh);
  ASSERT_TRUE(query.ok()) << query.status();
  const Source canonical = {
      Curve{{VertexPoint{corners[1]}, VertexPoint{corners[2]}}}, 2};
  EXPECT_THAT((*query)->sources,
              ElementsAre(At(5, 2), canonical, At(1, 0), At(5, 1)));
  EXPECT_FALSE(std::signbit((*query)->sources[2].offset));
  EXPECT_THAT((*query)->targets, ElementsAre(SurfacePoint(VertexPoint{1}),
                                             SurfacePoint(VertexPoint{7})));
}

TEST(QueryTest, SortingKeepsTheLeastOffsetAndCurvesAsTheyCome) {
  const auto mesh = Strip();
  const Source first{Curve{{VertexPoint{6}}}}, second{Curve{{VertexPoint{2}}}};
  const auto sorted = [&](std::vector<Source> sources) {
    return ValidQuery::Make({.sources = std::move(sources)}, *mesh)->Sorted();
  };
  const SortedQuery one =
      sorted({At(5, 2), first, At(1), At(5, 1), At(1), second, At(3)});
  EXPECT_THAT(one.query->sources,
              ElementsAre(At(1), At(3), At(5, 1), first, second));
  EXPECT_THAT(one.numbers, ElementsAre(2, 6, 3, 1, 5));
  EXPECT_EQ(one.query, sorted({first, At(3), At(5, 1), second, At(1)}).query);
  EXPECT_NE(one.query, sorted({second, At(3), At(5, 1), first, At(1)}).query);
}

TEST(QueryTest, PartsOfAQuestion) {
  const auto mesh = Strip();
  const absl::StatusOr<ValidQuery> query = ValidQuery::Make(
      {.sources = {At(1), {EdgePoint{0, 1, 0.5}, 2}},
       .targets = {VertexPoint{1}, EdgePoint{0, 1, 0.25}, VertexPoint{2}},
       .algorithm = Algorithm::kFwpCh,
       .trace = true},
      *mesh);
  ASSERT_TRUE(query.ok()) << query.status();
  EXPECT_EQ((*query)->algorithm, Algorithm::kFwpMmp);
  EXPECT_THAT(query->WithoutVertexTargets()->targets,
              ElementsAre(SurfacePoint(EdgePoint{0, 1, 0.25})));
  EXPECT_FALSE(query->WithTrace(false)->trace);
  EXPECT_EQ(query->WithTrace(false).WithTrace(true), *query);
  const ValidQuery alone = query->DistancesAlone();
  EXPECT_EQ(alone->sources, (*query)->sources);
  EXPECT_TRUE(alone->targets.empty());
  EXPECT_FALSE(alone->trace);
  const ValidQuery second = query->OfSource(1, *mesh);
  EXPECT_THAT(second->sources, ElementsAre((*query)->sources[1]));
  EXPECT_EQ(second->targets, (*query)->targets);
  // What was asked for, which several sources do not allow.
  EXPECT_EQ(second->algorithm, Algorithm::kFwpCh);
}

// Where Chen and Han's rule does not hold, the MMP rule takes its place.
TEST(QueryTest, TheAlgorithmGivesWayWhereItDoesNotHold) {
  using enum Algorithm;
  const auto grid = *Mesh::Build(test::MakeGrid({.columns = 4, .rows = 4}));
  const Source in_face{FacePoint{3, {0.2, 0.3, 0.5}}}, at_vertex = At(1);
  // A corner of a face is a vertex, however it is named.
  const Source at_corner{FacePoint{2, {0, 1, 0}}};
  const Source curve{Curve{{VertexPoint{0}, VertexPoint{1}}}};
  struct Case {
    std::vector<Source> sources;
    Algorithm asked, runs;
  };
  for (const auto& [sources, asked, runs] :
       {Case{{in_face}, kFwpList, kFwpList},
        {{at_vertex, in_face}, kFwpList, kFwpList},
        {{at_vertex}, kFwpCh, kFwpCh},
        {{at_vertex, At(7)}, kFwpCh, kFwpCh},
        {{in_face}, kFwpCh, kFwpCh},
        {{at_vertex, at_corner}, kCh, kCh},
        // Rays may pass a source.
        {{in_face, at_vertex}, kFwpCh, kFwpMmp},
        {{curve}, kIch, kMmp},
        {{curve}, kFwpList, kFwpMmp},
        {{in_face}, kCh, kMmp}}) {
    const Query query{.sources = sources, .algorithm = asked};
    EXPECT_EQ((*ValidQuery::Make(query, *grid))->algorithm, runs)
        << AlgorithmName(asked) << " of " << sources.size();
    NoCheckpoint checkpoint;
    EXPECT_EQ(Solve(*grid, query, {}, checkpoint)->algorithm, runs);
  }
}

TEST(QueryTest, TheAlgorithmGivesWayOnMeshesWhereItDoesNotHold) {
  const auto book = *Mesh::Build(
      {.positions = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {-1, 0, 0}, {0, 0, 1}},
       .triangles = {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}});
  const auto without_area =
      *Mesh::Build({.positions = {{0, 0, 0}, {2, 0, 0}, {1, 0, 0}, {1, 1, 0}},
                    .triangles = {{0, 2, 1}, {0, 1, 3}}});
  EXPECT_TRUE(without_area->HasCollapsedFaces());
  EXPECT_FALSE(Strip()->HasCollapsedFaces());
  for (const auto& mesh : {book, without_area}) {
    for (const AlgorithmInfo& info : kAlgorithms) {
      const auto query = ValidQuery::Make(
          {.sources = {At(1)}, .algorithm = info.algorithm}, *mesh);
      const bool holds = mesh == book && info.algorithm == Algorithm::kFwpList;
      EXPECT_EQ((*query)->algorithm,
                holds ? info.algorithm : WithTrimming(info.algorithm));
    }
  }
}

TEST(QueryTest, CanonicalPointsLieOnTheLowestElement) {
  const auto mesh = Strip();
  const auto canonical = [&](const SurfacePoint& point) {
    return Canonicalize(point, *mesh);
  };
  const Triangle corners = mesh->triangle(3);
  EXPECT_EQ(canonical(FacePoint{3, {0, 1, 0}}),
            SurfacePoint(VertexPoint{corners[1]}));
  EXPECT_EQ(canonical(EdgePoint{1, 0, 0}), SurfacePoint(VertexPoint{1}));
  EXPECT_EQ(canonical(EdgePoint{1, 0, 1}), SurfacePoint(VertexPoint{0}));
  // 1 - t rounds to 1, or the point cannot be told from the vertex.
  EXPECT_EQ(canonical(EdgePoint{1, 0, 1e-17}), SurfacePoint(VertexPoint{1}));
  EXPECT_EQ(canonical(EdgePoint{0, 1, 1e-200}), SurfacePoint(VertexPoint{0}));
  EXPECT_EQ(canonical(FacePoint{3, {1e-200, 1, 1e-200}}),
            SurfacePoint(VertexPoint{corners[1]}));
  EXPECT_EQ(canonical(EdgePoint{1, 0, 0.25}),
            SurfacePoint(EdgePoint{0, 1, 0.75}));
  const auto on_edge =
      std::get<EdgePoint>(canonical(FacePoint{3, {0.25, 0, 0.75}}));
  EXPECT_EQ(on_edge.t, on_edge.from == corners[0] ? 0.75 : 0.25);
  EXPECT_EQ(canonical(FacePoint{3, {0.25, 0.25, 0.5}}),
            SurfacePoint(FacePoint{3, {0.25, 0.25, 0.5}}));
}

TEST(QueryTest, PositionsAreThoseOfTheWeights) {
  const auto mesh = Strip();
  const auto& p = mesh->positions();
  const Triangle t = mesh->triangle(5);
  const Point at = PositionOf(FacePoint{5, {0.5, 0.25, 0.25}}, *mesh);
  for (int i = 0; i < 3; ++i) {
    EXPECT_DOUBLE_EQ(at[i],
                     0.5 * p[t[0]][i] + 0.25 * p[t[1]][i] + 0.25 * p[t[2]][i]);
  }
}

}  // namespace
}  // namespace geodesic
